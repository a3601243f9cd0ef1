// What a person sees of a run on stderr: one line that is kept up to date on a terminal, a line a job otherwise.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace moire {

class Progress {
 public:
  // `steps`: jobs and other pieces of work in all.
  explicit Progress(std::size_t steps);
  ~Progress();  // leaves the terminal's line empty

  // The piece of work that begins now, in a few words.
  void begin(const std::string& what);
  // How much of it is done, 0 .. 1.
  void advance(double share);
  void end();
  // Pieces of work that will not be done.
  void skip(std::size_t steps) { done_ += steps; }
  // A message of its own line.
  void note(const std::string& text);

 private:
  void draw(double share) const;

  std::size_t steps_, done_ = 0;
  bool terminal_;
  std::string what_;
  std::chrono::steady_clock::time_point start_;
};

// "40 s", "3 min", "2 h 5 min".
std::string rough_duration(double seconds);

}  // namespace moire
