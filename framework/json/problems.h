// What is wrong with a JSON file: collected while it is read, so that all of it is reported at once.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace moire {

// A text that JSON comes from: a file, or a --set of the command line.
struct Source {
  std::string shown;             // as the user gave it
  std::filesystem::path folder;  // that relative paths start from; absolute
  bool has_lines = true;
  bool is_shared = false;  // other entries of the experiment may use it, too
};

struct Place {
  std::shared_ptr<const Source> source;
  int line = 0;  // 0: the source has no lines
};

// A text as JSON has it, cut if it is long.
std::string in_quotes(std::string_view text);

// Paths inside the JSON: "scenes[0]" and "view" make "scenes[0].view". Keys that are no words are put in quotes.
std::string member_path(std::string_view path, std::string_view key);
std::string item_path(std::string_view path, std::size_t index);

// `file:line: path: what`. An empty path means the whole file.
std::string problem_at(const Place& place, std::string_view path, std::string_view what);

class Problems {
 public:
  // A fault that is there already counts once; one of a shared file is named for the first entry that uses it.
  void add(const Place& place, std::string_view path, std::string_view what);

  void append(const Problems& more) { problems_.insert(problems_.end(), more.problems_.begin(), more.problems_.end()); }

  bool empty() const { return problems_.empty(); }
  // Error: all problems, a line each, by file and line. Nothing if there are none.
  void throw_if_any() const;

 private:
  struct Problem {
    std::string source;
    int line;
    std::string fault;  // what it is known by
    std::string text;
  };
  std::vector<Problem> problems_;
};

}  // namespace moire
