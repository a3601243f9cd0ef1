// Hard cases of the scene `textured_plane`, each with its outcome. Where the others stand:
//
//   horizon in the picture, within a row, between two; not in it     strips_test, quadtree_test (views)
//   straight down, nearly so; straight up                            strips_test, quadtree_test (views)
//   far limit in the picture, beyond it, behind it                   strips_test, quadtree_test (views)
//   many pixels a texel, many texels a pixel                         strips_test, quadtree_test (views)
//   yaw off the axes by 1e-7 degrees; roll of 90, 180, 360 degrees   quadtree_test, strips_test (views)
//   points outside the picture                                       trace_test
#include <catch2/catch_test_macros.hpp>
#include <limits>

#include <moire/image.h>

#include "message_of.h"
#include "plugins/textured_plane/compared.h"
#include "support/plugins.h"
#include "temporary_folder.h"

namespace moire::test {
namespace {

using textured_plane::PlaneFrame;

const Camera usual{
    .size = {15, 18}, .x = 3.25, .y = -1.5, .height = 3, .far = 60, .yaw_deg = 90, .pitch_deg = -10, .fov_deg = 60};

PixelBlock averaged(const Camera& camera, const Texels& texels, bool recording = false) {
  PixelBlock block({0, 0, camera.size.width, camera.size.height}, recording);
  PlaneFrame(camera, texels, {0, 0, 0}, 1e-4).averages()->integrate(nullptr, block);
  return block;
}

std::vector<Camera> straight_and_turned(Camera camera) {
  std::vector<Camera> both{camera};
  camera.yaw_deg += 34;
  camera.roll_deg = 5;
  both.push_back(camera);
  return both;
}

std::unique_ptr<Frame> frame_of(const Changes& changes, ImageSize size = {16, 16}) {
  static std::vector<std::unique_ptr<Scene>> scenes;  // a scene outlives its frames
  const ScenePlugin& plugin = scene_plugin("textured_plane");
  const Settings settings = changed(plugin.parameters, changes);
  return scenes.emplace_back(plugin.make(settings))->frame(settings, size);
}

}  // namespace

TEST_CASE("ground of one colour has that colour, near and far") {
  const Color grey{0.1F, 0.7F, 1.0F / 3};
  for (const Wrap wrap : {Wrap::repeat, Wrap::mirror, Wrap::clamp}) {
    const Texels texels(std::vector<Color>(35, grey), 7, 5, wrap);
    CHECK(texels.mean() == grey);
    for (Camera camera : straight_and_turned(usual)) {
      camera.pitch_deg = -40;
      camera.far = 3;
      const PixelBlock block = averaged(camera, texels);
      for (std::size_t k = 0; k < block.slots(); ++k) REQUIRE(block.color(k) == grey);
    }
  }
}

TEST_CASE("textures of one row, column or texel") {
  for (const auto& [width, height] : {std::pair(1, 1), std::pair(1, 6), std::pair(6, 1), std::pair(2, 1)}) {
    for (const Wrap wrap : {Wrap::repeat, Wrap::mirror, Wrap::clamp}) {
      const Texels texels = random_texels(width, height, wrap);
      for (const Camera& camera : straight_and_turned(usual)) {
        const PlaneFrame frame(camera, texels, {0, 0, 0}, 1e-4);
        for (int y = 4; y < camera.size.height; y += 3) {
          for (int x = 0; x < camera.size.width; x += 5) {
            CAPTURE(width, height, static_cast<int>(wrap), camera.roll_deg, x, y);
            const Clipped exact = clipped(camera, texels, x, y);
            if (exact.weights.contains(textured_plane::far_ground)) continue;
            PixelBlock block({x, y, 1, 1}, true);
            const double bound = frame.averages()->integrate(nullptr, block);
            REQUIRE(color_error(block.sum(0), exact) <= bound + 1e-12);
            REQUIRE(weight_error(block, 0, exact) <= 1e-12);
          }
        }
      }
    }
  }
}

// 14 million texels are whole copies of seven, an even number of them.
TEST_CASE("far from the texture's corner the plane has the same bits as near it") {
  for (const Wrap wrap : {Wrap::repeat, Wrap::mirror}) {
    const Texels texels = random_texels(7, 5, wrap);
    for (const Camera& camera : straight_and_turned(usual)) {
      Camera moved = camera;
      moved.x += 14e6;
      moved.y -= 20e6;
      const PixelBlock here = averaged(camera, texels, true), there = averaged(moved, texels, true);
      for (std::size_t k = 0; k < here.slots(); ++k) {
        REQUIRE(here.sum(k) == there.sum(k));
        std::vector<Element> elements, shifted;
        const auto place = [](Element e, std::int64_t i, std::int64_t j) {
          const TexelIndex at = texel_index(e);
          return at.level < 0 ? e : texel_element(at.level, at.i + i, at.j + j);
        };
        here.for_each(k, [&](const Fragment& f) { elements.push_back(place(f.element, 14000000, -20000000)); });
        there.for_each(k, [&](const Fragment& f) { shifted.push_back(f.element); });
        REQUIRE(elements == shifted);
      }
    }
  }
}

TEST_CASE("an image that is clamped goes on without end") {
  const Texels texels = random_texels(7, 5, Wrap::clamp);
  for (Camera camera : straight_and_turned(usual)) {
    camera.pitch_deg = -60;
    camera.x = camera.y = -1e6;
    const PixelBlock block = averaged(camera, texels);
    for (std::size_t k = 0; k < block.slots(); ++k) REQUIRE(block.color(k) == texels.texture().texel(0, 0, 0).color);
  }
}

TEST_CASE("a camera just above the plane sees one texel below the horizon's row, one very high only far ground") {
  const Texels texels = random_texels(7, 5, Wrap::repeat);
  for (Camera camera : straight_and_turned(usual)) {
    camera.pitch_deg = 0;
    camera.size = {15, 17};
    camera.height = 1e-6;
    camera.far = 50;
    const PixelBlock low = averaged(camera, texels, true);
    for (std::size_t k = 0; k < low.slots(); ++k) REQUIRE(std::abs(low.weight(k) - 1) <= 1e-12);
    REQUIRE(low.color(low.slot(7, 16)) == texels.texture().texel(0, 3, -2).color);
    camera.height = 1e9;
    const PixelBlock high = averaged(camera, texels, true);
    REQUIRE(high.color(high.slot(7, 16)) == texels.mean());
  }
}

TEST_CASE("a far limit of 0 leaves the ground behind the camera") {
  const Texels texels = random_texels(7, 5, Wrap::repeat);
  Camera camera = usual;
  camera.far = 0;
  camera.pitch_deg = -90;
  const PixelBlock block = averaged(camera, texels, true);
  // Straight down, the picture's middle row is below the camera.
  block.for_each(block.slot(4, 8), [](const Fragment& f) { CHECK(f.element == textured_plane::far_ground); });
  block.for_each(block.slot(4, 9), [](const Fragment& f) { CHECK(texel_index(f.element).level == 0); });
  CHECK(block.weight(block.slot(4, 8)) == 1);
}

TEST_CASE("the checkerboard's cells are elements of the size asked for, its far ground is their mean") {
  const auto frame = frame_of({{"cell", 4.0},
                               {"view.x", 1.0},
                               {"view.y", 1.0},
                               {"view.pitch_deg", -90.0},
                               {"view.height", 10.0},
                               {"view.yaw_deg", 0.0},
                               {"light", std::string("#ff0000")}});
  const auto hit = [&](double x, double y) {
    const SamplePoint point{x, y};
    Hit seen;
    Counters counters;
    frame->trace(std::span(&point, 1), std::span(&seen, 1), counters);
    return seen;
  };
  // The focal length is 17.2 pixels: a cell is 6.9 of them wide. East is up, south to the right.
  CHECK(hit(8.5, 7.5).element == texel_element(0, 0, 0));
  CHECK(hit(8.5, 7.5).color == Color{1, 0, 0});
  CHECK(hit(8.5, 1).element == texel_element(0, 1, 0));
  CHECK(hit(8.5, 1).color == Color{0, 0, 0});
  CHECK(hit(15, 1).element == texel_element(0, 1, 1));
  CHECK(hit(15, 1).color == Color{1, 0, 0});
  CHECK(hit(8.5, 10).element == texel_element(0, -1, 0));
}

TEST_CASE("texels too far off to have names are refused") {
  CHECK(message_of([] {
          frame_of({{"far", 1e9}, {"cell", 1.0}, {"view.pitch_deg", 0.0}});
        }) ==
        "textured_plane: ground is seen 1.4e+09 texels from the texture's corner; texels have names up to 268435455: "
        "give "
        "a smaller far, or larger texels");
  CHECK(message_of([] { frame_of({{"far", 1e9}, {"cell", 16.0}, {"view.pitch_deg", 0.0}}); }) == "(no error)");
  CHECK(
      message_of([] {
        frame_of({{"view.x", -1e9}, {"cell", 1.0}});
      }) ==
      "textured_plane: ground is seen 1e+09 texels from the texture's corner; texels have names up to 268435455: give "
      "a smaller far, or larger texels");
}

TEST_CASE("a texture that has something else than numbers is refused where it is read") {
  const TemporaryFolder folder;
  for (const float wrong : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    std::vector<Color> pixels(6, Color{0.25F, 0.5F, 1});
    pixels[4].g = wrong;
    const std::filesystem::path file = folder.path() / "colours.exr";
    write_image(file, 3, 2, pixels);
    CHECK(message_of([&] {
            frame_of({{"texture", file.string()}});
          }) == file.string() + ": colour at column 1, row 1 is not a finite number; every texel needs one");
  }
  CHECK(message_of([&] {
          frame_of({{"texture", (folder.path() / "none.png").string()}});
        }).find("none.png") != std::string::npos);
}

TEST_CASE("an image lies on the plane with its own colours in linear light") {
  const TemporaryFolder folder;
  const std::vector<Color> pixels{{0.25F, 0.5F, 1}, {0, 0, 0}, {1, 0.75F, 0.125F}, {0.5F, 0.5F, 0.5F}};
  const std::filesystem::path file = folder.path() / "colours.exr";
  write_image(file, 2, 2, pixels);
  const auto frame = frame_of({{"texture", file.string()}, {"scale", 8.0}, {"wrap", std::string("mirror")}});
  const Texture& texture = frame->surface()->texture();
  CHECK(texture.wrap() == Wrap::mirror);
  for (std::int64_t j = 0; j < 2; ++j) {
    for (std::int64_t i = 0; i < 2; ++i)
      CHECK(texture.texel(0, i, j).color == pixels[static_cast<std::size_t>(2 * j + i)]);
  }
}

}  // namespace moire::test
