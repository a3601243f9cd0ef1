// Plugins that are only described: nothing here can be made or run.
#include "vocabulary.h"

#include <limits>

namespace moire::test {
namespace {

using namespace moire::parameter;

constexpr double infinity = std::numeric_limits<double>::infinity();

constexpr Parameter supersample_parameters[] = {
    integer("n", 4, 1, 256, "points", "points of a column, or of a grid's side"),
    choice("layout", "column", "column grid", "n points above one another, or n x n"),
};
constexpr SamplerPlugin supersample{.summary = "Many points.", .source = "", .parameters = supersample_parameters};
// A pattern that anything may be done with.
constexpr SamplerPlugin jittered{
    .summary = "Moved points.", .source = "", .parameters = supersample_parameters, .takes_filters = true};
constexpr Parameter mipmap_parameters[] = {
    real("mipmap.bias", 0, -8, 8, "levels", "more is blurrier"),
    choice("mipmap.level", "max", "max min", "which derivative"),
};
constexpr Parameter tent_parameters[] = {real("tent.radius", 1, 0.5, 4, "pixels", "half its base")};
constexpr Parameter mitchell_parameters[] = {real("mitchell.b", 0.25, 0, 1, "", "B"),
                                             real("mitchell.c", 0.5, 0, 1, "", "C")};

constexpr Parameter area_parameters[] = {
    choice("method", "line", "line exact", "what is integrated"),
    choice("layout", "upright", "upright radial", "where the lines run"),
    flag("closed", false, "whether lines end"),
    real("blur", 0.5, 0, infinity, "pixels", "how wide"),
};
constexpr SamplerPlugin area{
    .summary = "Lines or polygons.", .source = "", .parameters = area_parameters, .asks = [](const Settings& settings) {
      if (settings.text("method") == "exact") return Questions::polygons;
      return settings.text("layout") == "radial" ? Questions::radial_lines : Questions::lines;
    }};
constexpr SamplerPlugin bilinear{.summary = "One point.", .source = "", .lookup = "bilinear"};
constexpr SamplerPlugin point{.summary = "One point.", .source = ""};

constexpr Parameter heightfield_parameters[] = {
    file("height", "heights"),
    choice("generate", "nothing", "nothing fractal", "a terrain that needs no file"),
    flag("hierarchy", false, "mean voxels"),
    real("view.pitch_deg", -20, -90, 90, "degrees", "down is negative").per_frame(),
    real("view.height", 100, -infinity, infinity, "m", "of the eye").per_frame(),
    color("sky", "#80b0ff", "behind it all").per_frame(),
    text("credit", "", "who made the data"),
};
constexpr ScenePlugin heightfield{
    .summary = "A terrain.",
    .source = "",
    .parameters = heightfield_parameters,
    .answers =
        [](const Settings&) {
          return Questions::points | Questions::lines | Questions::radial_lines | Questions::surface;
        },
    .problem =
        [](const Settings& settings) {
          const bool is_both = !settings.text("height").empty() && settings.text("generate") != "nothing";
          return std::string(is_both ? "height and generate exclude each other" : "");
        }};
constexpr ScenePlugin textured_plane{.summary = "A plane.", .source = "", .answers = [](const Settings&) {
                                       return Questions::points | Questions::surface;
                                     }};
constexpr ScenePlugin cartoon{.summary = "Polygons.", .source = "", .answers = [](const Settings&) {
                                return Questions::points | Questions::lines | Questions::polygons;
                              }};

constexpr Parameter coverage_parameters[] = {choice("against", "column", "column pixel", "what is counted as visible")};
constexpr PassDescription coverage{.name = "coverage",
                                   .summary = "Elements seen.",
                                   .source = "",
                                   .parameters = coverage_parameters,
                                   .quantities = {},
                                   .asks = [](const Settings& settings) {
                                     return settings.text("against") == "column" ? Questions::lines : Questions::none;
                                   }};
constexpr PassDescription error{
    .name = "error", .summary = "Colour.", .source = "", .parameters = {}, .quantities = {}};
constexpr PassDescription speed{.name = "speed", .summary = "Time.", .source = "", .parameters = {}, .quantities = {}};

constexpr Parameter strip_parameters[] = {integer("column", 0, 0, 16383, "", "which")};
constexpr PassDescription strip{.name = "strip",
                                .summary = "A column over time.",
                                .source = "",
                                .parameters = strip_parameters,
                                .problem = [](const Settings& settings, const Extent& extent) -> std::string {
                                  if (extent.frames < 2) return "needs two frames";
                                  return settings.integer("column") < extent.image.width ? "" : "leaves the image";
                                }};
constexpr PassDescription plan{
    .name = "plan", .summary = "A map.", .source = "", .parameters = {}, .asks = [](const Settings&) {
      return Questions::surface;
    }};

Plugin scene(std::string name, const ScenePlugin& plugin) {
  return {.file = {}, .kind = Kind::scene, .name = std::move(name), .version = "1.0.0", .scene = &plugin};
}
Plugin sampler(std::string name, const SamplerPlugin& plugin) {
  return {.file = {}, .kind = Kind::sampler, .name = std::move(name), .version = "1.0.0", .sampler = &plugin};
}

}  // namespace

const Vocabulary& vocabulary() {
  static const Catalog catalog({sampler("area", area), sampler("bilinear", bilinear), scene("cartoon", cartoon),
                                scene("heightfield", heightfield), sampler("jittered", jittered),
                                sampler("point", point), sampler("supersample", supersample),
                                scene("textured_plane", textured_plane)});
  static constexpr const PassDescription* metrics[] = {&coverage, &error, &speed};
  static constexpr NamedSummary lookups[] = {{"nearest", "one texel"},
                                             {"linear_across", "two texels"},
                                             {"bilinear", "four texels"},
                                             {"mipmap", "eight texels", mipmap_parameters}};
  static constexpr NamedSummary filters[] = {{"box", "all points alike"},
                                             {"tent", "falls straight", tent_parameters},
                                             {"mitchell", "a cubic", mitchell_parameters}};
  static constexpr const PassDescription* pictures[] = {&plan, &strip};
  static const Vocabulary result{&catalog, metrics, lookups, pictures, filters};
  return result;
}

}  // namespace moire::test
