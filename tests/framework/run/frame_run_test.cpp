// Passes over frames of a scene made for it, whose samplers deposit what they were called with; and over a terrain.
#include "run/frame_run.h"

#include <algorithm>
#include <atomic>
#include <catch2/catch_test_macros.hpp>
#include <map>
#include <mutex>
#include <optional>
#include <stdexcept>

#include "message_of.h"
#include "support/plugins.h"

namespace moire::test {

namespace {

using namespace parameter;

constexpr ImageSize size{6, 2};
constexpr std::uint64_t seed = 77;

constexpr Parameter scene_parameters[] = {real("time", 0, 0, 1000, "", "").per_frame(),
                                          flag("exact", false, "").per_frame(),
                                          flag("stored", false, "code values are averaged").per_frame()};

// Frames that there are, and the most there ever were.
struct Life {
  std::atomic<int> now = 0, most = 0;

  void begin() {
    const int count = ++now;
    int seen = most;
    while (count > seen && !most.compare_exchange_weak(seen, count)) {
    }
  }
};

class Clock final : public Frame {
 public:
  Clock(const Settings& settings, Life& life)
      : time(static_cast<int>(settings.real("time"))),
        is_exact(settings.flag("exact")),
        blend_(settings.flag("stored") ? Blend::as_stored : Blend::linear),
        life_(life) {
    life_.begin();
  }
  ~Clock() override { --life_.now; }
  Clock(const Clock&) = delete;
  Clock& operator=(const Clock&) = delete;

  ImageSize size() const override { return test::size; }
  Blend blend() const override { return blend_; }
  void trace(std::span<const SamplePoint>, std::span<Hit>, Counters&) const override {}

  const int time;
  const bool is_exact;

 private:
  Blend blend_;
  Life& life_;
};

class Clocks final : public Scene {
 public:
  std::unique_ptr<Frame> frame(const Settings& settings, ImageSize) const override {
    return std::make_unique<Clock>(settings, life);
  }
  mutable Life life;
};

// What a pixel tells: who made it from which frame.
constexpr Element content(int mark, int time, bool is_exact, int x, int y) {
  return static_cast<Element>(((mark * 1000 + time) * 2 + is_exact) * 10000 + x * 100 + y);
}

// Deposits content() in every pixel, in the colour (frame number, seed, time). Throws on frames of one time.
class Telling final : public Sampler {
 public:
  explicit Telling(int mark, int throws_at = -1, bool on_exact = false)
      : mark_(mark), throws_at_(throws_at), on_exact_(on_exact) {}

  std::unique_ptr<Rendering> begin(const RenderRequest& request) const override {
    ++begun;
    const auto& frame = dynamic_cast<const Clock&>(request.frame);
    if (frame.time == throws_at_ && frame.is_exact == on_exact_) throw std::runtime_error("the clock stopped");
    return std::make_unique<Work>(mark_, request);
  }
  mutable std::atomic<int> begun = 0;

 private:
  class Work final : public Rendering {
   public:
    Work(int mark, const RenderRequest& request)
        : mark_(mark), frame_(dynamic_cast<const Clock&>(request.frame)), request_(request) {}
    void render(PixelBlock& block) const override {
      for (int x = block.x0; x < block.x0 + block.width; ++x) {
        for (int y = block.y0; y < block.y0 + block.height; ++y) {
          block.add(block.slot(x, y), content(mark_, frame_.time, frame_.is_exact, x, y), 1,
                    {static_cast<float>(request_.frame_number), static_cast<float>(request_.seed),
                     static_cast<float>(frame_.time)});
        }
      }
    }

