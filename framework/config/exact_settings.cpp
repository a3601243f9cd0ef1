#include "config/exact_settings.h"

#include <fmt/format.h>

namespace moire {

namespace {

Value value_of(const Parameter& parameter, std::string_view text) {
  switch (parameter.type) {
    case Type::flag:
      return text == "true";
    case Type::integer:
      return std::int64_t{std::stoll(std::string(text))};
    case Type::real:
      return std::stod(std::string(text));
    default:
      return std::string(text);
  }
}

}  // namespace

Settings exact_settings(const ScenePlugin& scene, Settings settings) {
  for (const Parameter& parameter : scene.parameters) {
    if (!parameter.exact.empty()) settings.set(parameter.name, value_of(parameter, parameter.exact));
  }
  return settings;
}

std::string exact_note(const ScenePlugin& scene, const Settings& settings) {
  const Settings exact = exact_settings(scene, settings);
  std::string note;
  for (const Parameter& parameter : scene.parameters) {
    if (exact.values().find(parameter.name)->second == settings.values().find(parameter.name)->second) continue;
    note += fmt::format("{}{}={}", note.empty() ? "" : ", ", parameter.name, parameter.exact);
  }
  return note;
}

}  // namespace moire
