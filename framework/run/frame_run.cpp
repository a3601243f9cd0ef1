#include "run/frame_run.h"

#include <algorithm>
#include <exception>
#include <optional>

#include <fmt/format.h>

#include <moire/error.h>

#include "run/failure_message.h"

namespace moire {

namespace {

// What a range of columns is rendered for.
struct Range {
  Columns columns;
  bool every_frame = false, fragments = false, reference = false, exact = false;
};

// All columns that passes need, each range once.
class Ranges {
 public:
  explicit Ranges(const std::vector<Watched>& watched) {
    for (const Watched& w : watched) {
      for (const auto& pass : w.passes) {
        if (pass) add(pass->needs());
      }
    }
  }

  const std::vector<Range>& all() const { return all_; }
  bool every_frame() const {
    return std::any_of(all_.begin(), all_.end(), [](const Range& range) { return range.every_frame; });
  }
  std::size_t index_of(const Columns& columns) const {
    return static_cast<std::size_t>(
        std::find_if(all_.begin(), all_.end(), [&](const Range& r) { return r.columns == columns; }) - all_.begin());
  }

 private:
  void add(const Needs& needs) {
    auto range = std::find_if(all_.begin(), all_.end(), [&](const Range& r) { return r.columns == needs.columns; });
    if (range == all_.end()) range = all_.insert(range, Range{needs.columns});
    range->every_frame = range->every_frame || needs.every_frame;
    range->fragments = range->fragments || needs.fragments;
    range->reference = range->reference || needs.reference || needs.of_reference;
    range->exact = range->exact || needs.exact;
  }

  std::vector<Range> all_;
};

// What one renderer made of one frame, by range; or what it threw.
struct Rendered {
  std::unique_ptr<Rendering> rendering;  // kept only for the next batch to continue from
  std::vector<std::optional<PixelBlock>> blocks;
  std::vector<std::optional<MergedBlock>> exact;
  std::exception_ptr thrown;
};

class FrameRun {
 public:
  FrameRun(const FrameSource& source, const References& references, std::vector<Watched>& watched)
      : source_(source),
        colors_(references.colors.sampler),
        fragments_(references.fragments.sampler),
        watched_(watched),
        ranges_(watched),
        last_(renderers()) {}

  void run(const Workers& workers, const std::function<void(double)>& advance) {
    const int first = ranges_.every_frame() ? 0 : source_.still;
    const int end = ranges_.every_frame() ? source_.count : source_.still + 1;
    // Frames at work at a time: enough for all threads, whatever the renderers take.
    const int batch = 2 * workers.threads();
    for (int begin = first; begin < end; begin += batch) {
      const int count = std::min(batch, end - begin);
      render(begin, count, workers);
      for (int k = 0; k < count; ++k) show(begin + k, static_cast<std::size_t>(k));
      advance(static_cast<double>(begin + count - first) / (end - first));
    }
  }

 private:
  // A frame's renderers: all that are watched, then the reference on the exact frame, then on the contenders' frame.
  std::size_t renderers() const { return watched_.size() + 2; }
  Rendered& rendered(std::size_t k, std::size_t renderer) { return batch_[k * renderers() + renderer]; }
  bool continues(std::size_t renderer) const {
    if (renderer >= watched_.size()) return (renderer == watched_.size() ? colors_ : fragments_).continues();
    return watched_[renderer].contender->continues();
  }

