// Filters scenes and samplers by name.
#include "config/only.h"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include "json/nearest_name.h"

namespace moire {
namespace {

void keep(std::string_view name, std::string_view noun, std::vector<Choice>& choices, const Place& place,
          Problems& problems) {
  if (name.empty()) return;
  std::vector<Choice> kept;
  std::copy_if(choices.begin(), choices.end(), std::back_inserter(kept),
               [&](const Choice& choice) { return choice.name == name || choice.plugin->name == name; });
  if (kept.empty()) {
    std::vector<std::string_view> names;
    for (const Choice& choice : choices) names.push_back(choice.name);
    problems.add(place, "",
                 fmt::format("the experiment has no {} \"{}\"{} it has {}", noun, name, did_you_mean(name, names),
                             listed(names)));
  }
  choices = std::move(kept);
}

}  // namespace

void keep_only(const std::string& only, std::vector<Choice>& scenes, std::vector<Choice>& samplers,
               Problems& problems) {
  if (only.empty()) return;
  const Place place{std::make_shared<Source>(Source{"--only " + only, {}, false}), 0};
  const std::size_t slash = only.find('/');
  if (slash == std::string::npos)
    return problems.add(place, "", "has no \"/\"; write --only SCENE/SAMPLER, where one may be empty");
  keep(std::string_view(only).substr(0, slash), "scene", scenes, place, problems);
  keep(std::string_view(only).substr(slash + 1), "sampler", samplers, place, problems);
}

}  // namespace moire
