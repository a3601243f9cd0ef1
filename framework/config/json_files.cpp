// Finds, reads and merges JSON files.
#include "config/json_files.h"

#include <fstream>
#include <iterator>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <moire/error.h>

namespace moire {
namespace fs = std::filesystem;

namespace {

fs::path project_root(fs::path folder) {
  std::error_code ignored;
  for (;; folder = folder.parent_path()) {
    if (fs::is_directory(folder / "configs", ignored)) return folder;
    if (folder == folder.parent_path()) return {};
  }
}

// The members of `under` that `over` lacks. Objects of one key are merged, too.
void merge_under(JsonNode& over, JsonNode&& under) {
  for (JsonMember& member : under.members) {
    JsonNode* own = over.find(member.key);
    if (own == nullptr) {
      over.members.push_back(std::move(member));
    } else if (own->is(JsonKind::object) && member.value.is(JsonKind::object)) {
      merge_under(*own, std::move(member.value));
    }
  }
}

// The file that `use` names, or an empty path.
fs::path used_file(const JsonNode& use, const std::string& path, const ExperimentPlace& place, Problems& problems) {
  if (!use.is(JsonKind::text)) {
    problems.add(use.place, path, fmt::format("is {}; \"use\" takes the path of a JSON file", shown(use)));
    return {};
  }
  std::string looked;
  for (const fs::path& folder : {use.place.source->folder, place.root}) {
    if (folder.empty()) continue;
    const fs::path file = (folder / use.text).lexically_normal();
    std::error_code ignored;
    if (fs::is_regular_file(file, ignored)) return file;
    looked += (looked.empty() ? "" : ", ") + place.as_given(file).string();
  }
  problems.add(use.place, path, fmt::format("is {}, but there is no such file (looked for {})", shown(use), looked));
  return {};
}

std::optional<JsonNode> read_used(const JsonNode& use, const std::string& path, std::string_view entry,
                                  const ExperimentPlace& place, Problems& problems) {
  const fs::path file = used_file(use, path, place, problems);
  if (file.empty()) return std::nullopt;
  const auto source = std::make_shared<Source>(Source{place.as_given(file).string(), file.parent_path(), true, true});
  std::optional<JsonNode> tree;
  try {
    tree = parse_json(read_text(file), source, entry, problems);
  } catch (const Error& error) {
    problems.add(use.place, path, error.what());
  }
  if (!tree) return std::nullopt;
  if (!tree->is(JsonKind::object)) {
    problems.add(tree->place, entry, fmt::format("is {}; a used file holds an object", shown(*tree)));
    return std::nullopt;
  }
  if (const JsonNode* again = tree->find("use")) {
    problems.add(again->place, path, "a used file cannot use another; write its members here");
    return std::nullopt;
  }
  return tree;
}

}  // namespace

fs::path ExperimentPlace::as_given(const fs::path& absolute) const {
  return file.is_absolute() ? absolute : absolute.lexically_proximate(fs::current_path());
}

ExperimentPlace find_experiment(const fs::path& path) {
  std::error_code ignored;
  const bool is_folder = fs::is_directory(path, ignored);
  const fs::path file = is_folder ? path / "experiment.json" : path;
  if (!fs::is_regular_file(file, ignored)) {
    throw Error(is_folder
                    ? fmt::format("{}: has no experiment.json; an experiment is a JSON file, or a folder with one "
                                  "of that name",
                                  path.string())
                    : fmt::format("{}: no such file or folder; an experiment is a JSON file, or a folder with an "
                                  "experiment.json",
                                  path.string()));
  }
  const fs::path folder = fs::absolute(file).lexically_normal().parent_path();
  return {file, folder, project_root(folder)};
}

std::string read_text(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  if (!in) throw Error(fmt::format("{}: cannot be read; check its permissions", file.string()));
  return text;
}

void resolve_use(JsonNode& entry, std::string_view path, const ExperimentPlace& place, Problems& problems) {
  const JsonNode* use = entry.find("use");
  if (use == nullptr) return;
  std::optional<JsonNode> tree = read_used(*use, member_path(path, "use"), path, place, problems);
  if (!tree) {
    entry.kind = JsonKind::broken;
    return;
  }
  std::erase_if(entry.members, [](const JsonMember& member) { return member.key == "use"; });
  merge_under(entry, std::move(*tree));
}

}  // namespace moire
