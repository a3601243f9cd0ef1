// Plugins that cannot be used, and plugins that fail at work.
#include <fmt/format.h>
#include <catch2/catch_test_macros.hpp>
#include <set>

#include "app/program.h"
#include "app/tiny_experiment.h"
#include "framework/loading/changed_record.h"
#include "report/json.h"

namespace moire::test {

namespace {

std::string good() { return bytes_of(TEST_PLUGINS "/good_sampler.so"); }

// The message about a folder of plugins with these files in it.
std::string refusal(const Desk& desk) {
  const Ended ended = desk.moire({"list", "--plugins", "plugins"});
  CHECK(ended.code == 2);
  CHECK(ended.out == "");
  return ended.err;
}

std::string refusal(std::string_view name, std::string_view bytes) {
  const Desk desk;
  desk.file(std::filesystem::path("plugins") / name, bytes);
  return refusal(desk);
}

}  // namespace

TEST_CASE("files that cannot be plugins of this program are refused, each with its reason") {
  std::string other = good();
  change_record(other, [](Record& record) { record.interface_version = 7; });
  CHECK(refusal("other.so", other) ==
        fmt::format("plugins/other.so: was built for another interface (version 7); this program takes version {}: "
                    "rebuild the plugin with this program's SDK\n",
                    interface_version));
  CHECK(refusal("note.so", "Remember the milk.\n") ==
        "plugins/note.so: is no shared object (it has no ELF header); a plugin is built with moire_add_sampler or "
        "moire_add_scene\n");
  const std::string whole = good();
  CHECK(refusal("half.so", whole.substr(0, whole.size() / 2)) ==
        fmt::format("plugins/half.so: is cut short ({} bytes of {}); build or copy it again\n", whole.size() / 2,
                    whole.size()));
  CHECK(refusal("throwing.so", bytes_of(TEST_PLUGINS "/throwing.so")) ==
        "plugins/throwing.so: threw an exception while it was opened (no table for this machine); a plugin's static "
        "objects must not throw\n");
}

TEST_CASE("two plugins of one name are refused with both files") {
  const Desk desk;
  desk.file("plugins/a.so", good());
  desk.file("plugins/b.so", good());
  CHECK(refusal(desk) ==
        "plugins/b.so: is a second sampler \"good\" (the first is plugins/a.so); remove or rename one of them\n");
}

TEST_CASE("a folder of plugins that is none is refused") {
  const Ended ended = Desk().moire({"list", "--plugins", "nowhere"});
  CHECK(ended.code == 2);
  CHECK(ended.err == "--plugins: is no folder (\"nowhere\"); name one that has plugins in it\n");
}

TEST_CASE("a stripped plugin is as good as before") {
  const Desk desk;
  const auto file = desk.file("plugins/good.so", good());
  REQUIRE(std::system((STRIP " " + file.string()).c_str()) == 0);
  CHECK(desk.moire({"list", "samplers", "--plugins", "plugins"})
            .out.find("  good             A sampler without fault.\n") != std::string::npos);
  const Ended rendered = desk.moire({"render", "heightfield", "good", "--plugins", "plugins", "--set", "scene.size=64",
                                     "--width", "8", "--height", "8"});
  CHECK(rendered.code == 0);
  CHECK(rendered.out == "picture.png: good on heightfield[size=64]\n");
}

TEST_CASE("a sampler that throws costs its own rows, which say why") {
  const Desk desk;
  desk.file("tiny/experiment.json",
            tiny_experiment(R"(["point", "throws_in_points", "throws_in_begin", "supersample"])",
                            R"(["error", {"type": "speed", "rounds": 1}])"));
  const Ended ended = desk.moire({"run", "tiny", "-o", "out", "--plugins", APP_PLUGINS});
  CHECK(ended.code == 1);
  CHECK(without_references(ended.err) ==
        "[1/6] hills / reference\n[2/6] hills / point\n[3/6] hills / throws_in_points\n"
        "hills / throws_in_points: failed: the table is empty\n[4/6] hills / throws_in_begin\n"
        "hills / throws_in_begin: failed: threw something that is no std::exception\n[5/6] hills / supersample\n"
        "[6/6] hills / speed\n");

  const Results results = report::read_json(desk.path() / "out");
  REQUIRE(results.failures.size() == 2);
  CHECK(results.failures[0].sampler == "throws_in_points");
  CHECK(results.failures[0].message == "the table is empty");
  CHECK(results.failures[1].sampler == "throws_in_begin");
  CHECK(results.failures[1].message == "threw something that is no std::exception");

  std::map<std::string, std::set<std::string>> metrics;
  for (const Row& row : results.rows) metrics[row.sampler].insert(row.metric);
  CHECK(metrics.at("point").size() == 8);
  CHECK(metrics.at("supersample") == metrics.at("point"));
  CHECK_FALSE(metrics.contains("throws_in_points"));
  CHECK_FALSE(metrics.contains("throws_in_begin"));

  for (const char* name : {"throws_in_points", "throws_in_begin"}) {
    CHECK(ended.out.find("  " + std::string(name) + "  ") != std::string::npos);
  }
  CHECK(ended.out.find("\nfailed: throws_in_points on hills: the table is empty\n") != std::string::npos);
  CHECK(desk.bytes("out/report.html").find("the table is empty") != std::string::npos);
}

TEST_CASE("a sampler that throws in one frame keeps what the still gave, and the others have their frames") {
  const Desk desk;
  desk.file("tiny/experiment.json", tiny_experiment(R"(["throws_in_frame_1", "point"])", R"(["error", "flicker"])"));
  const Ended ended = desk.moire({"run", "tiny", "-o", "out", "--plugins", APP_PLUGINS, "--set", "frames.count=3",
                                  "--set", "pictures=column_over_time"});
  CHECK(ended.code == 1);
  CHECK(ended.err.find("hills / throws_in_frame_1: failed: frame 1: no sequels\n") != std::string::npos);
  const Results results = report::read_json(desk.path() / "out");
  REQUIRE(results.failures.size() == 1);
  CHECK(results.failures[0].sampler == "throws_in_frame_1");
  CHECK(results.failures[0].message == "frame 1: no sequels");
  std::set<std::string> judged, flickering, drawn;
  for (const Row& row : results.rows) {
    (row.metric.starts_with("flicker.") ? flickering : judged).insert(row.sampler);
  }
  for (const ImageResult& image : results.images) {
    if (image.kind == "column_over_time") drawn.insert(image.sampler);
  }
  CHECK(judged.size() == 2);
  CHECK(judged.contains("throws_in_frame_1"));
  for (const auto& names : {flickering, drawn}) {
    CHECK(names.size() == 2);
    CHECK(names.contains("point"));
    CHECK(names.contains("reference"));
  }
}

}  // namespace moire::test
