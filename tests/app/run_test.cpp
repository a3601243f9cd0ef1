// `moire run` from the file to the report.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <set>

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

Names samplers_in(const Results& results) {
  Names result;
  for (const Row& row : results.rows) result.insert(row.scene + "/" + row.sampler);
  return result;
}

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

TEST_CASE("progress goes to stderr, a line a job, and the summary to stdout") {
  const TinyDesk desk(tiny_experiment(R"(["point"])", R"(["error", {"type": "speed", "rounds": 1}])"));
  const Ended ended = desk.moire({"run", "tiny", "-o", "out"});
  CHECK(ended.code == 0);
  CHECK(ended.err == "[1/3] hills / reference\n[2/3] hills / point\n[3/3] hills / speed\n");
  CHECK(ended.out == report::summary_text(report::read_json(desk.path() / "out")) + "\nReport: out/report.html\n");
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
  CHECK(ended.err == "[1/4] hills / reference\n[2/4] hills / point\n[3/4] hills / slow\n");
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
