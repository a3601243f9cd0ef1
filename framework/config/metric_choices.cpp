// Reads "metrics".
#include "config/metric_choices.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "config/choices.h"
#include "config/experiment_format.h"
#include "config/nearest_name.h"

namespace moire {
namespace {

const MetricDescription* find_metric(std::string_view name, const Vocabulary& vocabulary) {
  const auto found = std::find_if(vocabulary.metrics.begin(), vocabulary.metrics.end(),
                                  [&](const MetricDescription* metric) { return metric->name == name; });
  return found == vocabulary.metrics.end() ? nullptr : *found;
}

void refuse_metric(const JsonNode& type, const std::string& path, const Vocabulary& vocabulary, Problems& problems) {
  std::vector<std::string_view> known;
  for (const MetricDescription* metric : vocabulary.metrics) known.push_back(metric->name);
  problems.add(
      type.place, member_path(path, "type"),
      fmt::format("there is no metric {}{} known are {}", shown(type), did_you_mean(type.text, known), listed(known)));
}

const MetricDescription* metric_of(const JsonNode& entry, const std::string& path, const Vocabulary& vocabulary,
                                   Problems& problems) {
  const JsonNode* type = entry_type(entry, path, "metric", problems);
  if (type == nullptr) return nullptr;
  const MetricDescription* metric = find_metric(type->text, vocabulary);
  if (metric == nullptr) refuse_metric(*type, path, vocabulary, problems);
  return metric;
}

std::optional<MetricEntry> read_metric(const JsonNode& entry, const std::string& path, const MetricDescription& metric,
                                       const Reading& reading) {
  constexpr std::string_view other_keys[] = {"type"};
  const auto cells = read_settings(entry, path, {metric.name, metric.parameters, other_keys}, reading);
  if (cells.empty()) return std::nullopt;
  nlohmann::ordered_json written = {{"type", metric.name}};
  write_settings(metric.parameters, cells.front(), written);
  return MetricEntry{
      entry.place, path, {std::string(metric.name), settings_of(metric.parameters, cells.front())}, std::move(written)};
}

// The rows of a pass are named after it, so that it can be there only once.
void refuse_second(const JsonNode& entry, const std::string& path, const JsonNode& first, const std::string& first_path,
                   std::string_view name, Problems& problems) {
  const std::string line = first.place.line > 0 ? fmt::format(", line {}", first.place.line) : "";
  problems.add(
      entry.place, path,
      fmt::format("is a second \"{}\" (the first is {}{}), whose numbers would have the same names; remove one "
                  "of them",
                  name, first_path, line));
}

JsonNode default_metrics(const Place& place) {
  JsonNode name, entry, list;
  name.kind = JsonKind::text;
  name.text = format::default_metric;
  entry.kind = JsonKind::object;
  list.kind = JsonKind::list;
  name.place = entry.place = list.place = place;
  entry.members.push_back({"type", place, name});
  list.items.push_back(entry);
  return list;
}

}  // namespace

std::vector<MetricEntry> read_metrics(const JsonNode* list, const Place& root, const Vocabulary& vocabulary,
                                      const Reading& reading) {
  const JsonNode defaults = default_metrics(root);
  const std::vector<JsonNode>& entries = list ? list->items : defaults.items;
  std::vector<MetricEntry> metrics;
  std::map<const MetricDescription*, std::size_t> first;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const std::string path = item_path("metrics", i);
    const MetricDescription* metric = metric_of(entries[i], path, vocabulary, reading.problems);
    if (metric == nullptr) continue;
    if (const auto [found, is_new] = first.try_emplace(metric, i); !is_new) {
      const std::size_t k = found->second;
      refuse_second(entries[i], path, entries[k], item_path("metrics", k), metric->name, reading.problems);
    }
    if (auto read = read_metric(entries[i], path, *metric, reading)) metrics.push_back(*std::move(read));
  }
  return metrics;
}

}  // namespace moire
