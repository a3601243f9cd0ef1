// Collects the plugins of the folders, and all that is wrong with them.
#include "loading/catalog.h"

#include <algorithm>
#include <tuple>

#include <fmt/format.h>

#include <moire/error.h>

#include "loading/opening.h"
#include "loading/record.h"

namespace moire {

namespace {

namespace fs = std::filesystem;

// What is wrong, a line each, to be thrown together.
class Messages {
 public:
  void add(const std::string& message) { text_ += (text_.empty() ? "" : "\n") + message; }

  // Notes down the Error that body() may throw.
  template <class Body>
  void collect(Body&& body) {
    try {
      body();
    } catch (const Error& error) {
      add(error.what());
    }
  }

  void throw_if_any() const {
    if (!text_.empty()) throw Error(text_);
  }

 private:
  std::string text_;
};

std::vector<fs::path> libraries_in(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> files;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    if (entry->path().extension() == ".so") files.push_back(entry->path());
  }
  if (error) {
    throw Error(fmt::format("{}: plugins cannot be looked for ({}); name a folder that can be read", folder.string(),
                            error.message()));
  }
  std::sort(files.begin(), files.end());
  return files;
}

// A file that may be opened.
struct Candidate {
  fs::path file;
  Record record;
};

bool same_plugin(const Record& a, const Record& b) {
  return a.kind == b.kind && std::string_view(a.name) == std::string_view(b.name);
}

void require_new(const std::vector<Candidate>& others, const Candidate& candidate) {
  const auto other = std::find_if(others.begin(), others.end(),
                                  [&](const Candidate& o) { return same_plugin(o.record, candidate.record); });
  if (other == others.end()) return;
  throw Error(fmt::format("{}: is a second {} \"{}\" (the first is {}); remove or rename one of them",
                          candidate.file.string(), candidate.record.kind == Kind::sampler ? "sampler" : "scene",
                          candidate.record.name, other->file.string()));
}

std::vector<Candidate> candidates_in(std::span<const fs::path> folders, Messages& problems) {
  std::vector<Candidate> candidates;
  const auto consider = [&](const fs::path& file) {
    const Candidate candidate{file, read_record(file)};
    require_new(candidates, candidate);
    candidates.push_back(candidate);
  };
  for (const fs::path& folder : folders) {
    problems.collect([&] {
      for (const fs::path& file : libraries_in(folder)) problems.collect([&] { consider(file); });
    });
  }
  return candidates;
}

}  // namespace

Catalog Catalog::open(std::span<const fs::path> folders) {
  Messages problems;
  Catalog catalog;
  for (const Candidate& candidate : candidates_in(folders, problems)) {
    problems.collect([&] { catalog.plugins_.push_back(open_plugin(candidate.file, candidate.record)); });
  }
  problems.throw_if_any();
  std::sort(catalog.plugins_.begin(), catalog.plugins_.end(),
            [](const Plugin& a, const Plugin& b) { return std::tie(a.name, a.kind) < std::tie(b.name, b.kind); });
  return catalog;
}

const Plugin* Catalog::find(Kind kind, std::string_view name) const {
  const auto found = std::find_if(plugins_.begin(), plugins_.end(),
                                  [&](const Plugin& plugin) { return plugin.kind == kind && plugin.name == name; });
  return found == plugins_.end() ? nullptr : &*found;
}

std::vector<const Plugin*> Catalog::all(Kind kind) const {
  std::vector<const Plugin*> found;
  for (const Plugin& plugin : plugins_) {
    if (plugin.kind == kind) found.push_back(&plugin);
  }
  return found;
}

}  // namespace moire
