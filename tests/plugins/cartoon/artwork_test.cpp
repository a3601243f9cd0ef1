// The polygons of the scene `cartoon`, and the artwork that they are in one frame after another.
#include <catch2/catch_test_macros.hpp>

#include "message_of.h"
#include "support/plugins.h"
#include "temporary_folder.h"

namespace moire::test {
namespace {

struct Streamed final : PolygonSink {
  struct Kept {
    Element element;
    Color color;
    FillRule rule;
    std::vector<Point> points;
    std::vector<std::uint32_t> contours;
    friend bool operator==(const Kept&, const Kept&) = default;
  };
  std::vector<Kept> kept;

  void polygon(const Polygon& p) override {
    kept.push_back(
        {p.element, p.color, p.rule, {p.points.begin(), p.points.end()}, {p.contours.begin(), p.contours.end()}});
  }
};

constexpr Rectangle everything{-1e9, -1e9, 1e9, 1e9};

// A scene of a file with this content, or of none.
class SmallCartoon {
 public:
  explicit SmallCartoon(std::string_view content = "", const Changes& changes = {})
      : settings_(changed(scene_plugin("cartoon").parameters, changes)) {
    if (!content.empty()) settings_.set("file", folder_.file("drawing", content).string());
    scene_ = scene_plugin("cartoon").make(settings_);
  }

  std::unique_ptr<Frame> frame(const Changes& changes = {}, ImageSize size = {96, 72}) const {
    Settings settings = settings_;
    for (const auto& [name, value] : changes) settings.set(name, value);
    return scene_->frame(settings, size);
  }

