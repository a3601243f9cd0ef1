// `moire run` from the file to the report.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <set>

#include <moire/image.h>

#include "app/program.h"
#include "app/tiny_experiment.h"
#include "report/json.h"
#include "report/summary.h"

namespace moire::test {

namespace {

using Names = std::set<std::string>;
using Files = std::map<std::string, std::string>;

Names names(const Files& files) {
  Names result;
  for (const auto& [name, bytes] : files) result.insert(name);
  return result;
}

// A desk with the experiment `tiny`.
struct TinyDesk : Desk {
  explicit TinyDesk(const std::string& experiment = tiny_experiment()) { file("tiny/experiment.json", experiment); }
};

// Three frames of a camera that moves, of which the second is the still; flicker, and every picture, some twice.
std::string moving_experiment() {
  std::string json = tiny_experiment(R"(["point", {"type": "supersample", "n": 2}])", R"(["error", "flicker"])");
  json.resize(json.rfind('}'));
  return json + R"(, "frames": {"count": 3, "still": 1, "animate": {"view.x": [[0, 30], [2, 34.5]]}},
"pictures": [{"type": "footprint", "window": {"x": 8, "y": 8, "width": 4, "height": 3}},
             {"type": "footprint", "in": "image", "window": {"x": 8, "y": 8, "width": 4, "height": 3}},
             {"type": "enlarged_pixel", "x": 9, "y": 9}, {"type": "enlarged_pixel", "x": 9, "y": 9, "over": "time"},
             {"type": "column_over_time", "column": 9}]
}
)";
}

// The pixels of a picture in a result folder, row by row.
std::vector<Color> pixels(const std::filesystem::path& file) {
  const Image image = read_image(file);
  std::vector<Color> result;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) result.push_back(color_at(image, x, y));
  }
  return result;
}

