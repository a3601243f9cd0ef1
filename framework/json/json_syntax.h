// Says in plain words why a text is not JSON.
#pragma once

#include <string>
#include <string_view>

namespace moire {

// Where nlohmann's parser gave up.
struct SyntaxError {
  std::string_view read, rest;   // the text up to there, and what follows
  std::string_view token;        // what it was reading
  std::string_view explanation;  // its own words
  bool is_in_list = false;       // the innermost open bracket is [
  int open_since = 0;            // its line; 0: none is open
};

std::string syntax_problem(const SyntaxError& error);

}  // namespace moire