 private:
  TemporaryFolder folder_;
  Settings settings_;
  std::unique_ptr<Scene> scene_;
};

constexpr std::string_view two_squares =
    "<svg viewBox='0 0 8 8'><path fill='#f00' d='M0 0H4V4H0Z'/><path fill='#333' fill-rule='evenodd' "
    "d='M2 2H8V8H2Z'/></svg>";

std::uint64_t identity(const Frame& frame) { return frame.polygons()->artwork()->identity(); }

}  // namespace

TEST_CASE("polygons come front to back with elements that count layers from the back") {
  const SmallCartoon cartoon(two_squares);
  const auto frame = cartoon.frame({}, {16, 16});
  CHECK_FALSE(frame->polygons()->disjoint());
  Streamed seen;
  frame->polygons()->stream(everything, seen);
  const auto grey = static_cast<float>(srgb_to_linear(0.2));
  CHECK(seen.kept == std::vector<Streamed::Kept>{
                         {2, {grey, grey, grey}, FillRule::even_odd, {{4, 4}, {16, 4}, {16, 16}, {4, 16}}, {0}},
                         {1, {1, 0, 0}, FillRule::nonzero, {{0, 0}, {8, 0}, {8, 8}, {0, 8}}, {0}}});
  CHECK(frame->polygons()->background_color() == Color{1, 1, 1});
}

TEST_CASE("a window gets the polygons that touch it, whole") {
  const SmallCartoon cartoon(two_squares);
  const auto frame = cartoon.frame({}, {16, 16});
  const auto in = [&](const Rectangle& window) {
    Streamed seen;
    frame->polygons()->stream(window, seen);
    std::string text;
    for (const auto& kept : seen.kept) text += fmt::format("{}:{} ", kept.element, kept.points.size());
    return text;
  };
  CHECK(in({0, 0, 3, 3}) == "1:4 ");
  CHECK(in({0, 0, 4, 4}) == "2:4 1:4 ");
  CHECK(in({12, 12, 14, 14}) == "2:4 ");
  CHECK(in({5, 5, 6, 6}) == "2:4 1:4 ");
  CHECK(in({17, 0, 20, 20}) == "");
}

TEST_CASE("colours are light, or the numbers of the file") {
  const SmallCartoon cartoon(two_squares,
                             {{"blend", std::string("as_stored")}, {"background", std::string("#336699")}});
  const auto frame = cartoon.frame();
  CHECK(frame->blend() == Blend::as_stored);
  CHECK(frame->polygons()->background_color() == Color{0.2F, 0.4F, 0.6F});
  Streamed seen;
  frame->polygons()->stream(everything, seen);
  CHECK(seen.kept.front().color == Color{0.2F, 0.2F, 0.2F});
  CHECK(SmallCartoon(two_squares).frame()->blend() == Blend::linear);
}

TEST_CASE("a background that the drawing names is kept") {
  constexpr std::string_view drawing =
      "{\"background\": \"#ff0000\", \"layers\": [{\"color\": \"#00ff00\", \"contours\": [[[0,0],[1,0],[1,1]]]}]}";
  CHECK(SmallCartoon(drawing).frame()->polygons()->background_color() == Color{1, 0, 0});
}

TEST_CASE("artwork placed in the image is what the polygons are, to the bit") {
  const SmallCartoon cartoon;
  const auto frame = cartoon.frame({{"view.rotation_deg", 33.0}, {"view.zoom", 1.7}, {"view.x", 0.1}});
  Streamed seen, own;
  frame->polygons()->stream(everything, seen);
  const Artwork& artwork = *frame->polygons()->artwork();
  artwork.stream(own);
  for (auto& kept : own.kept) {
    for (Point& p : kept.points) p = artwork.placement()(p);
  }
  CHECK(seen.kept == own.kept);
}

TEST_CASE("artwork stays the same while a zoom stays between two powers of two") {
  // The view box of the built-in cartoon, 240 x 180, fits into 96 x 72 at 0.4 pixels a unit: from 0.25 to 0.5 is zoom
  // 0.625 to 1.25.
  const SmallCartoon cartoon;
  const std::uint64_t first = identity(*cartoon.frame());
  for (const double zoom : {0.63, 0.9, 1.0, 1.25}) {
    for (const double turn : {0.0, 12.0}) {
      CHECK(identity(*cartoon.frame({{"view.zoom", zoom}, {"view.rotation_deg", turn}, {"view.x", 0.3 * zoom}})) ==
            first);
    }
  }
  const std::uint64_t near = identity(*cartoon.frame({{"view.zoom", 1.26}}));
  CHECK(near != first);
  CHECK(identity(*cartoon.frame({{"view.zoom", 0.62}})) != first);
  // Back again it is still known.
  CHECK(identity(*cartoon.frame()) == first);
  CHECK(identity(*cartoon.frame({}, {120, 90})) == first);
  CHECK(identity(*cartoon.frame({{"view.zoom", 2.0}})) == near);
  CHECK(identity(*SmallCartoon().frame()) != first);
}

TEST_CASE("a frame keeps its artwork when the scene has made others") {
  const SmallCartoon cartoon;
  const auto frame = cartoon.frame();
  Streamed before, after;
  frame->polygons()->artwork()->stream(before);
  for (double zoom = 2; zoom < 2000; zoom *= 2) cartoon.frame({{"view.zoom", zoom}});
  frame->polygons()->artwork()->stream(after);
  CHECK(before.kept == after.kept);
}

TEST_CASE("a view 64 times as close has outlines 64 times as fine, so 8 times as many points") {
  const SmallCartoon circle("<svg viewBox='0 0 8 8'><circle cx='4' cy='4' r='4'/></svg>");
  const auto points = [&](double zoom) {
    Streamed seen;
    circle.frame({{"view.zoom", zoom}})->polygons()->artwork()->stream(seen);
    return seen.kept.front().points.size();
  };
  CHECK(points(64) <= 8 * points(1));
  CHECK(points(64) > 8 * (points(1) - 1));
}

TEST_CASE("files that are no drawings are refused by the scene with their name") {
  const TemporaryFolder folder;
  const auto problem = [](const std::string& file) {
    return message_of([&] {
      const ScenePlugin& plugin = scene_plugin("cartoon");
      plugin.make(changed(plugin.parameters, {{"file", file}}));
    });
  };
  const std::string folder_name = folder.path().string();
  CHECK(problem(folder_name) == folder_name + ": cannot be read (Is a directory); a readable file is needed");
  CHECK(problem(folder_name + "/none") ==
        folder_name + "/none: cannot be read (No such file or directory); a readable file is needed");
  CHECK(problem("/dev/zero") == "/dev/zero: cannot be read (Operation not supported); a readable file is needed");
}

}  // namespace moire::test
