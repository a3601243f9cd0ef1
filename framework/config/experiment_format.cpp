// Tables made from the vocabulary.
#include "config/experiment_format.h"

#include <algorithm>

namespace moire::format {

namespace {

std::string joined(std::span<const NamedSummary> named) {
  std::string names;
  for (const NamedSummary& one : named) {
    if (!names.empty()) names += ' ';
    names += one.name;
  }
  return names;
}

}  // namespace

OptionNames::OptionNames(const Vocabulary& vocabulary)
    : lookups(joined(vocabulary.lookups)), filters(joined(vocabulary.filters)) {}

bool takes_filters(const SamplerPlugin& sampler) { return sampler.make_points || sampler.takes_filters; }

std::vector<Parameter> parameters_of(const Plugin& plugin, const Vocabulary& vocabulary, const OptionNames& names) {
  std::vector<Parameter> table(plugin.parameters().begin(), plugin.parameters().end());
  if (!plugin.sampler) return table;
  const auto add = [&](const Parameter& choice, std::span<const NamedSummary> named) {
    table.push_back(choice);
    for (const NamedSummary& one : named) table.insert(table.end(), one.parameters.begin(), one.parameters.end());
  };
  add(parameter::choice(lookup_key, plugin.sampler->lookup, names.lookups, "how a hit on a texture becomes colour"),
      vocabulary.lookups);
  if (takes_filters(*plugin.sampler) && !vocabulary.filters.empty()) {
    add(parameter::choice(filter_key, vocabulary.filters.front().name, names.filters,
                          "how points, or what lies between them, are weighed into a pixel"),
        vocabulary.filters);
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
