// Reads the experiment file and completes it.
#include "config/experiment_tree.h"

#include <utility>

#include <fmt/format.h>

#include "config/experiment_format.h"
#include "config/overrides.h"
#include "json/nearest_name.h"

namespace moire {
namespace {

// "point" is short for {"type": "point"}.
void write_out_name(JsonNode& node) {
  if (!node.is(JsonKind::text)) return;
  JsonNode object;
  object.kind = JsonKind::object;
  object.place = node.place;
  object.members.push_back({"type", node.place, std::move(node)});
  node = std::move(object);
}

// One entry is short for a list of it.
void write_out_list(JsonNode& node) {
  if (node.is(JsonKind::text) || node.is(JsonKind::object)) {
    JsonNode list;
    list.kind = JsonKind::list;
    list.place = node.place;
    list.items.push_back(std::move(node));
    node = std::move(list);
  }
  for (JsonNode& item : node.items) write_out_name(item);
}

void write_out(JsonNode& root) {
  for (std::string_view key : {"scenes", "samplers", "metrics", "pictures"}) {
    if (JsonNode* node = root.find(key)) write_out_list(*node);
  }
  JsonNode* reference = root.find("reference");
  if (reference && reference->text != format::default_reference) write_out_name(*reference);
}

void resolve_uses(JsonNode& root, const ExperimentPlace& place, Problems& problems) {
  for (std::string_view key : {"scenes", "samplers"}) {
    JsonNode* list = root.find(key);
    for (std::size_t i = 0; list && i < list->items.size(); ++i) {
      resolve_use(list->items[i], item_path(key, i), place, problems);
    }
  }
  if (JsonNode* reference = root.find("reference")) resolve_use(*reference, "reference", place, problems);
}

}  // namespace

JsonNode read_experiment_tree(const ExperimentPlace& place, std::span<const std::string> sets, Problems& problems) {
  const auto source = std::make_shared<Source>(Source{place.file.string(), place.folder});
  std::optional<JsonNode> root = parse_json(read_text(place.file), source, "", problems);
  if (root && !root->is(JsonKind::object)) {
    problems.add(root->place, "",
                 fmt::format("is {}; an experiment is an object with {}", shown(*root), listed(format::keys)));
    root.reset();
  }
  if (!root) problems.throw_if_any();
  // Before --set, so that its paths lead into entries that were short, and after, since it may be short itself.
  write_out(*root);
  apply_sets(sets, *root, problems);
  write_out(*root);
  resolve_uses(*root, place, problems);
  return *std::move(root);
}

}  // namespace moire
