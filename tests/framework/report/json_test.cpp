#include "report/json.h"

#include <catch2/catch_test_macros.hpp>
#include <cmath>

#include "framework/report/approved.h"
#include "framework/report/sample_results.h"
#include "message_of.h"
#include "temporary_folder.h"

namespace moire::test {

TEST_CASE("results.json holds all that a run found out") {
  const std::string text = report::to_json(sample_results()).dump(2) + '\n';
  CHECK(text == approved("results.json", text));
}

TEST_CASE("results read back are those that were written, not-a-number and infinity too") {
  const TemporaryFolder folder;
  const Results written = sample_results();
  report::write_json(folder.path(), written);
  const Results read = report::read_json(folder.path());

  CHECK(report::to_json(read) == report::to_json(written));
  CHECK(read.manifest == written.manifest);
  CHECK(std::isnan(read.rows[0].low));
  CHECK(std::isinf(read.rows[3].value));
  CHECK(read.rows[13].value == 0.015625);
}

TEST_CASE("a number keeps all its bits in results.json") {
  Results results = sample_results();
  for (double value : {0.1, 1.0 / 3, 5e-324, 1.7976931348623157e308, -0.0}) {
    results.rows[0].value = value;
    const auto json = nlohmann::ordered_json::parse(report::to_json(results).dump());
    const double read = report::results_from_json(json, "here").rows[0].value;
    CHECK(read == value);
    CHECK(std::signbit(read) == std::signbit(value));
  }
}

TEST_CASE("a file that does not hold results is refused with its name and what is wrong") {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "results.json").string();
  const auto read = [&] { report::read_json(folder.path()); };

  CHECK(message_of(read) == file + ": cannot be read (No such file or directory); a readable file is needed");

  folder.file("results.json", "{");
  CHECK(message_of(read) ==
        file +
            ": is not JSON (parse error at line 1, column 2: syntax error while parsing object key - "
            "unexpected end of input; expected string literal); run the experiment again to write it "
            "anew");

  folder.file("results.json", R"({"format_version": 7})");
  CHECK(message_of(read) == file + ": has another format (version 7); this program reads version 2");

  folder.file("results.json", R"({"format_version": 2})");
  CHECK(message_of(read) ==
        file + ": is not a file of results (key 'experiment' not found); run the experiment again to write it anew");
}

}  // namespace moire::test
