// Tables made from the vocabulary.
#include "config/experiment_format.h"

#include <algorithm>

namespace moire::format {

std::string lookup_choices(const Vocabulary& vocabulary) {
  std::string choices;
  for (const NamedSummary& lookup : vocabulary.lookups) {
    if (!choices.empty()) choices += ' ';
    choices += lookup.name;
  }
  return choices;
}

std::vector<Parameter> parameters_of(const Plugin& plugin, std::string_view lookups) {
  std::vector<Parameter> table(plugin.parameters().begin(), plugin.parameters().end());
  if (plugin.sampler) {
    table.push_back(
        parameter::choice("lookup", plugin.sampler->lookup, lookups, "how a hit on a texture becomes colour"));
  }
  return table;
}

std::vector<std::string_view> words(std::string_view choices) {
  std::vector<std::string_view> result;
  while (!choices.empty()) {
    const std::string_view word = choices.substr(0, choices.find(' '));
    if (!word.empty()) result.push_back(word);
    choices.remove_prefix(std::min(choices.size(), word.size() + 1));
  }
  return result;
}

}  // namespace moire::format
