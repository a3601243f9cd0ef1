// A small run with all that a report must cope with: quotes and markup in names, NaN, infinity, intervals, a failure, a
// line that is no contender, a contender that does not fit, a value below the reference's accuracy.
#pragma once

#include <limits>

#include "run/results.h"

namespace moire::test {

inline Results sample_results() {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  Results r;
  r.experiment = "edges";
  r.question = "Is 1 < 2 & \"3\"?";
  r.width = 64;
  r.height = 48;
  r.scenes.push_back({"hill, steep",
                      "heightfield",
                      "1.0.0",
                      {{"view", {{"pitch_deg", -5.5}}}},
                      "area[lines=32]",
                      0.25,
                      "rmse against twice as many lines",
                      "computed now",
                      "",
                      "images/hill/reference.png",
                      {8, 0, 16, 16},
                      "A hill.",
                      {{"two <points>", "lines & circles"}}});
  r.contenders.push_back({"point", "point", "1.0.0", "nearest", nlohmann::ordered_json::object(), "One ray.", ""});
  r.contenders.push_back({"super[n=2]", "super", "1.1.0", "nearest", {{"n", 2}}, "A grid.", "a paper"});
  r.contenders.push_back({"area", "area", "1.0.0", "nearest", {{"lines", 4}}, "Lines.", ""});
  r.contenders.push_back({"<b>bad</b> \"one\"", "bad", "0.1.0", "nearest", {{"mode", "throw"}}, "Throws.", ""});
  r.contenders.push_back(
      {"two <points>", "two", "1.0.0", "nearest", nlohmann::ordered_json::object(), "Two pixels.", ""});
  r.metrics = {{"error.rmse", "levels", "root of the mean square, sRGB code values", true, true, true},
               {"error.max", "levels", "greatest, sRGB code values", true, true, false},
               {"coverage.visible", "", "V", true, false, false},
               {"coverage.ratio", "", "M / V", false, true, true},
               {"speed.ms_per_frame", "ms", "median of one thread", true, true, false}};
  const std::string scene = r.scenes[0].name;
  r.rows = {{scene, "point", "error.rmse", 12.5, nan, nan, "levels"},
            {scene, "super[n=2]", "error.rmse", 6.0625, nan, nan, "levels"},
            {scene, "area", "error.rmse", 0.1, nan, nan, "levels"},
            {scene, "point", "error.max", infinity, nan, nan, "levels"},
            {scene, "super[n=2]", "error.max", 96, nan, nan, "levels"},
            {scene, "point", "coverage.visible", 731, nan, nan, ""},
            {scene, "super[n=2]", "coverage.visible", 733, nan, nan, ""},
            {scene, "point", "coverage.ratio", 0.47, nan, nan, ""},
            {scene, "super[n=2]", "coverage.ratio", 0.94, nan, nan, ""},
            {scene, "area", "coverage.ratio", nan, nan, nan, ""},
            {scene, "point", "speed.ms_per_frame", 2, 1.9, 2.25, "ms"},
            {scene, "super[n=2]", "speed.ms_per_frame", 8.5, 8.25, 9, "ms"},
            {scene, "area", "speed.ms_per_frame", 3.5, 3.25, 4, "ms"},
            {scene, "empty", "speed.ms_per_frame", 0.015625, 0.01, 0.02, "ms"}};
  r.images = {{scene, "point", "image", "images/hill/point.png", 0},
              {scene, "point", "error_absolute", "images/hill/point_absolute.png", 40},
              {scene, "area", "image", "images/hill/area.png", 0}};
  r.analyses = {{"Cost <model>", {"A step costs 4 ns & a hit 2 ns.", "Held out: 5 % < 10 %."}}};
  r.rows.push_back({"Cost <model>", "Cost <model>", "cost.a", 4, 3.5, 4.5, "ns"});
  r.failures = {{scene, "<b>bad</b> \"one\"", "it threw: <oops> & more"}};
  r.jobs = {{"hill, steep/point", "0123456789abcdef"}};
  r.manifest = {{"version", "0.1.0"}, {"machine", {{"threads", 2}}}};
  return r;
}

}  // namespace moire::test
