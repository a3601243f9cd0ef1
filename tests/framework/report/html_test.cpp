#include "report/html.h"

#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <initializer_list>

#include "files/whole_file.h"
#include "framework/report/sample_results.h"
#include "message_of.h"
#include "report/json.h"
#include "temporary_folder.h"

namespace moire::report {
namespace {

// As much of a PNG as a page looks at; `content` makes it differ from others.
std::string png(int width, int height, const std::string& content) {
  std::string bytes("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16);
  for (int number : {width, height}) {
    for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(number >> shift);
  }
  return bytes + content;
}

// A result folder of the sample; one of its pictures is missing.
class ResultFolder {
 public:
  explicit ResultFolder(const Results& results = test::sample_results()) {
    std::filesystem::create_directories(path() / "images/hill");
    folder_.file("images/hill/reference.png", png(64, 48, "reference"));
    folder_.file("images/hill/point.png", png(64, 48, "point"));
    folder_.file("images/hill/point_absolute.png", png(64, 48, "absolute"));
    write_json(path(), results);
  }
  const std::filesystem::path& path() const { return folder_.path(); }
  std::string page() const {
    write_html(path());
    return test::bytes_of(path() / "report.html");
  }

 private:
  test::TemporaryFolder folder_;
};

std::size_t count(const std::string& text, const std::string& what) {
  std::size_t times = 0;
  for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + what.size())) ++times;
  return times;
}

bool contains(const std::string& text, const std::string& what) { return text.find(what) != std::string::npos; }

}  // namespace

TEST_CASE("a page refers to nothing outside itself") {
  const std::string page = ResultFolder().page();
  CHECK(contains(page,
                 "content=\"default-src &#39;none&#39;; img-src data:; style-src &#39;unsafe-inline&#39;; "
                 "base-uri &#39;none&#39;; form-action &#39;none&#39;\""));
  CHECK(count(page, "url(") == count(page, "url(data:image/png;base64,"));
  CHECK(count(page, "href=") == count(page, "href=\"#"));
  for (const char* way_out : {"src=", "http:", "https:", "<script", "<link", "@import", "<iframe"}) {
    CAPTURE(way_out);
    CHECK_FALSE(contains(page, way_out));
  }
}

TEST_CASE("a page holds every picture once, wherever it is shown") {
  const std::string page = ResultFolder().page();
  for (const char* content : {"reference", "point", "absolute"}) {
    CAPTURE(content);
    CHECK(count(page, base64(png(64, 48, content))) == 1);
  }
  CHECK(count(page, "class=\"picture p1\"") == 4);  // pixel for pixel, magnified, and both of it in one place
}

TEST_CASE("what comes from data is shown as text") {
  const std::string page = ResultFolder().page();
  CHECK(contains(page, "<h1>Is 1 &lt; 2 &amp; &quot;3&quot;?</h1>"));
  CHECK(contains(page, "&lt;b&gt;bad&lt;/b&gt; &quot;one&quot;"));
  CHECK(contains(page, "it threw: &lt;oops&gt; &amp; more"));
  CHECK_FALSE(contains(page, "<b>bad"));
  CHECK_FALSE(contains(page, "<oops>"));
}

TEST_CASE("a scene's section says what it is judged against, where that came from and how good it is") {
  Results results = test::sample_results();
  SceneResult& scene = results.scenes[0];
  CHECK(contains(ResultFolder(results).page(),
                 "Reference: <code>area[lines=32]</code>, computed now. Its own error is 0.250 levels (rmse against "
                 "twice as many lines).</p>"));
  scene.reference_error = std::nan("");
  scene.reference_error_how = "unknown: the experiment names it";
  scene.reference_origin = "kept from before";
  scene.fragments_reference = "area[lines=8]";
  CHECK(contains(ResultFolder(results).page(),
                 "Reference: <code>area[lines=32]</code>, kept from before. Its own error is unknown: the experiment "
                 "names it. Fragments are held against <code>area[lines=8]</code>, on the frame that the contenders "
                 "see.</p>"));
}

TEST_CASE("a chart with what cannot be told says what its hollow points are") {
  Results results = test::sample_results();
  const char* note = "Hollow points are below the reference\u2019s accuracy";
  CHECK(contains(ResultFolder(results).page(), note));
  results.scenes[0].reference_error = 0.05;
  CHECK_FALSE(contains(ResultFolder(results).page(), note));
}

TEST_CASE("changes from frame to frame are bars whose parts are as wide as their shares") {
  Results results = test::sample_results();
  const std::string scene = results.scenes[0].name;
  const auto add = [&](const char* sampler, const char* metric, double share) {
    results.rows.push_back({.scene = scene, .sampler = sampler, .metric = metric, .value = share, .unit = ""});
  };
  add("point", "flicker.changed_by_0", 0.25);
  add("point", "flicker.changed_by_6_up", 0.75);
  add("reference", "flicker.changed_by_0", 1);
  add("reference", "flicker.changed_by_6_up", 0);
  const std::string page = ResultFolder(results).page();
  CHECK(contains(page, "<h3>Changes from frame to frame</h3>"));
  CHECK(count(page, "class=\"shares\"") == 2);
  CHECK(contains(page, "style=\"width:25.000%;background:"));
  CHECK(contains(page, "style=\"width:75.000%;background:"));
  CHECK(contains(page, "style=\"width:100.000%;background:"));
  CHECK(contains(page, "title=\"6 and more: 0.750\""));
  CHECK_FALSE(contains(ResultFolder().page(), "Changes from frame to frame"));
}

