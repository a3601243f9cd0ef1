// The schema must never refuse what the reader takes, or an editor would find fault with good experiments.
#include <catch2/catch_test_macros.hpp>

#include "experiment_folder.h"
#include "schema_check.h"
#include "vocabulary.h"

namespace moire::test {
namespace {

const nlohmann::json& schema() {
  static const nlohmann::json result = experiment_schema(vocabulary());
  return result;
}

bool is_valid(const std::string& text) { return test::is_valid(nlohmann::json::parse(text), schema(), schema()); }

TEST_CASE("the schema takes what the reader takes, and the request that comes of it") {
  const ExperimentFolder folder;
  folder.file("configs/a.json", R"({"type": "heightfield", "label": "a"})");
  const std::vector<std::vector<std::string>> experiments = {
      {},
      {R"("$schema": "x.json")", R"("scenes": "heightfield")", R"("samplers": "point")", R"("metrics": "speed")"},
      {R"("scenes": {"use": "configs/a.json", "view": {"pitch_deg": [1, 2.5]}})"},
      {R"("scenes": [{"use": "configs/a.json", "type": "heightfield", "view": {"pitch_deg": 1}}])"},
      {R"("scenes": [{"type": "heightfield", "hierarchy": [true, false], "sky": "#AAbb00", "view": {"height": -1e99}}])"},
      {R"("samplers": ["point", {"type": "supersample", "n": [1, 256], "layout": "grid", "lookup": ["nearest"]}])"},
      {R"("reference": "auto")"},
      {R"("reference": "point")"},
      {R"("reference": {"type": "supersample", "n": 64, "label": "fine"})"},
      {R"("seed": 9007199254740992)", R"("metrics": ["error", {"type": "coverage", "against": "pixel"}])"},
      {R"("metrics": [])"},
      {R"("samplers": ["point", {"type": "cairo", "if_installed": true, "antialias": ["best", "fast"]}])"},
      {R"("samplers": [{"type": "supersample", "if_installed": true, "n": 2}, {"type": "point", "if_installed": false}])"},
  };
  for (const auto& lines : experiments) {
    const std::string text = experiment_with(lines);
    INFO(text);
    const Experiment experiment = folder.read(text);
    CHECK(is_valid(text));
    CHECK(is_valid(experiment.request.dump()));
  }
}

TEST_CASE("the schema and the reader refuse the same mistakes of form") {
  const std::string mistakes[] = {
      R"("question": 3)",
      R"("image": {"width": 64})",
      R"("image": {"width": 0, "height": 48})",
      R"("image": {"width": 64, "height": 48, "depth": 1})",
      R"("image": {"width": 64.5, "height": 48})",
      R"("colour": 1)",
      R"("scenes": [])",
      R"("scenes": ["hightfield"])",
      R"("scenes": [{"label": "x"}])",
      R"("scenes": [{"type": "heightfield", "view": {"pitch_deg": 91}}])",
      R"("scenes": [{"type": "heightfield", "view": {"pich_deg": 9}}])",
      R"("scenes": [{"type": "heightfield", "hierarchy": 1}])",
      R"("scenes": [{"type": "heightfield", "sky": "blue"}])",
      R"("samplers": [{"type": "supersample", "n": 0}])",
      R"("samplers": [{"type": "supersample", "n": []}])",
      R"("samplers": [{"type": "supersample", "n": [1, 257]}])",
      R"("samplers": [{"type": "supersample", "layout": "gird"}])",
      R"("samplers": [{"type": "point", "n": 4}])",
      R"("samplers": [{"type": "point", "lookup": "near"}])",
      R"("samplers": [{"type": "point", "label": ""}])",
      R"("samplers": [{"type": "point", "if_installed": "yes"}])",
      R"("samplers": [{"type": "cairo", "if_installed": false}])",
      R"("samplers": [{"type": "point", "if_installed": true, "n": 4}])",
      R"("scenes": [{"type": "heightfield", "if_installed": true}])",
      R"("reference": {"type": "point", "if_installed": true})",
      R"("reference": {"type": "supersample", "n": [1, 2]})",
      R"("reference": "atuo")",
      R"("seed": -1)",
      R"("metrics": ["sped"])",
      R"("metrics": [{"type": "coverage", "against": ["pixel"]}])",
      R"("metrics": [{"type": "error", "label": "x"}])",
  };
  const ExperimentFolder folder;
  for (const std::string& mistake : mistakes) {
    INFO(mistake);
    CHECK_FALSE(is_valid(experiment_with({mistake})));
    CHECK(folder.problems_with({mistake}) != "(no error)");
  }
  CHECK_FALSE(is_valid("{}"));
  CHECK_FALSE(is_valid("[]"));
}

TEST_CASE("editors find meanings, units and defaults") {
  const auto& sampler = schema().at("definitions").at("sampler").at("anyOf");
  CHECK(sampler[0].dump() == R"({"enum":["area","bilinear","jittered","point","supersample"]})");
  CHECK(sampler[5].at("description") == "Many points.");
  CHECK(sampler[5].at("properties").at("type").dump() == R"({"const":"supersample"})");
  CHECK(sampler[5].at("properties").at("layout").at("default") == "column");
  CHECK(sampler[5].at("properties").at("n").dump(1) == R"json({
 "anyOf": [
  {
   "maximum": 256,
   "minimum": 1,
   "type": "integer"
  },
  {
   "items": {
    "maximum": 256,
    "minimum": 1,
    "type": "integer"
   },
   "minItems": 1,
   "type": "array"
  }
 ],
 "default": 4,
 "description": "points of a column, or of a grid's side (points)"
})json");
}

}  // namespace
}  // namespace moire::test