   private:
    int mark_;
    const Clock& frame_;
    RenderRequest request_;
  };
  int mark_, throws_at_;
  bool on_exact_;
};

// The reference: mark 9; it throws where its settings say so.
constexpr int reference_mark = 9, fragments_mark = 8;
constexpr Parameter reference_parameters[] = {integer("throws_at", -1, -1, 1000, "", ""), flag("on_exact", false, ""),
                                              integer("mark", reference_mark, 0, 9, "", "")};
constexpr SamplerPlugin reference_plugin{
    .summary = "", .source = "", .parameters = reference_parameters, .make = [](const Settings& settings) {
      return std::unique_ptr<Sampler>(std::make_unique<Telling>(static_cast<int>(settings.integer("mark")),
                                                                static_cast<int>(settings.integer("throws_at")),
                                                                settings.flag("on_exact")));
    }};
const Plugin reference_file{
    .file = {}, .kind = Kind::sampler, .name = "truth", .version = "1", .sampler = &reference_plugin};

References truth(const Changes& changes = {}) {
  const ReferenceChoice one{{"truth", &reference_file, changed(reference_parameters, changes), "nearest"}, {}, true};
  return {one, one};
}

// One call of a pass.
struct Seen {
  int frame;
  PixelBlock own;
  std::optional<PixelBlock> reference;
  std::optional<MergedBlock> exact;
};

class Recorder final : public FramePass {
 public:
  explicit Recorder(const Needs& needs) : needs_(needs) {}
  Needs needs() const override { return needs_; }
  void see(const FrameView& view) override {
    seen.push_back({view.frame, view.own, {}, {}});
    if (view.reference) seen.back().reference = *view.reference;
    if (view.exact) seen.back().exact = *view.exact;
  }
  std::vector<int> frames() const {
    std::vector<int> result;
    for (const Seen& s : seen) result.push_back(s.frame);
    return result;
  }
  std::vector<Seen> seen;

 private:
  Needs needs_;
};

std::vector<int> numbers(int begin, int end) {
  std::vector<int> result;
  for (int k = begin; k < end; ++k) result.push_back(k);
  return result;
}

// A run of some contenders, all with the same passes.
struct Run {
  Clocks scene;
  int count = 11, still = 4;
  bool stored = false;
  std::vector<Needs> needs;
  std::vector<Watched> watched;
  std::vector<double> shares;

  explicit Run(std::vector<Needs> all) : needs(std::move(all)) {}

  const Telling& add(const std::string& name, std::unique_ptr<Telling> sampler) {
    const Telling& kept = *sampler;
    add(name, std::move(sampler), false);
    return kept;
  }
  void add(const std::string& name, std::unique_ptr<Sampler> sampler, bool continues) {
    watch(name, std::make_unique<Contender>(name, std::move(sampler), continues));
  }
  void add_reference() { watch("reference", nullptr); }

  void run(int threads, const References& references = truth()) {
    const auto at = [&](int frame, bool is_exact) {
      return changed(scene_parameters, {{"time", 1.0 * frame}, {"exact", is_exact}, {"stored", stored}});
    };
    const FrameSource source{scene,
                             [&](int frame) { return at(frame, false); },
                             [&](int frame) { return at(frame, true); },
                             size,
                             count,
                             still,
                             seed};
    run_frames(source, references, watched, Workers(threads), [&](double share) { shares.push_back(share); });
  }

  const Recorder& pass(std::size_t contender, std::size_t index = 0) const {
    return dynamic_cast<const Recorder&>(*watched[contender].passes[index]);
  }