Names samplers_in(const Results& results) {
  Names result;
  for (const Row& row : results.rows) result.insert(row.scene + "/" + row.sampler);
  return result;
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("a run writes exactly the files of a result folder") {
  const TinyDesk desk;
  const Ended ended = desk.moire({"run", "tiny"});
  INFO(ended.err);
  CHECK(ended.code == 0);
  Names expected{"experiment.json",
                 "manifest.json",
                 "report.html",
                 "results.csv",
                 "results.json",
                 "images/hills/(reference)/frame_0000.exr",
                 "images/hills/(reference)/frame_0000.png"};
  for (const char* sampler : {"point", "supersample[n=2]"}) {
    for (const char* picture : {"frame_0000", "error_absolute_0000", "error_signed_0000"}) {
      for (const char* format : {".exr", ".png"}) {
        expected.insert(std::string("images/hills/") + sampler + "/" + picture + format);
      }
    }
  }
  CHECK(names(desk.files("results/tiny")) == expected);
  CHECK(names(desk.files(".")).size() == expected.size() + 1);  // nothing elsewhere
}

TEST_CASE("an animation's pictures lie beside its images, and flicker is measured of the reference too") {
  const TinyDesk desk(moving_experiment());
  const Ended ended = desk.moire({"run", "tiny", "-o", "out"});
  CHECK(ended.code == 0);
  CHECK(without_references(ended.err) ==
        "[1/4] hills / reference\n[2/4] hills / point\n[3/4] hills / supersample[n=2]\n[4/4] hills / frames\n");

  Names drawn;
  for (const std::string& name : names(desk.files("out/images/hills"))) {
    if (name.find("_0000") == std::string::npos) drawn.insert(name);
  }
  Names expected{"(reference)/column_over_time.png"};
  for (const std::string sampler : {"point", "supersample[n=2]"}) {
    for (const char* picture :
         {"column_over_time", "enlarged_pixel_1", "enlarged_pixel_2", "footprint_1", "footprint_2"}) {
      expected.insert(sampler + "/" + picture + ".png");
    }
  }
  CHECK(drawn == expected);

  const Results results = report::read_json(desk.path() / "out");
  CHECK(results.failures.empty());
  Names flickering;
  for (const Row& row : results.rows) {
    if (row.metric == "flicker.mean") flickering.insert(row.sampler);
    if (row.metric == "flicker.excess" && row.sampler == "reference") CHECK(row.value == 0);
  }
  CHECK(flickering == Names{"reference", "point", "supersample[n=2]"});
  const std::string page = desk.bytes("out/report.html");
  for (const ImageResult& image : results.images) {
    if (image.kind == "image" || image.scale > 0) continue;
    CAPTURE(image.sampler, image.kind);
    CHECK(
        expected.contains((image.sampler == "reference" ? "(reference)" : image.sampler) + "/" + image.kind + ".png"));
    CHECK_FALSE(image.caption.empty());
    CHECK(page.find(image.caption) != std::string::npos);
  }
}

TEST_CASE("images are of the still, and columns over time hold the columns of the frames' images") {
  const TinyDesk desk(moving_experiment());
  REQUIRE(desk.moire({"run", "tiny", "-o", "out"}).code == 0);
  for (const int frame : {0, 1, 2}) {
    // Each frame as the still picture of an experiment without time, its camera where the track has it.
    desk.file("still/experiment.json",
              tiny_experiment(R"(["point"])", R"(["error"])",
                              R"([{"type": "heightfield", "label": "hills", "size": 64, "view": {"x": )" +
                                  std::to_string(30 + 2.25 * frame) + "}}]"));
    REQUIRE(desk.moire({"run", "still", "-o", "alone"}).code == 0);
    for (const char* sampler : {"point", "(reference)"}) {
      CAPTURE(frame, sampler);
      const auto place = std::filesystem::path("images/hills") / sampler;
      const auto alone = pixels(desk.path() / "alone" / place / "frame_0000.png");
      const auto over_time = pixels(desk.path() / "out" / place / "column_over_time.png");
      REQUIRE(alone.size() == 24 * 16);
      REQUIRE(over_time.size() == 3 * 16);
      for (std::size_t y = 0; y < 16; ++y)
        CHECK(over_time[3 * y + static_cast<std::size_t>(frame)] == alone[24 * y + 9]);
      if (frame == 1) CHECK(pixels(desk.path() / "out" / place / "frame_0000.png") == alone);
    }
  }
}

TEST_CASE("the experiment that an animation leaves gives the same pictures again, on any number of threads") {
  const TinyDesk desk(moving_experiment());
  CHECK(desk.moire({"run", "tiny", "-o", "one", "-j", "1"}).code == 0);
  CHECK(desk.moire({"run", "one/experiment.json", "-o", "two", "-j", "2"}).code == 0);
  CHECK(desk.files("two/images") == desk.files("one/images"));
  CHECK(desk.bytes("two/experiment.json") == desk.bytes("one/experiment.json"));
  CHECK(desk.bytes("two/results.csv") == desk.bytes("one/results.csv"));
}

TEST_CASE("a picture that cannot be drawn costs no other picture and no number") {
  // The window sees the terrain to its end, far beyond what a footprint in plan may span.
  const TinyDesk desk(moving_experiment());
  const Ended ended =
      desk.moire({"run", "tiny", "-o", "out", "--set", "scenes[0].far=12000", "--set", "scenes[0].view.height=300",
                  "--set", "pictures[0].window.y=0", "--set", "pictures[0].window.height=8"});
  CHECK(ended.code == 1);
  const Results results = report::read_json(desk.path() / "out");
  REQUIRE(results.failures.size() == 2);
  Names failed, drawn;
  for (const Failure& failure : results.failures) {
    failed.insert(failure.sampler);
    CHECK(failure.message.starts_with("footprint: spans "));
    CHECK(failure.message.ends_with(" texels, at most 8192 are shown; choose a smaller window"));
  }
  CHECK(failed == Names{"point", "supersample[n=2]"});
  for (const ImageResult& image : results.images) drawn.insert(image.sampler + "/" + image.kind);
  for (const std::string sampler : {"point", "supersample[n=2]"}) {
    CHECK_FALSE(drawn.contains(sampler + "/footprint_1"));
    CHECK(drawn.contains(sampler + "/footprint_2"));
    CHECK(drawn.contains(sampler + "/column_over_time"));
  }
  CHECK(samplers_in(results).size() == 3);
}

TEST_CASE("progress goes to stderr, a line a job, and the summary to stdout") {
  const TinyDesk desk(tiny_experiment(R"(["point"])", R"(["error", {"type": "speed", "rounds": 1}])"));
  const Ended ended = desk.moire({"run", "tiny", "-o", "out"});
  CHECK(ended.code == 0);
  CHECK(without_references(ended.err) == "[1/3] hills / reference\n[2/3] hills / point\n[3/3] hills / speed\n");
  CHECK(ended.out == report::summary_text(report::read_json(desk.path() / "out")) + "\nReport: out/report.html\n");
}

TEST_CASE("a reference is computed once for all runs, and every report says where it came from") {
  const TinyDesk desk;
  const Environment cache{{"MOIRE_CACHE", (desk.path() / "cache").string()}};
  const auto run = [&](const char* folder, std::vector<std::string> more = {}) {
    std::vector<std::string> arguments{"run", "tiny", "-o", folder};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Ended ended = desk.moire(arguments, cache);
    CHECK(ended.code == 0);
    return ended.err;
  };
  const std::string first = run("first");
  CHECK(has(first, "\nhills: reference area["));
  CHECK(has(first, " (computed now)\n"));
  CHECK(desk.files("cache/references").size() == 2);
  const std::string second = run("second");
  CHECK(has(second, " (kept from before)\n"));
  CHECK(desk.files("first/images") == desk.files("second/images"));
  CHECK(desk.bytes("first/results.csv") == desk.bytes("second/results.csv"));

  const auto origin = [&](const char* folder) {
    return report::read_json(desk.path() / folder).scenes.at(0).reference_origin;
  };
  CHECK(origin("first") == "computed now");
  CHECK(origin("second") == "kept from before");
  CHECK(has(desk.bytes("second/report.html"), "kept from before"));
  CHECK(has(desk.bytes("second/manifest.json"), "kept from before"));

  CHECK(has(run("third", {"--fresh-references"}), " (computed now)\n"));
  // Another seed is no other reference where none draws random numbers; another image is.
  CHECK(has(run("fourth", {"--set", "seed=9"}), " (kept from before)\n"));
  CHECK(has(run("fifth", {"--set", "image.width=25"}), " (computed now)\n"));
}

TEST_CASE("references are kept in the .cache of the project, and nowhere without one") {
  const TinyDesk desk;
  REQUIRE(desk.moire({"run", "tiny", "-o", "out"}).code == 0);
  CHECK_FALSE(std::filesystem::exists(desk.path() / ".cache"));
  desk.file("configs/readme.md", "A project.");
  REQUIRE(desk.moire({"run", "tiny", "-o", "out"}).code == 0);
  CHECK(desk.files(".cache/references").size() == 2);
}

TEST_CASE("a cache that cannot be used costs nothing but time") {
  const TinyDesk desk;
  desk.file("cache", "a file");
  const Ended ended = desk.moire({"run", "tiny", "-o", "out"}, {{"MOIRE_CACHE", "cache"}});
  CHECK(ended.code == 0);
  CHECK(has(ended.err, " (computed now; not kept, cache/references: "));
}

TEST_CASE("a sampler that may be missing is left out with a note, and the run is whole") {
  const TinyDesk desk(tiny_experiment(R"(["point", {"type": "skia", "if_installed": true, "fast": true}])"));
  const std::string note = "samplers[1]: \"skia\" is left out: no such sampler is installed\n";
  const Ended run = desk.moire({"run", "tiny", "-o", "out"}), check = desk.moire({"check", "tiny"});
  CHECK(run.code == 0);
  CHECK(run.err.starts_with(note));
  CHECK(samplers_in(report::read_json(desk.path() / "out")) == Names{"hills/point"});
  CHECK(has(desk.bytes("out/report.html"), "is left out"));
  CHECK(check.code == 0);
  CHECK(check.err == note);
  CHECK(check.out == "tiny: 1 scene, 1 sampler, 2 metrics: nothing is wrong.\n");
}

TEST_CASE("the reference is timed unless speed is told not to") {
  const TinyDesk desk(tiny_experiment(R"(["point"])", R"([{"type": "speed", "rounds": 1}])"));
  const auto timed = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"run", "tiny", "-o", "out"});
    REQUIRE(desk.moire(more).code == 0);
    return samplers_in(report::read_json(desk.path() / "out"));
  };
  CHECK(timed({}) == Names{"hills/nothing", "hills/point", "hills/reference"});
  CHECK(timed({"--set", "metrics[0].reference=false"}) == Names{"hills/nothing", "hills/point"});
}

