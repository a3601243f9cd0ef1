#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <moire/error.h>

#include "app/commands.h"
#include "json/nearest_name.h"

namespace moire::app {

namespace {

// Anything that has a name, a summary and parameters.
struct Described {
  std::string kind, name, version, summary, source;
  std::span<const Parameter> parameters;
  std::span<const Quantity> quantities;
  Claims claims;
};

std::vector<Described> everything(const Session& session) {
  std::vector<Described> all;
  for (Kind kind : {Kind::sampler, Kind::scene}) {
    for (const Plugin* p : session.catalog.all(kind)) {
      all.push_back({kind == Kind::sampler ? "sampler" : "scene",
                     p->name,
                     p->version,
                     std::string(p->summary()),
                     std::string(p->source()),
                     p->parameters(),
                     {},
                     p->sampler ? p->sampler->claims : Claims{}});
    }
  }
  const auto add_passes = [&](const char* kind, std::span<const PassDescription* const> passes) {
    for (const PassDescription* pass : passes) {
      all.push_back({kind,
                     std::string(pass->name),
                     "",
                     std::string(pass->summary),
                     std::string(pass->source),
                     pass->parameters,
                     pass->quantities,
                     {}});
    }
  };
  add_passes("metric", session.vocabulary.metrics);
  add_passes("picture", session.vocabulary.pictures);
  const auto add_options = [&](const char* kind, std::span<const NamedSummary> named) {
    for (const NamedSummary& one : named)
      all.push_back({kind, std::string(one.name), "", std::string(one.summary), "", one.parameters, {}, {}});
  };
  add_options("lookup", session.vocabulary.lookups);
  add_options("filter", session.vocabulary.filters);
  return all;
}

constexpr const char* type_name(Type type) {
  switch (type) {
    case Type::flag:
      return "true or false";
    case Type::integer:
      return "integer";
    case Type::real:
      return "number";
    case Type::text:
      return "text";
    case Type::choice:
      return "choice";
    case Type::file:
      return "file";
    case Type::color:
      return "color";
  }
  return "";
}

std::string default_of(const Parameter& p) {
  switch (p.type) {
    case Type::flag:
      return p.number != 0 ? "true" : "false";
    case Type::integer:
    case Type::real:
      return fmt::format("{}", p.number);
    default:
      return p.text.empty() ? "none" : std::string(p.text);
  }
}

std::string range_of(const Parameter& p) {
  if (p.type == Type::choice) {
    std::string choices(p.choices);
    for (std::size_t at = 0; (at = choices.find(' ', at)) != std::string::npos; at += 3) choices.replace(at, 1, " | ");
    return choices;
  }
  if (p.type == Type::integer || p.type == Type::real) {
    return fmt::format("{} .. {}{}{}", p.smallest, p.largest, p.unit.empty() ? "" : " ", p.unit);
  }
  return type_name(p.type);
}

void print(const Described& d) {
  fmt::print("{} ({}{}{}): {}\n", d.name, d.kind, d.version.empty() ? "" : " ", d.version, d.summary);
  if (!d.source.empty()) fmt::print("after {}\n", d.source);
  if (!d.parameters.empty()) fmt::print("\n  {:<18} {:<12} {:<28} meaning\n", "parameter", "default", "takes");
  for (const Parameter& p : d.parameters) {
    fmt::print("  {:<18} {:<12} {:<28} {}{}\n", p.name, default_of(p), range_of(p), p.meaning,
               p.exact.empty() ? "" : fmt::format(" (references: {})", p.exact));
  }
  if (!d.quantities.empty()) fmt::print("\n  {:<30} {:<11} meaning\n", "quantity", "unit");
  for (const Quantity& q : d.quantities) fmt::print("  {:<30} {:<11} {}\n", q.name, q.unit, q.meaning);
}

nlohmann::ordered_json as_json_object(const Described& d) {
  nlohmann::ordered_json json{
      {"kind", d.kind}, {"name", d.name}, {"version", d.version}, {"summary", d.summary}, {"source", d.source}};
  if (d.kind == "sampler") {
    json["claims"] = {
        {"deterministic", d.claims.deterministic}, {"unbiased", d.claims.unbiased}, {"exact", d.claims.exact}};
  }
  json["parameters"] = nlohmann::ordered_json::array();
  for (const Parameter& p : d.parameters) {
    json["parameters"].push_back({{"name", p.name},
                                  {"type", type_name(p.type)},
                                  {"default", default_of(p)},
                                  {"takes", range_of(p)},
                                  {"unit", p.unit},
                                  {"meaning", p.meaning},
                                  {"per_frame", p.is_per_frame}});
  }
  for (const Quantity& q : d.quantities) {
    json["quantities"].push_back(
        {{"name", q.name}, {"unit", q.unit}, {"meaning", q.meaning}, {"lower_is_better", q.lower_is_better}});
  }
  return json;
}

}  // namespace

int describe(const Session& session, const std::string& name, bool as_json) {
  const std::vector<Described> all = everything(session);
  std::vector<const Described*> found;
  std::vector<std::string_view> names;
  for (const Described& d : all) {
    names.push_back(d.name);
    if (d.name == name) found.push_back(&d);
  }
  if (found.empty()) {
    throw Error(
        fmt::format("{}: no sampler, scene, metric, picture, lookup or filter has this name{} `moire list` shows all",
                    name, did_you_mean(name, names)));
  }
  for (const Described* d : found) {
    if (d != found.front() && !as_json) fmt::print("\n");
    as_json ? fmt::print("{}\n", as_json_object(*d).dump(2)) : print(*d);
  }
  return done;
}

int schema(const Session& session) {
  fmt::print("{}\n", experiment_schema(session.vocabulary).dump(2));
  return done;
}

}  // namespace moire::app
