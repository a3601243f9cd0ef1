// What can be wrong with an experiment and its files: one clear message, the right exit code, and nothing is lost.
#include <fmt/format.h>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <sstream>

#include <moire/image.h>

#include "app/program.h"
#include "app/tiny_experiment.h"
#include "framework/sdk/png_bytes.h"
#include "report/json.h"
#include "support/plugins.h"

namespace moire::test {

namespace {

// Of the images `label`.EXTENSION and color.png.
std::string scene(std::string_view label, std::string_view extension = "png") {
  return fmt::format(R"({{"type": "heightfield", "label": "{0}", "height": "../{0}.{1}", "color": "../color.png"}})",
                     label, extension);
}

// All samplers that are there: how many depends on what is installed.
std::string known_samplers() {
  std::vector<std::string> names;
  for (const Plugin* plugin : catalog().all(Kind::sampler)) names.push_back(plugin->name);
  return fmt::format("{}", fmt::join(names, ", "));
}

std::string list(const std::vector<std::string>& scenes) { return fmt::format("[{}]", fmt::join(scenes, ", ")); }

std::string grey_png(std::uint32_t side) {
  std::string samples;
  for (std::uint32_t k = 0; k < side * side; ++k) samples += static_cast<char>(k * 37);
  return png_bytes(side, side, 8, PngColor::grey, samples);
}

// stderr without the lines that libpng writes there on its own.
std::string own_lines(const std::string& err) {
  std::string result;
  std::istringstream stream(err);
  for (std::string line; std::getline(stream, line);) {
    if (!line.starts_with("libpng ")) result += line + '\n';
  }
  return result;
}

// Runs an experiment that must be refused: everything stays as it was.
Ended refused(const Desk& desk, const std::string& experiment, const std::vector<std::string>& more = {}) {
  desk.file("tiny/experiment.json", experiment);
  const auto before = desk.files(".");
  std::vector<std::string> command{"run", "tiny", "-o", "out"};
  command.insert(command.end(), more.begin(), more.end());
  const Ended ended = desk.moire(command);
  CHECK(ended.code == 2);
  CHECK(ended.out == "");
  CHECK(desk.files(".") == before);
  return ended;
}

}  // namespace

TEST_CASE("images that turn out to be bad cost their own scenes only") {
  const Desk desk;
  desk.file("color.png", grey_png(8));
  desk.file("pixel.png", grey_png(1));
  desk.file("truncated.png", grey_png(64).substr(0, 2000));
  desk.file("huge.png", png_bytes(100000, 100000, 8, PngColor::grey, ""));
  write_image(desk.path() / "empty.exr", 4, 3, std::vector<Color>(12, Color{NAN, NAN, NAN}));
  const std::string hills = R"({"type": "heightfield", "label": "hills", "size": 64})";
  desk.file("tiny/experiment.json",
            tiny_experiment(R"(["point"])", R"(["error"])",
                            list({scene("truncated"), scene("empty", "exr"), scene("huge"), scene("pixel"), hills})));
  const Ended ended = desk.moire({"run", "tiny", "-o", "out"});
  CHECK(ended.code == 1);

  const Results results = report::read_json(desk.path() / "out");
  REQUIRE(results.failures.size() == 3);
  const std::string lost = "; no contender ran on this scene", folder = desk.path().string() + "/";
  // The reason in brackets is OpenImageIO's, in other words from version to version.
  const std::string truncated = results.failures[0].message;
  CHECK(truncated.starts_with(folder + "truncated.png: is damaged or cut short ("));
  CHECK(truncated.ends_with("); get the file again" + lost));
  const std::string empty =
      folder + "empty.exr: height at column 0, row 0 is not a finite number; every pixel needs one";
  const std::string huge = folder +
                           "huge.png: is too large (100000 x 100000 pixels, channels: 1); at most 268435456 values "
                           "can be read";
  CHECK(results.failures[1].message == empty + lost);
  CHECK(results.failures[2].message == huge + lost);
  CHECK(without_references(own_lines(ended.err)) ==
        "[1/10] truncated / reference\ntruncated / reference: failed: " +
            truncated.substr(0, truncated.size() - lost.size()) +
            "\n[3/10] empty / reference\nempty / reference: failed: " + empty +
            "\n[5/10] huge / reference\nhuge / reference: failed: " + huge +
            "\n[7/10] pixel / reference\n[8/10] pixel / point\n"
            "[9/10] hills / reference\n[10/10] hills / point\n");

  REQUIRE(results.rows.size() == 8);
  for (std::size_t k = 0; k < 8; ++k) {
    CHECK(results.rows[k].scene == (k < 4 ? "pixel" : "hills"));
    CHECK(std::isfinite(results.rows[k].value));
  }
  CHECK(desk.bytes("out/report.html").find(huge) != std::string::npos);
}

TEST_CASE("render of a bad image fails in the run, not in the request") {
  const Desk desk;
  desk.file("color.png", grey_png(8));
  desk.file("huge.png", png_bytes(100000, 100000, 8, PngColor::grey, ""));
  desk.file("huge.json", R"({"type": "heightfield", "height": "huge.png", "color": "color.png"})");
  const Ended ended = desk.moire({"render", "huge.json", "point"});
  CHECK(ended.code == 1);
  CHECK(ended.out == "");
  CHECK(ended.err == desk.path().string() +
                         "/huge.png: is too large (100000 x 100000 pixels, channels: 1); at most 268435456 values can "
                         "be read\n");
  CHECK_FALSE(std::filesystem::exists(desk.path() / "picture.png"));
}

TEST_CASE("a missing image is found before anything runs") {
  const Desk desk;
  CHECK(refused(desk, tiny_experiment(R"(["point"])", R"(["error"])", list({scene("hills")}))).err ==
        "tiny/experiment.json:4: scenes[0].height: is \"../hills.png\", but there is no such file (looked for "
        "hills.png)\n"
        "tiny/experiment.json:4: scenes[0].color: is \"../color.png\", but there is no such file (looked for "
        "color.png)\n");
}

TEST_CASE("a missing experiment, and a folder without one") {
  const Desk desk;
  std::filesystem::create_directory(desk.path() / "empty");
  const Ended missing = desk.moire({"run", "missing"});
  CHECK(missing.code == 2);
  CHECK(missing.err ==
        "missing: no such file or folder; an experiment is a JSON file, or a folder with an experiment.json\n");
  const Ended empty = desk.moire({"run", "empty"});
  CHECK(empty.code == 2);
  CHECK(empty.err ==
        "empty: has no experiment.json; an experiment is a JSON file, or a folder with one of that name\n");
}

TEST_CASE("an output folder that cannot be written is found before anything runs") {
  const Desk desk;
  desk.file("tiny/experiment.json", tiny_experiment());
  const auto before = desk.files(".");
  const Ended ended = desk.moire({"run", "tiny", "-o", "tiny/experiment.json/out"});
  CHECK(ended.code == 2);
  CHECK(ended.out == "");
  CHECK(ended.err == "tiny/experiment.json/out: cannot be made (Not a directory); name another folder with -o\n");
  CHECK(desk.files(".") == before);
}

TEST_CASE("mistakes in the experiment are reported at once, and nothing is written") {
  const Desk desk;
  CHECK(refused(desk, "{\"question\": \"Why?\",\n\"image\": {\"width\": 24 \"height\": 16}}").err ==
        "tiny/experiment.json:2: not JSON: unexpected string literal; expected ',' or '}'\n");
  CHECK(refused(desk, tiny_experiment(R"(["pont"])", R"(["error", {"type": "coverage", "agianst": "pixel"}])",
                                      "[{\"type\": \"heightfield\", \"size\": \"64\", \"far\": -1,\n\"far\": 2}]"))
            .err ==
        "tiny/experiment.json:4: scenes[0].size: is \"64\"; \"heightfield\" takes a whole number, 1 to 8192 voxels\n"
        "tiny/experiment.json:4: scenes[0].far: is -1; \"heightfield\" takes 0 to 1000000000 units\n"
        "tiny/experiment.json:5: scenes[0].far: repeated key (first on line 4); keep one of them\n"
        "tiny/experiment.json:6: samplers[0].type: there is no sampler \"pont\"; did you mean \"point\"? known are " +
            known_samplers() +
            "\n"
            "tiny/experiment.json:7: metrics[1].agianst: unknown key; did you mean \"against\"? \"coverage\" takes "
            "against\n");
}

TEST_CASE("a sampler that a scene cannot serve is refused with the scenes that would do") {
  const Desk desk;
  std::filesystem::create_directory(desk.path() / "plugins");
  std::filesystem::copy(TEST_PLUGINS "/good_scene.so", desk.path() / "plugins");
  CHECK(refused(desk, tiny_experiment(R"(["point", "area"])", R"(["error"])", R"(["good"])"), {"--plugins", "plugins"})
            .err ==
        "tiny/experiment.json:5: samplers[1]: \"area\" asks for lines, which scene \"good\" (good) does not have; "
        "scenes that do: cartoon, heightfield, primitives\n");
}

TEST_CASE("results that are there stay as they are when a later request is wrong") {
  const Desk desk;
  desk.file("tiny/experiment.json", tiny_experiment());
  CHECK(desk.moire({"run", "tiny", "-o", "out"}).code == 0);
  CHECK(refused(desk, tiny_experiment(), {"--set", "image.width=0"}).err ==
        "--set image.width=0: image.width: is 0; \"image\" takes 1 to 16384 pixels\n");
}

}  // namespace moire::test