TEST_CASE("the experiment that a run leaves gives the same images again, and the same experiment") {
  const TinyDesk desk;
  CHECK(desk.moire({"run", "tiny", "-o", "first"}).code == 0);
  CHECK(desk.moire({"run", "first/experiment.json", "-o", "second"}).code == 0);
  CHECK(desk.files("second/images") == desk.files("first/images"));
  CHECK(desk.bytes("second/experiment.json") == desk.bytes("first/experiment.json"));
  CHECK(desk.bytes("second/results.csv") == desk.bytes("first/results.csv"));
}

TEST_CASE("the number of threads changes nothing") {
  const TinyDesk desk;
  CHECK(desk.moire({"run", "tiny", "-o", "one", "-j", "1", "--set", "image.width=100"}).code == 0);
  CHECK(desk.moire({"run", "tiny", "-o", "two", "-j", "2", "--set", "image.width=100"}).code == 0);
  CHECK(desk.files("two/images") == desk.files("one/images"));
  CHECK(desk.bytes("two/results.csv") == desk.bytes("one/results.csv"));
}

TEST_CASE("more threads than cores are no reason for a warning") {
  const TinyDesk desk;
  const Ended ended = desk.moire({"run", "tiny", "-o", "many", "-j", "64"});
  CHECK(ended.code == 0);
  CHECK(ended.err.find("TBB") == std::string::npos);
}