  void render(int begin, int count, const Workers& workers) {
    std::vector<std::unique_ptr<Frame>> frames, exact_frames;
    for (int k = 0; k < count; ++k) {
      frames.push_back(source_.scene.frame(source_.settings(begin + k), source_.image));
      exact_frames.push_back(source_.scene.frame(source_.exact_settings(begin + k), source_.image));
    }
    batch_.clear();
    batch_.resize(static_cast<std::size_t>(count) * renderers());
    // The references first: they take longest.
    workers.for_each(batch_.size(), [&](std::size_t index) {
      const std::size_t k = index % static_cast<std::size_t>(count);
      const std::size_t renderer = renderers() - 1 - index / static_cast<std::size_t>(count);
      Rendered& out = rendered(k, renderer);
      const int number = begin + static_cast<int>(k);
      const Rendering* const previous = last_[renderer].get();
      try {
        if (renderer < watched_.size()) {
          const Watched& w = watched_[renderer];
          if (w.contender && w.failure.empty()) render_contender({*w.contender, *frames[k], number, previous}, out);
        } else if (renderer == watched_.size()) {
          render_reference({colors_, *exact_frames[k], number, previous}, out);
        } else {
          render_exact({fragments_, *frames[k], number, previous}, out);
        }
      } catch (const Interrupted&) {
        throw;
      } catch (...) {
        out.thrown = std::current_exception();
      }
      const bool is_last = number + 1 == begin + count;
      if (out.rendering && !(is_last && continues(renderer))) out.rendering.reset();
    });
    // The frames of a batch are made at once, so what they continue from is of the batch before.
    for (std::size_t renderer = 0; renderer < renderers(); ++renderer) {
      auto& rendering = rendered(static_cast<std::size_t>(count) - 1, renderer).rendering;
      if (rendering) last_[renderer] = std::move(rendering);
    }
  }

  // A frame that one renderer is to make.
  struct Task {
    const Contender& contender;
    const Frame& frame;
    int number;
    const Rendering* previous;
  };

  PixelBlock block(const Task& task, const Columns& columns, bool recording, Rendered& out) const {
    if (!out.rendering) out.rendering = task.contender.begin(task.frame, source_.seed, task.number, task.previous);
    PixelBlock result({columns.x0, 0, columns.width, source_.image.height}, recording, Blocks::columns,
                      task.frame.blend());
    out.rendering->render(result);
    return result;
  }

  // A pass of the still alone is not served with other frames.
  bool is_wanted(const Range& range, int frame) const { return range.every_frame || frame == source_.still; }

  void render_contender(const Task& task, Rendered& out) const {
    for (const Range& range : ranges_.all()) {
      auto& place = out.blocks.emplace_back();
      if (is_wanted(range, task.number)) place = block(task, range.columns, range.fragments, out);
    }
  }

  void render_reference(const Task& task, Rendered& out) const {
    for (const Range& range : ranges_.all()) {
      auto& place = out.blocks.emplace_back();
      if (range.reference && is_wanted(range, task.number)) place = block(task, range.columns, false, out);
    }
  }

  void render_exact(const Task& task, Rendered& out) const {
    for (const Range& range : ranges_.all()) {
      auto& place = out.exact.emplace_back();
      if (range.exact && is_wanted(range, task.number)) place = MergedBlock(block(task, range.columns, true, out));
    }
  }

  void show(int frame, std::size_t k) {
    const Rendered& reference = rendered(k, watched_.size());
    const Rendered& exact = rendered(k, watched_.size() + 1);
    for (const Rendered* made : {&reference, &exact}) {
      if (made->thrown) throw Error(fmt::format("frame {}: the reference: {}", frame, failure_message(made->thrown)));
    }
    for (std::size_t i = 0; i < watched_.size(); ++i) {
      Watched& w = watched_[i];
      if (!w.failure.empty()) continue;
      const Rendered& own = w.contender ? rendered(k, i) : reference;
      if (own.thrown) {
        w.failure = fmt::format("frame {}: {}", frame, failure_message(own.thrown));
        continue;
      }
      for (const auto& pass : w.passes) {
        if (!pass || (frame != source_.still && !pass->needs().every_frame)) continue;
        const std::size_t range = ranges_.index_of(pass->needs().columns);
        const auto pointer = [](const auto& optional) { return optional ? &*optional : nullptr; };
        pass->see({frame, *own.blocks[range], pointer(reference.blocks[range]), pointer(exact.exact[range])});
      }
    }
  }

  const FrameSource& source_;
  const Contender colors_, fragments_;
  std::vector<Watched>& watched_;
  const Ranges ranges_;
  std::vector<Rendered> batch_;
  std::vector<std::unique_ptr<Rendering>> last_;  // of each renderer that continues, the last of the batch before
};

}  // namespace

void run_frames(const FrameSource& source, const References& references, std::vector<Watched>& watched,
                const Workers& workers, const std::function<void(double)>& advance) {
  FrameRun(source, references, watched).run(workers, advance);
}

}  // namespace moire