 private:
  void watch(const std::string& name, std::unique_ptr<Contender> contender) {
    Watched& w = watched.emplace_back(Watched{name, std::move(contender), {}, {}});
    for (const Needs& n : needs) {
      const bool is_run = w.contender || n.of_reference;
      w.passes.push_back(is_run ? std::make_unique<Recorder>(n) : nullptr);
    }
  }
};

// Every pixel of the block is this content, from a call with this frame's number and the run's seed.
void check_content(const PixelBlock& block, const Columns& columns, int mark, int time, bool is_exact) {
  CHECK(static_cast<const PixelArea&>(block) == PixelArea{columns.x0, 0, columns.width, size.height});
  for (int x = block.x0; x < block.x0 + block.width; ++x) {
    for (int y = 0; y < block.height; ++y) {
      const std::size_t slot = block.slot(x, y);
      CHECK(block.color(slot) == Color{static_cast<float>(time), static_cast<float>(seed), static_cast<float>(time)});
      block.for_each(slot, [&](const Fragment& f) { CHECK(f.element == content(mark, time, is_exact, x, y)); });
    }
  }
}

}  // namespace

TEST_CASE("passes see every frame once and in order, whatever the number of threads and where batches end") {
  for (const int threads : {1, 2}) {
    for (const int count : {1, 2, 4, 5, 11, 16}) {
      CAPTURE(threads, count);
      Run run({{.columns = {1, 2}, .every_frame = true, .fragments = true}});
      run.count = count;
      run.still = count - 1;
      run.add("a", std::make_unique<Telling>(1));
      run.add("b", std::make_unique<Telling>(2));
      run.run(threads);
      for (const int mark : {1, 2}) {
        const Recorder& pass = run.pass(static_cast<std::size_t>(mark - 1));
        CHECK(pass.frames() == numbers(0, count));
        for (const Seen& s : pass.seen) check_content(s.own, {1, 2}, mark, s.frame, false);
        CHECK(run.watched[static_cast<std::size_t>(mark - 1)].failure.empty());
      }
    }
  }
}

TEST_CASE("a pass of the still sees only it, and without others only it is rendered") {
  Run run({{.columns = {0, 1}}, {.columns = {2, 3}, .fragments = true, .exact = true}});
  const Telling& sampler = run.add("a", std::make_unique<Telling>(1));
  run.run(2);
  for (const std::size_t pass : {0U, 1U}) CHECK(run.pass(0, pass).frames() == std::vector{4});
  CHECK(sampler.begun == 1);
  CHECK(run.scene.life.most == 2);  // the contenders' frame and the exact one
  CHECK(run.shares == std::vector{1.0});
}

TEST_CASE("passes of the still and of every frame go together, on the same columns too") {
  for (const Columns still_columns : {Columns{1, 2}, Columns{0, 6}}) {
    Run run({{.columns = {1, 2}, .every_frame = true, .reference = true},
             {.columns = still_columns, .fragments = true, .exact = true}});
    run.add("a", std::make_unique<Telling>(1));
    run.run(2);
    CHECK(run.pass(0, 0).frames() == numbers(0, 11));
    REQUIRE(run.pass(0, 1).frames() == std::vector{4});
    const Seen& still = run.pass(0, 1).seen.front();
    check_content(still.own, still_columns, 1, 4, false);
    CHECK(still.own.recording());
    REQUIRE(still.exact);
  }
}

TEST_CASE("the reference's colours are of the exact frame, exact fragments of the frame as contenders see it") {
  Run run({{.columns = {3, 2}, .every_frame = true, .fragments = true, .reference = true, .exact = true}});
  run.add("a", std::make_unique<Telling>(1));
  run.run(2);
  const Recorder& pass = run.pass(0);
  REQUIRE(pass.frames() == numbers(0, 11));
  for (const Seen& s : pass.seen) {
    REQUIRE(s.reference);
    check_content(*s.reference, {3, 2}, reference_mark, s.frame, true);
    REQUIRE(s.exact);
    for (int x = 3; x < 5; ++x) {
      for (int y = 0; y < size.height; ++y) {
        const auto pixel = s.exact->pixel(s.own.slot(x, y));
        REQUIRE(pixel.size() == 1);
        CHECK(pixel.front().element == content(reference_mark, s.frame, false, x, y));
      }
    }
  }
}

TEST_CASE("what no pass asks for is not made") {
  Run run({{.columns = {0, 1}, .every_frame = true}});
  run.add("a", std::make_unique<Telling>(1));
  run.run(1, truth({{"throws_at", std::int64_t{3}}}));  // and is not missed
  REQUIRE(run.pass(0).frames() == numbers(0, 11));
  for (const Seen& s : run.pass(0).seen) {
    CHECK_FALSE(s.own.recording());
    CHECK_FALSE(s.reference);
    CHECK_FALSE(s.exact);
  }
}

TEST_CASE("the reference has passes like a contender where they ask for it") {
  Run run({{.columns = {0, 2}, .every_frame = true, .of_reference = true},
           {.columns = {1, 1}, .every_frame = true},
           {.columns = {5, 1}, .of_reference = true}});
  run.add_reference();
  run.add("a", std::make_unique<Telling>(1));
  run.run(2);
  CHECK(run.pass(0, 0).frames() == numbers(0, 11));
  for (const Seen& s : run.pass(0, 0).seen) check_content(s.own, {0, 2}, reference_mark, s.frame, true);
  CHECK(run.pass(0, 2).frames() == std::vector{4});
  CHECK(run.pass(1, 1).frames() == numbers(0, 11));
}

TEST_CASE("colours and fragments each have the reference that was chosen for them") {
  Run run({{.columns = {0, 1}, .fragments = true, .reference = true, .exact = true}});
  run.add("a", std::make_unique<Telling>(1));
  run.run(1, {truth().colors, truth({{"mark", std::int64_t{fragments_mark}}}).colors});
  const Seen& seen = run.pass(0).seen.at(0);
  check_content(*seen.reference, {0, 1}, reference_mark, 4, true);
  REQUIRE(seen.exact->pixel(0).size() == 1);
  CHECK(seen.exact->pixel(0)[0].element == content(fragments_mark, 4, false, 0, 0));
}

// Deposits as Telling does, and notes which frame each rendering went on from.
class Continuing final : public Sampler {
 public:
  std::unique_ptr<Rendering> begin(const RenderRequest& request) const override {
    const auto* previous = dynamic_cast<const Work*>(request.previous);
    const std::scoped_lock lock(mutex_);
    from[request.frame_number] = previous ? previous->number : -1;
    return std::make_unique<Work>(telling_.begin(request), request.frame_number, alive);
  }
  mutable std::map<int, int> from;  // -1: from none
  mutable std::atomic<int> alive = 0;

