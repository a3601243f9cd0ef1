// The edge of the module: what is thrown inside leaves as a message.
#pragma once

#include <exception>
#include <string>

#include <fmt/format.h>

#include <moire/error.h>

namespace moire {

// Runs body(), which throws an Error that names the file, or whatever the libraries below throw.
template <class Body>
void keep_exceptions_inside(const char* file, std::string& problem, Body&& body) noexcept {
  try {
    body();
  } catch (const Error& error) {
    problem = error.what();
  } catch (const std::exception& error) {
    problem = fmt::format("{}: {}", file, error.what());
  }
}

// OpenImageIO's messages have several lines and may be missing.
inline std::string one_line(std::string text) {
  while (!text.empty() && text.back() == '\n') text.pop_back();
  for (char& c : text) {
    if (c == '\n') c = ',';
  }
  return text.empty() ? "no reason given" : text;
}

}  // namespace moire
