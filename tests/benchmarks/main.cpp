// Benchmarks of the foundation: what the plugin boundary, recording and each method cost, as ratios of one process.
#include <cstdlib>
#include <string_view>

#include <fmt/format.h>

#include "adaptive.h"
#include "curves.h"
#include "curves_exact.h"
#include "drawings.h"
#include "filters.h"
#include "interleaved.h"
#include "lookups.h"
#include "packet.h"
#include "patterns.h"
#include "plane.h"
#include "sampling/lookups.h"
#include "shadows.h"
#include "soft_pixels.h"
#include "terrain_truth.h"
#include "terrain_views.h"

namespace moire::benchmark {

namespace {

constexpr ImageSize size{400, 400};
constexpr int rounds = 15;

void print(const char* question, const Ratio& r, const char* goal) {
  fmt::print("    {:<52} {:5.2f}  ({:.2f} .. {:.2f})   {}\n", question, r.median, r.low, r.high, goal);
}

// A scene at one of the views, and how to render frames of it.
class Bench {
 public:
  Bench(const Catalog& catalog, const TerrainView& view)
      : catalog_(catalog),
        settings_(terrain_settings(catalog, view)),
        scene_(catalog.find(Kind::scene, "heightfield")->scene->make(settings_)),
        frame_(scene_->frame(settings_, size)),
        one_piece_(settings_, size) {}

  void run() {
    side_by_side();
    methods();
    coherence();
    threads();
  }

 private:
  Work frame_of(const std::string& name, const Contender& contender, const Frame& frame, bool recording,
                const Workers& workers) {
    return {name, [&contender, &frame, recording, &workers, this] {
              const auto rendering = contender.begin(frame, 1);
              std::vector<Counters> blocks(workers.blocks(size, Workers::order(*rendering, recording)));
              workers.render(*rendering, frame, recording,
                             [&](std::size_t index, const PixelBlock& block) { blocks[index] = block.counters; });
              counters_ = {};
              for (const Counters& block : blocks) counters_ += block;
            }};
  }
  Work one_piece(const std::string& name, void (OnePiece::*loop)(PixelBlock&) const) {
    return {name, [this, loop] {
              one_.for_each_block(*frame_, false, Blocks::columns,
                                  [&](std::size_t, PixelBlock& block) { (one_piece_.*loop)(block); });
            }};
  }

  // Columns of `area` in the lanes of vectors, and one by one.
  void side_by_side() {
    const auto across = make_lookup("linear_across");
    const auto nearest = contender(catalog_, "area", {});
    const auto linear = contender(catalog_, "area", {}, "linear_across");
    const auto alone = [&](const Lookup* lookup) {
      return Work{"one by one", [this, lookup] {
                    one_.render(OneByOne(*frame_, lookup), *frame_, false, [](std::size_t, const PixelBlock&) {});
                  }};
    };
    const auto t = interleaved({frame_of("nearest", *nearest, *frame_, false, one_), alone(nullptr),
                                frame_of("linear across", *linear, *frame_, false, one_), alone(across.get())},
                               rounds);
    frame_of("nearest", *nearest, *frame_, false, one_).run();
    const auto steps = static_cast<double>(counters_.steps);
    const auto show = [&](const char* lookup, const Timing& many, const Timing& one) {
      const double step = 1e6 * many.median() / steps;
      fmt::print(
          "    area, {}: {:.2f} ms a frame with {} columns side by side (one by one {:.1f}); {:.1f} ns a voxel step, "
          "where gathering cells takes about 1\n",
          lookup, many.median(), heightfield::lanes_of_packets(), one.median(), step);
      print("area: side by side over one by one", ratio(many, one), "<= 0.5");
    };
    show("nearest colour", t[0], t[1]);
    show("linear across", t[2], t[3]);
  }

  void methods() {
    const auto point = contender(catalog_, "point", {});
    const auto area = contender(catalog_, "area", {});
    const auto sixteen = contender(catalog_, "supersample", {{"n", std::int64_t{16}}});
    const auto t = interleaved(
        {frame_of("point", *point, *frame_, false, one_),
         frame_of("area", *area, *frame_, false, one_),
         frame_of("supersample 16", *sixteen, *frame_, false, one_),
         one_piece("point in one piece", &OnePiece::point),
         one_piece("area in one piece", &OnePiece::area),
         frame_of("point recorded", *point, *frame_, true, one_),
         frame_of("area recorded", *area, *frame_, true, one_),
         frame_of("supersample 16 recorded", *sixteen, *frame_, true, one_),
         {"area one by one",
          [this] { one_.render(OneByOne(*frame_, nullptr), *frame_, false, [](std::size_t, const PixelBlock&) {}); }}},
        rounds);
    frame_of("point", *point, *frame_, false, one_).run();
    const double steps = static_cast<double>(counters_.steps);
    fmt::print(
        "    point {:.1f} ms, area {:.1f} ms, supersample 16 {:.1f} ms a frame; {:.1f} and {:.1f} ns a voxel step "
        "(9 to 12 and 11 to 14 measured before)\n",
        t[0].median(), t[1].median(), t[2].median(), 1e6 * t[0].median() / steps, 1e6 * t[1].median() / steps);
    print("point: plugins over one piece", ratio(t[0], t[3]), "<= 1.05");
    print("area one by one: plugins over one piece", ratio(t[8], t[4]), "<= 1.05");
    print("point: recorded over not", ratio(t[5], t[0]), "<= 1.3");
    print("supersample 16: recorded over not", ratio(t[7], t[2]), "<= 1.3");
    print("area: recorded over not, one by one", ratio(t[6], t[8]), "<= 2.5");
    print("area over point", ratio(t[1], t[0]), "<= 1.15");
    print("area one by one over point", ratio(t[8], t[0]), "");
    print("supersample 16 over area", ratio(t[2], t[1]), ">= 1.5");
    print("supersample 16 over area one by one", ratio(t[2], t[8]), ">= 1.5");
  }

