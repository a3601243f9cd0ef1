// The program as a user runs it.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "temporary_folder.h"

namespace moire::test {

using Environment = std::map<std::string, std::string>;

// How a command ended, and all that it wrote.
struct Ended {
  int code;  // of its exit; 128 + the signal's number if one ended it
  std::string out, err;
};

// Standard error of a run without the lines on references, which have numbers in them.
std::string without_references(const std::string& err);

// A command at work.
class Running {
 public:
  // `folder`: where it runs. Of MOIRE_... it sees only what `more` sets.
  Running(const std::filesystem::path& folder, const std::vector<std::string>& arguments, const Environment& more = {});
  ~Running();
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;

  // Until stderr has this text. False: the command ended without it, or a minute went by.
  bool wait_for(std::string_view text);
  void interrupt() const;  // as Ctrl-C does
  Ended wait();

 private:
  TemporaryFolder streams_;
  pid_t process_ = 0;  // 0: has been waited for
};

// A folder in which commands run, with the experiments that tests write into it.
class Desk {
 public:
  Ended moire(const std::vector<std::string>& arguments, const Environment& more = {}) const {
    return Running(path(), arguments, more).wait();
  }
  const std::filesystem::path& path() const { return folder_.path(); }

  std::filesystem::path file(const std::filesystem::path& name, std::string_view bytes) const;
  std::string bytes(const std::filesystem::path& name) const { return bytes_of(path() / name); }
  // Every file below `name` with its bytes, by its path from there.
  std::map<std::string, std::string> files(const std::filesystem::path& name) const;

 private:
  TemporaryFolder folder_;
};

}  // namespace moire::test
