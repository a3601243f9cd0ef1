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
  std::vector<std::optional<PixelBlock>> blocks;
  std::vector<std::optional<MergedBlock>> exact;
  std::exception_ptr thrown;
};

class FrameRun {
 public:
  FrameRun(const FrameSource& source, const ReferenceChoice& reference, std::vector<Watched>& watched)
      : source_(source), reference_(reference.sampler), watched_(watched), ranges_(watched) {}

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
      try {
        if (renderer < watched_.size()) {
          const Watched& w = watched_[renderer];
          if (w.contender && w.failure.empty()) render_contender(*w.contender, *frames[k], number, out);
        } else if (renderer == watched_.size()) {
          render_reference(*exact_frames[k], number, out);
        } else {
          render_exact(*frames[k], number, out);
        }
      } catch (const Interrupted&) {
        throw;
      } catch (...) {
        out.thrown = std::current_exception();
      }
    });
  }

  PixelBlock block(const Rendering& rendering, const Columns& columns, bool recording) const {
    PixelBlock result({columns.x0, 0, columns.width, source_.image.height}, recording);
    rendering.render(result);
    return result;
  }

  // A pass of the still alone is not served with other frames.
  bool is_wanted(const Range& range, int frame) const { return range.every_frame || frame == source_.still; }

  void render_contender(const Contender& contender, const Frame& frame, int number, Rendered& out) const {
    const auto rendering = contender.begin(frame, source_.seed, number);
    for (const Range& range : ranges_.all()) {
      auto& place = out.blocks.emplace_back();
      if (is_wanted(range, number)) place = block(*rendering, range.columns, range.fragments);
    }
  }

  void render_reference(const Frame& frame, int number, Rendered& out) const {
    std::unique_ptr<Rendering> rendering;
    for (const Range& range : ranges_.all()) {
      auto& place = out.blocks.emplace_back();
      if (!range.reference || !is_wanted(range, number)) continue;
      if (!rendering) rendering = reference_.begin(frame, source_.seed, number);
      place = block(*rendering, range.columns, false);
    }
  }

  void render_exact(const Frame& frame, int number, Rendered& out) const {
    std::unique_ptr<Rendering> rendering;
    for (const Range& range : ranges_.all()) {
      auto& place = out.exact.emplace_back();
      if (!range.exact || !is_wanted(range, number)) continue;
      if (!rendering) rendering = reference_.begin(frame, source_.seed, number);
      place = MergedBlock(block(*rendering, range.columns, true));
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
  const Contender reference_;
  std::vector<Watched>& watched_;
  const Ranges ranges_;
  std::vector<Rendered> batch_;
};

}  // namespace

void run_frames(const FrameSource& source, const ReferenceChoice& reference, std::vector<Watched>& watched,
                const Workers& workers, const std::function<void(double)>& advance) {
  FrameRun(source, reference, watched).run(workers, advance);
}

}  // namespace moire
