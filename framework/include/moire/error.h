// The one exception of moire: a message for a person.
#pragma once

#include <stdexcept>
#include <string>

namespace moire {

// The message reads `where: what is wrong (what was found); what would be right`.
class __attribute__((visibility("default"))) Error : public std::runtime_error {
 public:
  explicit Error(const std::string& message) : std::runtime_error(message) {}
  Error(const Error&) = default;
  Error& operator=(const Error&) = default;
  ~Error() override;
};

}  // namespace moire