  void coherence() {
    Settings restart = settings_;
    restart.set("coherence", std::string("none"));
    const auto restarting = scene_->frame(restart, size);
    const auto point = contender(catalog_, "point", {});
    const Work resume = frame_of("resume", *point, *frame_, false, one_);
    const Work none = frame_of("none", *point, *restarting, false, one_);
    const auto t = interleaved({none, resume}, 5);
    resume.run();
    const double few = static_cast<double>(counters_.steps);
    none.run();
    const double many = static_cast<double>(counters_.steps);
    print("restart at the relief's top over resume, time", ratio(t[0], t[1]), "4.2 to 7.7 measured before");
    fmt::print("    {:<52} {:5.2f}\n", "restart at the relief's top over resume, steps", many / few);
  }

  void threads() {
    const Workers two(2);
    const auto area = contender(catalog_, "area", {});
    const auto t =
        interleaved({frame_of("one", *area, *frame_, false, one_), frame_of("two", *area, *frame_, false, two)}, rounds,
                    Clock::wall);
    print("area: one thread over two", ratio(t[0], t[1]), ">= 1.8 where two cores are free");
  }

  const Catalog& catalog_;
  Settings settings_;
  std::unique_ptr<Scene> scene_;
  std::unique_ptr<Frame> frame_;
  OnePiece one_piece_;
  const Workers one_{1};
  Counters counters_;
};

// Passing over hidden voxels, on ground so rough that most is hidden.
void hidden_runs(const Catalog& catalog) {
  Settings settings = terrain_settings(catalog, views[2]);
  settings.set("height_scale", 300.0 / 43798);
  const auto scene = catalog.find(Kind::scene, "heightfield")->scene->make(settings);
  const Workers one(1);
  for (const std::string levels : {"floor", "none"}) {
    settings.set("levels", levels);
    std::vector<std::unique_ptr<Frame>> frames;
    std::vector<Work> works;
    const auto area = contender(catalog, "area", {});
    for (const char* skip : {"off", "auto"}) {
      settings.set("skip", std::string(skip));
      frames.push_back(scene->frame(settings, size));
      const Frame* frame = frames.back().get();
      const auto ignore = [](std::size_t, const PixelBlock&) {};
      works.push_back({skip, [&, frame, ignore] { one.render(*area->begin(*frame, 1), *frame, false, ignore); }});
      works.push_back({skip, [&, frame, ignore] { one.render(OneByOne(*frame, nullptr), *frame, false, ignore); }});
    }
    const auto t = interleaved(works, 5);
    fmt::print("  pitch 5, relief 300, levels {}: {:.1f} ms side by side, {:.1f} one by one\n", levels, t[2].median(),
               t[3].median());
    print("side by side: skip auto over off", ratio(t[2], t[0]), levels == "floor" ? "<= 1.05" : "<= 0.6");
    print("one by one: skip auto over off", ratio(t[3], t[1]), levels == "floor" ? "<= 1.05" : "<= 0.8");
  }
}

}  // namespace

void run_terrain(const Catalog& catalog) {
  fmt::print(
      "Median of {} rounds (quartiles), time of one thread, 400 x 400 pixels, Puget Sound, relief 30, levels floor.\n",
      rounds);
  for (const TerrainView& view : views) {
    fmt::print("  pitch {}\n", view.pitch_deg);
    Bench(catalog, view).run();
  }
  hidden_runs(catalog);
}

}  // namespace moire::benchmark

// `moire_benchmarks` runs all; the name of a part behind it, that part alone.
int main(int argc, char** argv) {
  using namespace moire;
  if (!std::getenv("MOIRE_DATA")) {
    fmt::print(stderr, "moire_benchmarks: MOIRE_DATA is not set; point it at the data folder (terrain/puget_sound)\n");
    return 2;
  }
  const Catalog catalog = Catalog::open(plugin_folders({}));
  const auto is_wanted = [&](std::string_view part) { return argc < 2 || argv[1] == part; };
  if (is_wanted("adaptive")) benchmark::run_adaptive(catalog);
  if (is_wanted("curves")) benchmark::run_curves();
  if (is_wanted("curves_exact")) benchmark::run_curves_exact();
  if (is_wanted("filters")) benchmark::run_filters(catalog);
  if (is_wanted("drawings")) benchmark::run_drawings(catalog);
  if (is_wanted("patterns")) benchmark::run_patterns(catalog);
  if (is_wanted("plane")) benchmark::textured_plane(catalog);
  if (is_wanted("shadows")) benchmark::run_shadows(catalog);
  if (is_wanted("soft_pixels")) benchmark::run_soft_pixels();
  if (is_wanted("terrain")) benchmark::run_terrain(catalog);
  if (is_wanted("lookups")) benchmark::run_lookups();
  if (is_wanted("truth")) benchmark::terrain_truth(catalog);
}
