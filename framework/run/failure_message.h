// What went wrong, as a person can use it, whatever was thrown.
#pragma once

#include <exception>
#include <string>

namespace moire {

std::string failure_message(const std::exception_ptr& thrown);

}  // namespace moire
