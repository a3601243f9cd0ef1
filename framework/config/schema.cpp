// The experiment format as JSON Schema, made from the same tables as the reader. It knows one file at a time: of an
// entry that uses another file it checks nothing but that, and whether scenes and samplers fit is the reader's to say.
#include <cmath>

#include "config/experiment.h"
#include "config/experiment_format.h"
#include "config/value_reader.h"

namespace moire {
namespace {

using Json = nlohmann::ordered_json;

// 256 and not 256.0.
Json whole(double number) { return std::abs(number) < 0x1p63 ? Json(static_cast<std::int64_t>(number)) : Json(number); }

Json type_schema(const Parameter& p) {
  switch (p.type) {
    case Type::flag:
      return {{"type", "boolean"}};
    case Type::integer:
      return {{"type", "integer"}, {"minimum", whole(p.smallest)}, {"maximum", whole(p.largest)}};
    case Type::real: {
      Json schema = {{"type", "number"}};
      if (std::isfinite(p.smallest)) schema["minimum"] = p.smallest;
      if (std::isfinite(p.largest)) schema["maximum"] = p.largest;
      return schema;
    }
    case Type::choice:
      return {{"enum", format::words(p.choices)}};
    case Type::color:
      return {{"type", "string"}, {"pattern", "^#[0-9a-fA-F]{6}$"}};
    case Type::text:
    case Type::file:
      return {{"type", "string"}};
  }
  return {};
}

Json one_or_list(const Json& schema) {
  return {{"anyOf", {schema, {{"type", "array"}, {"items", schema}, {"minItems", 1}}}}};
}

Json described(const Parameter& p, Json schema) {
  schema["description"] = std::string(p.meaning) + (p.unit.empty() ? "" : " (" + std::string(p.unit) + ")");
  return schema;
}

Json parameter_schema(const Parameter& p, bool takes_grids) {
  Json schema = described(p, takes_grids ? one_or_list(type_schema(p)) : type_schema(p));
  schema["default"] = default_cell(p).written;
  return schema;
}

Json object_schema() { return {{"type", "object"}, {"properties", Json::object()}, {"additionalProperties", false}}; }

// Adds the parameters to the properties: "view.pitch_deg" to those of "view".
void add_parameters(std::span<const Parameter> table, bool takes_grids, Json& object) {
  for (const Parameter& p : table) {
    Json* at = &object["properties"];
    std::string_view rest = p.name;
    for (std::size_t dot = rest.find('.'); dot != std::string_view::npos; dot = rest.find('.')) {
      Json& group = (*at)[std::string(rest.substr(0, dot))];
      if (group.is_null()) group = object_schema();
      at = &group["properties"];
      rest.remove_prefix(dot + 1);
    }
    (*at)[std::string(rest)] = parameter_schema(p, takes_grids);
  }
}

Json typed_object(std::string_view type, std::string_view summary) {
  Json schema = object_schema();
  schema["description"] = summary;
  schema["required"] = {"type"};
  schema["properties"]["type"] = {{"const", type}};
  return schema;
}

constexpr std::string_view label_meaning = "the name in reports and folders";
const std::string if_installed_key(format::if_installed.name);
constexpr std::string_view use_meaning = "a JSON file whose object is filled in under the keys given here";

Json plugin_schema(const Plugin& plugin, const Vocabulary& vocabulary, bool takes_grids) {
  Json schema = typed_object(plugin.name, plugin.summary());
  if (plugin.sampler && takes_grids)
    for (const Parameter& flag : {format::if_installed, format::if_it_fits})
      schema["properties"][std::string(flag.name)] = parameter_schema(flag, false);
  schema["properties"]["label"] = {{"type", "string"}, {"minLength", 1}, {"description", label_meaning}};
  schema["properties"]["use"] = {{"type", "string"}, {"description", use_meaning}};
  add_parameters(format::parameters_of(plugin, vocabulary, format::OptionNames(vocabulary)), takes_grids, schema);
  return schema;
}

Json pass_schema(const PassDescription& pass) {
  Json schema = typed_object(pass.name, pass.summary);
  add_parameters(pass.parameters, false, schema);
  return schema;
}

// An entry of a list: a name, or one of the objects.
Json entry_schema(const Json& names, const Json& objects) {
  Json schema = {{"anyOf", Json::array({{{"enum", names}}})}};
  for (const Json& object : objects) schema["anyOf"].push_back(object);
  return schema;
}

Json plugin_entry_schema(Kind kind, const Vocabulary& vocabulary, bool takes_grids) {
  Json names = Json::array(), objects = Json::array();
  for (const Plugin* plugin : vocabulary.catalog->all(kind)) {
    if (plugin->sampler && plugin->sampler->is_optional) continue;
    names.push_back(plugin->name);
    objects.push_back(plugin_schema(*plugin, vocabulary, takes_grids));
  }
  // The used file says the type, and so what else may stand here.
  objects.push_back({{"type", "object"},
                     {"properties", {{"use", {{"type", "string"}, {"description", use_meaning}}}}},
                     {"required", {"use"}},
                     {"not", {{"required", {"type"}}}}});
  // What may be missing here can have any settings.
  if (kind == Kind::sampler && takes_grids) {
    objects.push_back(
        {{"type", "object"},
         {"properties",
          {{"type", {{"type", "string"}, {"not", {{"enum", names}}}}}, {if_installed_key, {{"const", true}}}}},
         {"required", {"type", if_installed_key}}});
  }
  return entry_schema(names, objects);
}

Json pass_entry_schema(std::span<const PassDescription* const> passes) {
  Json names = Json::array(), objects = Json::array();
  for (const PassDescription* pass : passes) {
    names.push_back(pass->name);
    objects.push_back(pass_schema(*pass));
  }
  return entry_schema(names, objects);
}

Json definitions(const Vocabulary& vocabulary) {
  return {{"scene", plugin_entry_schema(Kind::scene, vocabulary, true)},
          {"sampler", plugin_entry_schema(Kind::sampler, vocabulary, true)},
          {"reference", plugin_entry_schema(Kind::sampler, vocabulary, false)},
          {"metric", pass_entry_schema(vocabulary.metrics)},
          {"picture", pass_entry_schema(vocabulary.pictures)}};
}

Json reference_to(std::string_view definition) { return {{"$ref", "#/definitions/" + std::string(definition)}}; }

Json image_schema() {
  Json schema = object_schema();
  for (const Parameter& side : format::image) {
    schema["properties"][std::string(side.name)] = described(side, type_schema(side));
    schema["required"].push_back(side.name);
  }
  return schema;
}

Json frames_schema() {
  Json schema = object_schema();
  for (const Parameter& p : {format::frame_count, format::still_frame})
    schema["properties"][std::string(p.name)] = parameter_schema(p, false);
  const Json key = {{"type", "array"}, {"items", {{"type", "number"}}}, {"minItems", 2}, {"maxItems", 2}};
  const Json keyframes = {{"type", "array"}, {"items", key}, {"minItems", 1}};
  for (const auto& [name, meaning] :
       {std::pair{format::animate_key,
                  "parameters of the scenes over time: keyframes [frame, value], straight in between"},
        {format::move_key, "the same, added to each scene's own value"}}) {
    schema["properties"][std::string(name)] = {
        {"type", "object"},
        {"description", meaning},
        {"additionalProperties", {{"anyOf", {keyframes, {{"type", "object"}, {"additionalProperties", keyframes}}}}}}};
  }
  return schema;
}

Json one_or_several(std::string_view definition) {
  return {{"anyOf", {reference_to(definition), {{"type", "array"}, {"items", reference_to(definition)}}}}};
}

}  // namespace

Json experiment_schema(const Vocabulary& vocabulary) {
  Json schema = object_schema();
  schema["properties"] = {
      {"$schema", {{"type", "string"}}},
      {"question", described(format::question, type_schema(format::question))},
      {"image", image_schema()},
      {"scenes", one_or_list(reference_to("scene"))},
      {"samplers", one_or_list(reference_to("sampler"))},
      {"reference", {{"anyOf", {{{"const", format::default_reference}}, reference_to("reference")}}}},
      {"seed", parameter_schema(format::seed, false)},
      {"frames", frames_schema()},
      {"metrics", one_or_several("metric")},
      {"pictures", one_or_several("picture")},
      {std::string(format::keep_images.name), parameter_schema(format::keep_images, false)}};
  schema["properties"]["reference"]["default"] = format::default_reference;
  schema["properties"]["metrics"]["default"] = {format::default_metric};
  schema["required"] = {"question", "image", "scenes", "samplers"};
  schema["definitions"] = definitions(vocabulary);
  Json result = {{"$schema", "http://json-schema.org/draft-07/schema#"}, {"title", "A moire experiment"}};
  result.update(schema);
  return result;
}

}  // namespace moire
