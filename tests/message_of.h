// The message of the moire::Error that a body throws, for comparison as a whole.
#pragma once

#include <string>

#include <moire/error.h>

namespace moire::test {

template <class Body>
std::string message_of(Body&& body) {
  try {
    body();
  } catch (const Error& error) {
    return error.what();
  }
  return "(no error)";
}

}  // namespace moire::test
