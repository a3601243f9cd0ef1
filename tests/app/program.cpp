#include "app/program.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <system_error>
#include <thread>

namespace moire::test {

namespace {

namespace fs = std::filesystem;

// libpng leaves OpenImageIO by a jump where an image is damaged, past the end of texts, which are lost then. The unit
// tests look for leaks.
const std::string sanitizer_options = "ASAN_OPTIONS=detect_leaks=0";

std::vector<std::string> environment(const Environment& more) {
  std::vector<std::string> variables{sanitizer_options};
  for (char** entry = environ; *entry; ++entry) {
    const std::string variable = *entry;
    if (!variable.starts_with("MOIRE_") && !variable.starts_with("ASAN_OPTIONS=") &&
        !more.contains(variable.substr(0, variable.find('='))))
      variables.push_back(variable);
  }
  for (const auto& [name, value] : more) variables.push_back(name + "=" + value);
  return variables;
}

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> result;
  for (std::string& text : texts) result.push_back(text.data());
  result.push_back(nullptr);
  return result;
}

void redirect(const char* file, int stream) {
  const int opened = open(file, O_WRONLY | O_CREAT | O_TRUNC, 0600);
  if (opened < 0 || dup2(opened, stream) < 0) _exit(126);
}

}  // namespace

Running::Running(const fs::path& folder, const std::vector<std::string>& arguments, const Environment& more) {
  std::vector<std::string> command{MOIRE_PROGRAM}, variables = environment(more);
  command.insert(command.end(), arguments.begin(), arguments.end());
  const std::vector<char*> argv = pointers(command), envp = pointers(variables);
  const std::string out = streams_.path() / "out", err = streams_.path() / "err";
  process_ = fork();
  if (process_ < 0) throw std::system_error(errno, std::generic_category(), "fork");
  if (process_ > 0) return;
  redirect(out.c_str(), STDOUT_FILENO);
  redirect(err.c_str(), STDERR_FILENO);
  if (chdir(folder.c_str()) == 0) execve(argv[0], argv.data(), envp.data());
  _exit(127);
}

Running::~Running() {
  if (process_ == 0) return;
  kill(process_, SIGKILL);
  waitpid(process_, nullptr, 0);
}

bool Running::wait_for(std::string_view text) {
  using namespace std::chrono_literals;
  for (const auto begin = std::chrono::steady_clock::now(); std::chrono::steady_clock::now() - begin < 60s;) {
    if (bytes_of(streams_.path() / "err").find(text) != std::string::npos) return true;
    siginfo_t ended{};
    waitid(P_PID, static_cast<id_t>(process_), &ended, WEXITED | WNOHANG | WNOWAIT);
    if (ended.si_pid != 0) return false;
    std::this_thread::sleep_for(5ms);
  }
  return false;
}

void Running::interrupt() const { kill(process_, SIGINT); }

Ended Running::wait() {
  int status = 0;
  waitpid(process_, &status, 0);
  process_ = 0;
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), bytes_of(streams_.path() / "out"),
          bytes_of(streams_.path() / "err")};
}

std::string without_references(const std::string& err) {
  std::string result;
  for (std::size_t begin = 0; begin < err.size();) {
    const std::size_t end = std::min(err.find('\n', begin), err.size() - 1) + 1;
    const std::string line = err.substr(begin, end - begin);
    if (line.find(": reference ") == std::string::npos) result += line;
    begin = end;
  }
  return result;
}

fs::path Desk::file(const fs::path& name, std::string_view bytes) const {
  fs::create_directories((path() / name).parent_path());
  return folder_.file(name.string(), bytes);
}

std::map<std::string, std::string> Desk::files(const fs::path& name) const {
  std::map<std::string, std::string> result;
  for (const auto& entry : fs::recursive_directory_iterator(path() / name)) {
    if (!entry.is_directory()) result[entry.path().lexically_relative(path() / name)] = bytes_of(entry.path());
  }
  return result;
}

}  // namespace moire::test
