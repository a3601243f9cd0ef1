#include "run/progress.h"

#include <cmath>
#include <cstdio>

#include <unistd.h>

#include <fmt/format.h>

namespace moire {

std::string rough_duration(double seconds) {
  if (seconds < 90) return fmt::format("{:.0f} s", std::ceil(seconds));
  const auto minutes = static_cast<long>(std::ceil(seconds / 60));
  if (minutes < 90) return fmt::format("{} min", minutes);
  return fmt::format("{} h {} min", minutes / 60, minutes % 60);
}

Progress::Progress(std::size_t steps)
    : steps_(steps), terminal_(isatty(STDERR_FILENO) != 0), start_(std::chrono::steady_clock::now()) {}

Progress::~Progress() {
  if (terminal_) fmt::print(stderr, "\r\033[K");
}

void Progress::begin(const std::string& what) {
  what_ = what;
  if (terminal_) {
    draw(0);
  } else {
    fmt::print(stderr, "[{}/{}] {}\n", done_ + 1, steps_, what_);
  }
}

void Progress::advance(double share) {
  if (terminal_) draw(share);
}

void Progress::end() { ++done_; }

void Progress::note(const std::string& text) {
  if (terminal_) fmt::print(stderr, "\r\033[K");
  fmt::print(stderr, "{}\n", text);
}

void Progress::draw(double share) const {
  const double done = (static_cast<double>(done_) + share) / static_cast<double>(steps_);
  const double spent = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  const std::string left =
      done > 0.02 && spent > 1 ? fmt::format(", {} left", rough_duration(spent * (1 - done) / done)) : "";
  fmt::print(stderr, "\r\033[K[{}/{}] {:.0f} %{}: {}", done_ + 1, steps_, 100 * done, left, what_);
  std::fflush(stderr);
}

}  // namespace moire