TEST_CASE("an analysis shows its statements and its numbers") {
  const std::string page = ResultFolder().page();
  CHECK(contains(page, "<h2>Cost &lt;model&gt;</h2>"));
  CHECK(contains(page, "<li>A step costs 4 ns &amp; a hit 2 ns.</li>"));
  CHECK(contains(page, "<td>4</td><td>3.50</td><td>4.50</td><td>ns</td>"));
}

TEST_CASE("links within a page lead somewhere") {
  const std::string page = ResultFolder().page();
  for (auto at = page.find("href=\"#"); at != std::string::npos; at = page.find("href=\"#", at + 1)) {
    const std::string anchor = page.substr(at + 7, page.find('"', at + 7) - at - 7);
    CAPTURE(anchor);
    CHECK(count(page, " id=\"" + anchor + '"') == 1);
  }
}

TEST_CASE("a picture that is missing, and a contender that was not rendered, are said to be so") {
  const ResultFolder folder;
  const std::string page = folder.page();
  CHECK(contains(page, (folder.path() / "images/hill/area.png").string() +
                           ": cannot be read (No such file or directory); a readable file is needed"));
  CHECK(contains(page, "not rendered in this run"));
}

TEST_CASE("a contender that does not fit a scene has no picture there, and the scene says why") {
  const std::string page = ResultFolder().page();
  CHECK(contains(page, "Left out here: two &lt;points&gt; (no lines &amp; circles)."));
  CHECK(count(page, "two &lt;points&gt;") == 2);  // there, and in the table of contenders
}

TEST_CASE("a file that is no PNG is said to be none") {
  const ResultFolder folder;
  write_whole_file(folder.path() / "images/hill/area.png", "GIF89a");
  CHECK(contains(folder.page(), "area.png: is no PNG (6 bytes); run the experiment again to write it anew"));
}

TEST_CASE("a page shows no file from outside its folder") {
  Results results = test::sample_results();
  results.images[0].file = "images/../../secret.png";
  const ResultFolder folder(results);
  CHECK(contains(folder.page(), "images/../../secret.png: is not shown (it lies outside " + folder.path().string() +
                                    "); pictures lie below the result folder"));
}

TEST_CASE("error maps have one scale a row; those of another scale have a row of their own") {
  Results results = test::sample_results();
  const auto& map = results.images.emplace_back(
      ImageResult{"hill, steep", "area", "error_absolute", "images/hill/point_absolute.png", 40});
  CHECK(count(ResultFolder(results).page(), "class=\"scale\"") == 1);
  results.images.back().scale = map.scale + 1;
  CHECK(count(ResultFolder(results).page(), "class=\"scale\"") == 2);
}

TEST_CASE("pictures of how a method samples have a title and a caption, and not the error of the image") {
  Results results = test::sample_results();
  const std::size_t errors = count(ResultFolder(results).page(), "error.rmse 12.5");
  results.images.push_back(
      {"hill, steep", "point", "enlarged_pixel_2", "images/hill/point.png", 0, "Pixel (1, 2): 3 < 4 fragments"});
  const std::string page = ResultFolder(results).page();
  CHECK(contains(page, "<h3>Enlarged pixel 2</h3>"));
  CHECK(contains(page, "<span class=\"what\">Pixel (1, 2): 3 &lt; 4 fragments</span>"));
  CHECK(count(page, "error.rmse 12.5") == errors);
  CHECK(errors > 0);
}

TEST_CASE("an interrupted run says so, a whole one does not") {
  Results results = test::sample_results();
  CHECK_FALSE(contains(ResultFolder(results).page(), "This run was interrupted."));
  results.interrupted = true;
  CHECK(contains(ResultFolder(results).page(), "This run was interrupted."));
}

TEST_CASE("the detail is the window that the run chose, or the middle of the image") {
  Results results = test::sample_results();
  CHECK(contains(ResultFolder(results).page(), "The framed window of 16 \u00d7 16 pixels at (8, 0)."));
  results.scenes[0].detail_window = {60, 0, 16, 16};
  CHECK(contains(ResultFolder(results).page(), "The framed window of 48 \u00d7 48 pixels at (8, 0)."));
}

TEST_CASE("bytes as base64 are as in RFC 4648, section 10") {
  CHECK(base64("") == "");
  CHECK(base64("f") == "Zg==");
  CHECK(base64("fo") == "Zm8=");
  CHECK(base64("foo") == "Zm9v");
  CHECK(base64("foobar") == "Zm9vYmFy");
}

}  // namespace moire::report
