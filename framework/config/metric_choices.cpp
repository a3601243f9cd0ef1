// Reads "metrics".
#include "config/metric_choices.h"

#include <algorithm>

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

std::optional<MetricEntry> read_metric(const JsonNode& node, const std::string& path, const Vocabulary& vocabulary,
                                       const Reading& reading) {
  const JsonNode* type = entry_type(node, path, "metric", reading.problems);
  if (type == nullptr) return std::nullopt;
  const MetricDescription* metric = find_metric(type->text, vocabulary);
  if (metric == nullptr) {
    refuse_metric(*type, path, vocabulary, reading.problems);
    return std::nullopt;
  }
  constexpr std::string_view other_keys[] = {"type"};
  const auto cells = read_settings(node, path, {metric->name, metric->parameters, other_keys}, reading);
  if (cells.empty()) return std::nullopt;
  nlohmann::ordered_json written = {{"type", metric->name}};
  write_settings(metric->parameters, cells.front(), written);
  return MetricEntry{{std::string(metric->name), settings_of(metric->parameters, cells.front())}, std::move(written)};
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
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const std::string path = item_path("metrics", i);
    const auto metric = read_metric(entries[i], path, vocabulary, reading);
    if (!metric) continue;
    const bool is_new = std::none_of(metrics.begin(), metrics.end(),
                                     [&](const MetricEntry& other) { return other.written == metric->written; });
    if (is_new) {
      metrics.push_back(*metric);
    } else {
      reading.problems.add(entries[i].place, path,
                           fmt::format("is a second \"{}\" with the same settings; remove it", metric->choice.name));
    }
  }
  return metrics;
}

}  // namespace moire
