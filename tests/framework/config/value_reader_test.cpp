#include "config/value_reader.h"

#include <catch2/catch_test_macros.hpp>

#include "experiment_folder.h"

namespace moire::test {
namespace {

// The settings of a heightfield with this member.
Settings settings_with(const ExperimentFolder& folder, const std::string& member) {
  return folder.read(experiment_with({R"("scenes": [{"type": "heightfield", )" + member + "}]"})).scenes[0].settings;
}

TEST_CASE("values of every type are taken as they are declared") {
  const ExperimentFolder folder;
  folder.file("edges/a.png", "");
  CHECK(settings_with(folder, R"("hierarchy": true)").flag("hierarchy"));
  CHECK(settings_with(folder, R"("generate": "fractal")").text("generate") == "fractal");
  CHECK(settings_with(folder, R"("view": {"pitch_deg": -90})").real("view.pitch_deg") == -90);
  CHECK(settings_with(folder, R"("view": {"height": 1e300})").real("view.height") == 1e300);
  CHECK(settings_with(folder, R"("sky": "#00fFaA")").text("sky") == "#00fFaA");
  CHECK(settings_with(folder, R"("credit": "J\u00fcrgen")").text("credit") == "J\u00fcrgen");
  CHECK(settings_with(folder, R"("height": "")").text("height") == "");
  CHECK(settings_with(folder, R"("height": "a.png")").text("height") == (folder.path() / "edges/a.png").string());
}

TEST_CASE("a wrong value says what was found and what would be right") {
  struct Case {
    std::string member, message;
  };
  const Case cases[] = {
      {R"("hierarchy": 1)", R"(hierarchy: is 1; "heightfield" takes true or false)"},
      {R"("hierarchy": "true")", R"(hierarchy: is "true"; "heightfield" takes true or false)"},
      {R"("generate": "fracta")",
       R"(generate: is "fracta"; did you mean "fractal"? "heightfield" takes nothing, fractal)"},
      {R"("generate": "alps")", R"(generate: is "alps"; "heightfield" takes nothing, fractal)"},
      {R"("generate": true)", R"(generate: is true; "heightfield" takes nothing, fractal)"},
      {R"("view": {"pitch_deg": -90.5})", R"(view.pitch_deg: is -90.5; "heightfield" takes -90 to 90 degrees)"},
      {R"("view": {"pitch_deg": "up"})", R"(view.pitch_deg: is "up"; "heightfield" takes a number, -90 to 90 degrees)"},
      {R"("view": {"height": null})", R"(view.height: is null; "heightfield" takes a number in m)"},
      {R"("sky": "blue")", R"(sky: is "blue"; "heightfield" takes a colour such as "#3fa0ff")"},
      {R"("sky": "#12345g")", R"(sky: is "#12345g"; "heightfield" takes a colour such as "#3fa0ff")"},
      {R"("credit": 7)", R"(credit: is 7; "heightfield" takes a text)"},
      {R"("height": {})", R"(height: is an object; "heightfield" takes the path of a file, or "" for none)"},
      {R"("label": 7)", R"(label: is 7; a label is a text)"},
  };
  const ExperimentFolder folder;
  for (const Case& c : cases) {
    INFO(c.member);
    CHECK(folder.problems_with({R"("scenes": [{"type": "heightfield", )" + c.member + "}]"}) ==
          "edges/experiment.json:4: scenes[0]." + c.message);
  }
}

TEST_CASE("ranges may be open on a side, and whole numbers are no fractions") {
  const ExperimentFolder folder;
  CHECK(folder.problems_with({R"("samplers": [{"type": "area", "blur": -1}, {"type": "supersample", "n": 1.0},
    {"type": "supersample", "n": 99999999999999999999}])"}) ==
        "edges/experiment.json:5: samplers[0].blur: is -1; \"area\" takes 0 pixels or more\n"
        "edges/experiment.json:5: samplers[1].n: is 1.0; \"supersample\" takes a whole number, 1 to 256 points\n"
        "edges/experiment.json:6: samplers[2].n: is 99999999999999999999; \"supersample\" takes a whole number, 1 to "
        "256 points");
}

}  // namespace
}  // namespace moire::test