 private:
  struct Work final : Rendering {
    Work(std::unique_ptr<Rendering> w, int n, std::atomic<int>& a) : work(std::move(w)), number(n), count(a) {
      ++count;
    }
    ~Work() override { --count; }
    void render(PixelBlock& block) const override { work->render(block); }
    std::unique_ptr<Rendering> work;
    const int number;
    std::atomic<int>& count;
  };
  Telling telling_{1};
  mutable std::mutex mutex_;
};

TEST_CASE("a contender that continues gets its last rendering of the batch before, others get none") {
  for (const int threads : {1, 2}) {
    for (const bool continues : {true, false}) {
      CAPTURE(threads, continues);
      Run run({{.columns = {0, 2}, .every_frame = true}});
      auto sampler = std::make_unique<Continuing>();
      const Continuing& kept = *sampler;
      run.add("a", std::move(sampler), continues);
      run.run(threads);
      REQUIRE(run.pass(0).frames() == numbers(0, 11));
      for (const Seen& s : run.pass(0).seen) check_content(s.own, {0, 2}, 1, s.frame, false);
      REQUIRE(kept.from.size() == 11);
      const int batch = 2 * threads;
      for (const auto& [frame, from] : kept.from) CHECK(from == (continues ? frame / batch * batch - 1 : -1));
      CHECK(kept.alive == 0);
    }
  }
}

TEST_CASE("blocks of frames know what is averaged: contenders' and the reference's") {
  for (const bool stored : {false, true}) {
    Run run({{.columns = {0, 1}, .reference = true}});
    run.stored = stored;
    run.add("a", std::make_unique<Telling>(1));
    run.run(1);
    const Blend expected = stored ? Blend::as_stored : Blend::linear;
    CHECK(run.pass(0).seen.at(0).own.blend() == expected);
    CHECK(run.pass(0).seen.at(0).reference->blend() == expected);
  }
}

TEST_CASE("a contender that throws is given up with frame and message, and the others go on") {
  for (const int threads : {1, 2}) {
    CAPTURE(threads);
    Run run({{.columns = {0, 1}, .every_frame = true}});
    const Telling& broken = run.add("broken", std::make_unique<Telling>(1, 6));
    run.add("whole", std::make_unique<Telling>(2));
    run.run(threads);
    CHECK(run.watched[0].failure == "frame 6: the clock stopped");
    CHECK(run.pass(0).frames() == numbers(0, 6));
    CHECK(broken.begun <= 6 + 2 * threads);  // no batch after the one of the failure
    CHECK(run.watched[1].failure.empty());
    CHECK(run.pass(1).frames() == numbers(0, 11));
  }
}

TEST_CASE("a reference that throws ends the run of frames") {
  for (const bool on_exact : {true, false}) {
    CAPTURE(on_exact);
    Run run({{.columns = {0, 1}, .every_frame = true, .reference = true, .exact = true}});
    run.add("a", std::make_unique<Telling>(1));
    CHECK(message_of([&] {
            run.run(2, truth({{"throws_at", std::int64_t{5}}, {"on_exact", on_exact}}));
          }) == "frame 5: the reference: the clock stopped");
    CHECK(run.pass(0).frames() == numbers(0, 5));
    CHECK(run.scene.life.now == 0);
  }
}

TEST_CASE("no frame is held longer than its batch") {
  for (const int threads : {1, 2}) {
    Run run({{.columns = {0, 6}, .every_frame = true, .reference = true}});
    run.count = 50;
    run.add("a", std::make_unique<Telling>(1));
    run.run(threads);
    CHECK(run.scene.life.most == 2 * 2 * threads);  // of each frame two, contenders' and exact
    CHECK(run.scene.life.now == 0);
  }
}

TEST_CASE("the share that is done rises to 1") {
  Run run({{.columns = {0, 1}, .every_frame = true}});
  run.count = 5;
  run.add("a", std::make_unique<Telling>(1));
  run.run(1);
  CHECK(run.shares == std::vector{0.4, 0.8, 1.0});
}

TEST_CASE("what passes see of a terrain are the columns of the whole image, to the bit") {
  const ScenePlugin& plugin = scene_plugin("heightfield");
  const Settings made = changed(plugin.parameters, {{"size", std::int64_t{64}}, {"view.x", 30.0}});
  const auto terrain = plugin.make(made);
  constexpr ImageSize image{40, 24};
  const auto at = [&](int frame) {
    Settings settings = made;
    settings.set("view.x", 30 + 0.7 * frame);
    return settings;
  };
  const Plugin* area = catalog().find(Kind::sampler, "area");
  const ReferenceChoice reference{{"area", area, Settings(area->parameters()), "nearest"}, {}, false};
  const References references{reference, reference};
  constexpr Columns columns{29, 5};  // over the border of two blocks
  for (const int threads : {1, 2}) {
    CAPTURE(threads);
    std::vector<Watched> watched;
    const std::vector<std::string> names{"point", "supersample"};
    for (const std::string& name : names) {
      Watched& w = watched.emplace_back(Watched{name, std::make_unique<Contender>(name, sampler(name)), {}, {}});
      w.passes.push_back(std::make_unique<Recorder>(
          Needs{.columns = columns, .every_frame = true, .fragments = true, .reference = true}));
    }
    run_frames({*terrain, at, at, image, 3, 0, 0}, references, watched, Workers(threads), [](double) {});
    for (std::size_t k = 0; k < names.size(); ++k) {
      const auto& pass = dynamic_cast<const Recorder&>(*watched[k].passes.front());
      REQUIRE(pass.frames() == numbers(0, 3));
      for (const Seen& s : pass.seen) {
        CAPTURE(names[k], s.frame);
        const auto frame = terrain->frame(at(s.frame), image);
        const Rendered whole = rendered(*sampler(names[k]), *frame), truth = rendered(*sampler("area"), *frame);
        Rendered found = whole, found_truth = truth;
        for (int x = columns.x0; x < columns.x0 + columns.width; ++x) {
          for (int y = 0; y < image.height; ++y) {
            const std::size_t slot = s.own.slot(x, y);
            const auto pixel = static_cast<std::size_t>(y * image.width + x);
            found.pixels[pixel] = {s.own.weight(slot), s.own.color(slot), {}};
            s.own.for_each(slot, [&](const Fragment& f) { found.pixels[pixel].fragments.push_back(f); });
            found_truth.pixels[pixel].color = s.reference->color(slot);
          }
        }
        CHECK(first_difference(found, whole).empty());
        CHECK(first_difference(found_truth, truth).empty());
      }
    }
  }
}

}  // namespace moire::test
