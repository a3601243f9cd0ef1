// What a command writes to its standard output, and how it ended.
#pragma once

#include <sys/wait.h>

#include <cstdio>
#include <string>

namespace moire::test {

inline std::string output_of(const std::string& command) {
  std::string output;
  FILE* const pipe = popen(command.c_str(), "r");
  for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) output += static_cast<char>(c);
  const int status = pclose(pipe);
  return output + "exit " + (WIFEXITED(status) ? std::to_string(WEXITSTATUS(status)) : "by a signal");
}

}  // namespace moire::test
