// Writes and reads the experiments of these tests.
#include "experiment_folder.h"

#include <algorithm>

#include "message_of.h"
#include "vocabulary.h"

namespace moire::test {

std::string experiment_with(const std::vector<std::string>& lines) {
  std::vector<std::string> all = {R"("question": "Which is best?")", R"("image": {"width": 64, "height": 48})",
                                  R"("scenes": ["heightfield"])", R"("samplers": ["point"])"};
  for (const std::string& line : lines) {
    const std::string key = line.substr(0, line.find(':'));
    const auto same = std::find_if(all.begin(), all.end(), [&](const auto& other) { return other.starts_with(key); });
    if (same != all.end()) {
      *same = line;
    } else {
      all.push_back(line);
    }
  }
  std::string text = "{";
  for (const std::string& line : all) text += (text == "{" ? "\n  " : ",\n  ") + line;
  return text + "\n}\n";
}

ExperimentFolder::ExperimentFolder() {
  for (const char* name : {"configs", "data", "edges"}) std::filesystem::create_directory(path() / name);
}

Experiment ExperimentFolder::read(std::string_view text, const Overrides& overrides) const {
  file("edges/experiment.json", text);
  return read_experiment(path() / "edges", vocabulary(), overrides);
}

std::string ExperimentFolder::problems(std::string_view text, const Overrides& overrides) const {
  std::string message = message_of([&] { read(text, overrides); });
  const std::string prefix = path().string() + "/";
  for (std::size_t at = message.find(prefix); at != std::string::npos; at = message.find(prefix)) {
    message.erase(at, prefix.size());
  }
  return message;
}

}  // namespace moire::test
