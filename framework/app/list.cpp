#include <algorithm>
#include <map>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/commands.h"

namespace moire::app {

namespace {

using Entries = std::vector<std::pair<std::string, std::string>>;

struct Section {
  std::string title;
  Entries entries;  // name and summary
};

Entries plugins(const Session& session, Kind kind) {
  Entries entries;
  for (const Plugin* plugin : session.catalog.all(kind)) entries.emplace_back(plugin->name, plugin->summary());
  return entries;
}

Entries passes(std::span<const PassDescription* const> descriptions) {
  Entries entries;
  for (const PassDescription* pass : descriptions) entries.emplace_back(pass->name, pass->summary);
  return entries;
}

Entries options(std::span<const NamedSummary> named) {
  Entries entries;
  for (const NamedSummary& one : named) entries.emplace_back(one.name, one.summary);
  return entries;
}

std::vector<Section> sections(const Session& session) {
  return {{"samplers", plugins(session, Kind::sampler)},    {"scenes", plugins(session, Kind::scene)},
          {"metrics", passes(session.vocabulary.metrics)},  {"pictures", passes(session.vocabulary.pictures)},
          {"lookups", options(session.vocabulary.lookups)}, {"filters", options(session.vocabulary.filters)}};
}

SceneChoice scene_choice(const Plugin& plugin) { return {plugin.name, &plugin, Settings(plugin.parameters())}; }

SamplerChoice sampler_choice(const Plugin& plugin) {
  return {plugin.name, &plugin, Settings(plugin.parameters()), std::string(plugin.sampler->lookup)};
}

// One line of what runs, and one for each thing that some scenes do not have.
void print_pairs(const Session& session) {
  fmt::print("\nwhich sampler runs on which scene (with default settings)\n");
  for (const Plugin* sampler : session.catalog.all(Kind::sampler)) {
    std::vector<std::string_view> run;
    std::map<std::string, std::vector<std::string_view>> refused;
    for (const Plugin* scene : session.catalog.all(Kind::scene)) {
      const std::string missing = missing_for(scene_choice(*scene), sampler_choice(*sampler), session.vocabulary);
      (missing.empty() ? run : refused[missing]).push_back(scene->name);
    }
    fmt::print("  {:<16} {}\n", sampler->name, run.empty() ? "none" : fmt::format("{}", fmt::join(run, " ")));
    for (const auto& [missing, scenes] : refused)
      fmt::print("  {:<16} not {}: no {}\n", "", fmt::join(scenes, ", "), missing);
  }
}

nlohmann::ordered_json as_json_object(const Session& session, const std::vector<Section>& all) {
  nlohmann::ordered_json json;
  for (const Section& section : all) {
    for (const auto& [name, summary] : section.entries)
      json[section.title].push_back({{"name", name}, {"summary", summary}});
  }
  for (const Plugin* sampler : session.catalog.all(Kind::sampler)) {
    for (const Plugin* scene : session.catalog.all(Kind::scene)) {
      const std::string why_not = mismatch(scene_choice(*scene), sampler_choice(*sampler), session.vocabulary);
      json["pairs"].push_back(
          {{"sampler", sampler->name}, {"scene", scene->name}, {"runs", why_not.empty()}, {"why_not", why_not}});
    }
  }
  return json;
}

}  // namespace

int list(const Session& session, const std::string& what, bool as_json) {
  std::vector<Section> shown = sections(session);
  if (!what.empty()) std::erase_if(shown, [&](const Section& s) { return s.title != what; });
  if (as_json) {
    fmt::print("{}\n", as_json_object(session, shown).dump(2));
    return done;
  }
  for (const Section& section : shown) {
    fmt::print("{}{}\n", &section == &shown.front() ? "" : "\n", section.title);
    for (const auto& [name, summary] : section.entries) fmt::print("  {:<16} {}\n", name, summary);
  }
  if (what.empty()) print_pairs(session);
  return done;
}

}  // namespace moire::app
