#include "run/speed.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace moire {

namespace {

using Clock = std::chrono::steady_clock;

double milliseconds(Clock::duration duration) { return std::chrono::duration<double, std::milli>(duration).count(); }

struct Timing {
  double ms;
  std::unique_ptr<Rendering> rendering;
};

// One frame, begin() included; what is thrown away costs nothing.
Timing render_once(const Timed& timed, std::uint64_t seed, const Workers& workers, std::vector<Counters>& blocks,
                   Picture& picture, const Rendering* previous = nullptr) {
  const auto start = Clock::now();
  auto rendering = timed.contender->begin(*timed.frame, seed, 0, previous);
  const ImageSize size = timed.frame->size();
  blocks.resize(workers.blocks(size, Workers::order(*rendering, false)));
  picture.size = size;
  picture.pixels.resize(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height));
  workers.render_runs(*rendering, *timed.frame, false, [&](std::size_t index, const PixelBlock& block) {
    put(block, picture);
    blocks[index] = block.counters;
  });
  return {milliseconds(Clock::now() - start), std::move(rendering)};
}

struct Times {
  std::vector<double> one_thread, all_threads, next_frame;
  Counters counters;
  std::unique_ptr<Rendering> last;  // of a contender that continues
};

Row time_row(const std::string& scene, const std::string& sampler, const char* metric,
             const std::vector<double>& times) {
  Row row{.scene = scene, .sampler = sampler, .metric = metric, .unit = "ms"};
  row.value = quantile(times, 0.5);
  if (times.size() > 1) {
    row.low = quantile(times, 0.25);
    row.high = quantile(times, 0.75);
  }
  return row;
}

}  // namespace

double quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  const double place = share * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  return values[below] + (place - static_cast<double>(below)) * (values[above] - values[below]);
}

std::vector<Row> measure_speed(const std::string& scene, const std::vector<Timed>& contenders, const Settings& settings,
                               std::uint64_t seed, const Workers& workers,
                               const std::function<void(double)>& progress) {
  const Workers one(1);
  const auto rounds = static_cast<std::size_t>(settings.integer("rounds"));
  const auto begin = Clock::now();
  std::vector<Times> times(contenders.size());
  Picture picture;  // into which all are rendered

  // The warm-up counts the work too.
  for (std::size_t k = 0; k < contenders.size(); ++k) {
    std::vector<Counters> blocks;
    Timing timing = render_once(contenders[k], seed, one, blocks, picture);
    for (const Counters& counters : blocks) times[k].counters += counters;
    if (contenders[k].once) times[k].one_thread.push_back(timing.ms);
    if (contenders[k].contender->continues() && !contenders[k].once) times[k].last = std::move(timing.rendering);
  }
  // Going on from the frame before is a turn of its own, so that it too comes after somebody else's work.
  struct Turn {
    std::size_t k;
    bool is_next_frame = false;
  };
  std::vector<Turn> turns;
  for (std::size_t k = 0; k < contenders.size(); ++k) turns.push_back({k});
  for (std::size_t k = 0; k < contenders.size(); ++k) {
    if (times[k].last) turns.push_back({k, true});
  }
  for (std::size_t round = 0; round < rounds; ++round) {
    if (round > 0 && milliseconds(Clock::now() - begin) > 1000 * settings.real("at_most")) break;
    for (std::size_t turn = 0; turn < turns.size(); ++turn) {
      const auto [k, is_next_frame] = turns[(turn + round) % turns.size()];  // nobody is always first after the slowest
      std::vector<Counters> blocks;
      if (is_next_frame) {
        Timing timing = render_once(contenders[k], seed, one, blocks, picture, times[k].last.get());
        times[k].next_frame.push_back(timing.ms);
        times[k].last = std::move(timing.rendering);
        continue;
      }
      if (!contenders[k].once) times[k].one_thread.push_back(render_once(contenders[k], seed, one, blocks, picture).ms);
      if (!contenders[k].once || round == 0)
        times[k].all_threads.push_back(render_once(contenders[k], seed, workers, blocks, picture).ms);
    }
    progress(static_cast<double>(round + 1) / static_cast<double>(rounds));
  }

  std::vector<Row> rows;
  for (std::size_t k = 0; k < contenders.size(); ++k) {
    const std::string& name = contenders[k].contender->name();
    const ImageSize size = contenders[k].frame->size();
    const double pixels = static_cast<double>(size.width) * size.height;
    rows.push_back(time_row(scene, name, "speed.ms_per_frame", times[k].one_thread));
    if (times[k].last) rows.push_back(time_row(scene, name, "speed.ms_per_next_frame", times[k].next_frame));
    rows.push_back(time_row(scene, name, "speed.ms_per_frame_all_threads", times[k].all_threads));
    rows.push_back({.scene = scene,
                    .sampler = name,
                    .metric = "speed.queries_per_pixel",
                    .value = static_cast<double>(times[k].counters.queries) / pixels,
                    .unit = "per pixel"});
    rows.push_back({.scene = scene,
                    .sampler = name,
                    .metric = "speed.steps_per_pixel",
                    .value = static_cast<double>(times[k].counters.steps) / pixels,
                    .unit = "per pixel"});
  }
  return rows;
}

}  // namespace moire