TEST_CASE("a --set changes values, and the result says so") {
  const TinyDesk desk;
  const Ended ended =
      desk.moire({"run", "tiny", "-o", "out", "--set", "image.width=8", "--set", "samplers[1].n=[2, 3]"});
  CHECK(ended.code == 0);
  const Results results = report::read_json(desk.path() / "out");
  CHECK(results.width == 8);
  CHECK(samplers_in(results) == Names{"hills/point", "hills/supersample[n=2]", "hills/supersample[n=3]"});
  CHECK(results.manifest.at("command") == nlohmann::ordered_json{"moire", "run", "tiny", "-o", "out", "--set",
                                                                 "image.width=8", "--set", "samplers[1].n=[2, 3]"});
}

TEST_CASE("an --only runs a part") {
  const TinyDesk desk;
  CHECK(desk.moire({"run", "tiny", "-o", "out", "--only", "hills/supersample"}).code == 0);
  CHECK(samplers_in(report::read_json(desk.path() / "out")) == Names{"hills/supersample[n=2]"});
  CHECK(desk.moire({"run", "tiny", "--only", "/pont"}).err ==
        "--only /pont: the experiment has no sampler \"pont\"; did you mean \"point\"? it has point, "
        "supersample[n=2]\n");
}

TEST_CASE("a report can be made again from the results alone, and is the same") {
  const TinyDesk desk;
  CHECK(desk.moire({"run", "tiny", "-o", "out"}).code == 0);
  const Files files = desk.files("out");
  std::filesystem::remove(desk.path() / "out/report.html");
  const Ended again = desk.moire({"report", "out"});
  CHECK(again.code == 0);
  CHECK(again.out == "Report: out/report.html\n");
  CHECK(desk.files("out") == files);

  const Ended none = desk.moire({"report", "tiny"});
  CHECK(none.code == 2);
  CHECK(none.err == "tiny/results.json: cannot be read (No such file or directory); a readable file is needed\n");
}

TEST_CASE("Ctrl-C ends a run cleanly: what is finished is kept and reported") {
  const TinyDesk desk(tiny_experiment(R"(["point", "slow", "supersample"])"));
  Running run(desk.path(),
              {"run", "tiny", "-o", "out", "-j", "1", "--plugins", APP_PLUGINS, "--set", "image.width=640"});
  REQUIRE(run.wait_for("[3/4] hills / slow\n"));
  run.interrupt();
  const Ended ended = run.wait();
  CHECK(ended.code == 1);
  CHECK(without_references(ended.err) == "[1/4] hills / reference\n[2/4] hills / point\n[3/4] hills / slow\n");
  CHECK(ended.out.find("\ninterrupted: only what had finished is shown\n") != std::string::npos);

  const Results results = report::read_json(desk.path() / "out");
  CHECK(results.interrupted);
  CHECK(results.failures.empty());
  CHECK(samplers_in(results) == Names{"hills/point"});
  const std::string csv = desk.bytes("out/results.csv");
  CHECK(csv.starts_with("scene,sampler,metric,value,low,high,unit\r\nhills,point,error.rmse,"));
  CHECK(std::count(csv.begin(), csv.end(), ',') == 6 * std::count(csv.begin(), csv.end(), '\n'));
  CHECK(csv.ends_with("\r\n"));
  CHECK(desk.bytes("out/report.html").find("This run was interrupted.") != std::string::npos);
  for (const auto& [name, bytes] : desk.files("out")) {
    CHECK(name.find(".part") == std::string::npos);
    CHECK(name.find("/slow/") == std::string::npos);
  }
}

}  // namespace moire::test
