#include "strips.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace textured_plane {

namespace {

// Texels a pixel, along a strip, from which sums take less time than texels one by one.
constexpr double fewest_for_sums = 1;

// Strips whose lines are put in order together: 4 MB of them.
constexpr std::size_t most_at_once = std::size_t{1} << 16;

// The mean of clamp(p, 0, 1) where p goes straight from one end to the other.
double mean_clamped(double p, double q) {
  const double low = std::min(p, q), high = std::max(p, q);
  const double from = std::clamp(low, 0.0, 1.0), to = std::clamp(high, 0.0, 1.0);
  if (from == to) return from;
  return ((to - from) * ((from + to) / 2) + std::max(high - 1, 0.0)) / (high - low);
}

}  // namespace

struct Strips::Strip {
  double k0, k1;              // its upper and its lower end
  double fall0, fall1;        // W there
  double inverse0, inverse1;  // 1 / W
  std::int64_t line;          // of texels, unwrapped; of many clamped ones any
};

Strips::Strips(const View& view, const Texels& texels, const Surroundings& surroundings)
    : view_(view), texels_(texels), surroundings_(surroundings), sums_(nullptr) {
  if (texels.wrap() == moire::Wrap::clamp) return;
  sums_ = view_.lines_along_s() ? &texels.rows() : &texels.columns();
  origin_ = static_cast<double>(moire::wrapped(view_.place0().whole, sums_->period(), moire::Wrap::repeat));
  per_period_ = 1.0 / sums_->period();
}

template <class Visit>
void Strips::for_each_strip(const LevelView::Row& row, bool clamped, Visit visit) const {
  const bool rises = view_.rises_ahead();
  const Place& origin = view_.line0();
  const std::int64_t lines = view_.lines_along_s() ? texels_.height() : texels_.width();
  const auto line_at = [&](double k) {
    const double ahead = view_.ahead(k);
    return origin.texel(rises ? ahead : -ahead);
  };
  // Where the picture leaves line n downward: at the edge that is nearer to the camera.
  const auto end_of = [&](std::int64_t n) { return rises ? origin.to(n) : -origin.to(n + 1); };
  const std::int64_t first = line_at(row.k0), last = line_at(row.k1), step = rises ? -1 : 1;
  // The last of the lines that are seen with n as one.
  const auto last_with = [&](std::int64_t n) {
    if (!clamped || (n > 0 && n < lines - 1)) return n;
    if (n <= 0 && lines > 1) return step > 0 ? std::min<std::int64_t>(0, last) : last;
    if (n >= lines - 1 && lines > 1) return step < 0 ? std::max(lines - 1, last) : last;
    return last;
  };

  Strip strip{row.k0, row.k0, view_.fall(row.k0), 0, 0, 0, first};
  strip.inverse0 = 1 / strip.fall0;
  for (std::int64_t n = first; (last - n) * step >= 0; n += step) {
    strip.line = n;
    n = last_with(n);
    strip.k1 = n == last ? row.k1 : std::clamp(view_.row_of(end_of(n)), strip.k0, row.k1);
    strip.fall1 = view_.fall(strip.k1);
    strip.inverse1 = 1 / strip.fall1;
    if (strip.k1 > strip.k0) visit(std::as_const(strip));
    strip.k0 = strip.k1;
    strip.fall0 = strip.fall1;
    strip.inverse0 = strip.inverse1;
  }
}

template <class Visit>
void Strips::for_each_texel(const Strip& strip, int x0, int width, bool clamped, Visit visit) const {
  const double b = view_.b(), height = strip.k1 - strip.k0;
  const Place& origin = view_.place0();
  const std::int64_t step = b > 0 ? 1 : -1;
  const std::int64_t most = (view_.lines_along_s() ? texels_.width() : texels_.height()) - 1;
  for (int x = 0; x < width; ++x) {
    const double left = view_.u(x0 + x), right = view_.u(x0 + x + 1);
    const auto place = [&](double u, double inverse) {
      const std::int64_t i = origin.texel(b * u * inverse);
      return clamped ? std::clamp<std::int64_t>(i, 0, most) : i;
    };
    std::int64_t i = place(left, strip.inverse0), last = place(right, strip.inverse0);
    if (const std::int64_t other = place(left, strip.inverse1); (i - other) * step > 0) i = other;
    if (const std::int64_t other = place(right, strip.inverse1); (other - last) * step > 0) last = other;
    // The strip's part to the left of each texel's right edge.
    double before = 0;
    for (; (last - i) * step >= 0; i += step) {
      double after = height;
      if (i != last) {
        const double edge = origin.to(step > 0 ? i + 1 : i) / b;
        after *= mean_clamped(edge * strip.fall0 - left, edge * strip.fall1 - left);
      }
      if (after > before) {
        visit(x, i, after - before);
        before = after;
      }
    }
  }
}

moire::Hit Strips::texel(const Strip& strip, std::int64_t i) const {
  const moire::Texture& texture = texels_.texture();
  return view_.lines_along_s() ? texture.texel(0, i, strip.line) : texture.texel(0, strip.line, i);
}

bool Strips::takes_sums(const LevelView::Row& row) const {
  return sums_ && std::abs(view_.b()) >= fewest_for_sums * view_.fall(row.k1);
}

LineSums::Node Strips::edge(const Strip& strip, double u) const {
  LineSums::Node integral{};
  const double rest = view_.place0().rest, c = view_.b() * u;
  const double from = rest + c * strip.inverse0, to = rest + c * strip.inverse1;
  const double first = std::floor(from), last = std::floor(to);

  // Nodes of the line's F, from the one below `from` on. There is one more than its period has.
  const LineSums::Node* nodes = sums_->line(strip.line);
  const int period = sums_->period();
  const double place = first + origin_;
  // Rounding may bring a multiple of the period out one period off.
  int at = static_cast<int>(place - period * std::floor(place * per_period_));
  at += at < 0 ? period : at >= period ? -period : 0;

  const auto add = [&](const LineSums::Node& node, double weight) {
    integral.r += weight * node.r;
    integral.g += weight * node.g;
    integral.b += weight * node.b;
  };
  // What the trapezoids make of the value at an end, F straight between two nodes there.
  const auto add_end = [&](double x, double floor, double weight) {
    add(nodes[at], weight * (1 - (x - floor)));
    add(nodes[at + 1], weight * (x - floor));
  };

  if (first == last) {
    const double w0 = strip.fall0 * (1 - (from - first)) + strip.fall1 * (1 - (to - first));
    const double w1 = strip.fall0 * (from - first) + strip.fall1 * (to - first);
    add(nodes[at], (strip.k1 - strip.k0) * w0);
    add(nodes[at + 1], (strip.k1 - strip.k0) * w1);
    return integral;
  }
  // X goes towards `rest` as W grows.
  const bool falls = c > 0;
  const double step = falls ? -1 : 1;
  double crossed = falls ? first : first + 1;  // whole number that X comes to next
  const double beyond = falls ? last : last + 1;
  double fall = c / (crossed - rest);
  double previous = strip.k0, k = std::clamp(view_.row_of_fall(fall), strip.k0, strip.k1);
  add_end(from, first, (k - previous) * strip.fall0);
  for (;;) {
    // The node at `crossed`.
    if (!falls) at = at + 1 == period ? 0 : at + 1;
    const double next_crossed = crossed + step;
    if (next_crossed == beyond) {
      add(nodes[at], (strip.k1 - previous) * fall);
      if (falls) at = at == 0 ? period - 1 : at - 1;
      break;
    }
    const double next_fall = c / (next_crossed - rest);
    const double next = std::clamp(view_.row_of_fall(next_fall), k, strip.k1);
    add(nodes[at], (next - previous) * fall);
    if (falls) at = at == 0 ? period - 1 : at - 1;
    crossed = next_crossed;
    fall = next_fall;
    previous = k;
    k = next;
  }
  add_end(to, last, (strip.k1 - k) * strip.fall1);
  return integral;
}

void Strips::add_by_sums(const LevelView::Row& row, int x0, std::vector<moire::Tally::Sum>& pixels) const {
  std::vector<LineSums::Node> edges(pixels.size() + 1);
  LineSums::Node means{};
  const auto add = [](LineSums::Node& sum, double weight, const LineSums::Node& node) {
    sum = {sum.r + weight * node.r, sum.g + weight * node.g, sum.b + weight * node.b, 0};
  };
  // Strips that show the same line of texels one after another, while its sums are at hand.
  std::vector<Strip> strips;
  const auto repetition = static_cast<std::size_t>(sums_->repetition());
  const auto settle = [&] {
    for (std::size_t first = 0; first < std::min(repetition, strips.size()); ++first) {
      for (std::size_t k = first; k < strips.size(); k += repetition) {
        const Strip& strip = strips[k];
        add(means, strip.k1 - strip.k0, sums_->mean(strip.line));
        for (std::size_t x = 0; x < edges.size(); ++x) {
          add(edges[x], 1, edge(strip, view_.u(x0 + static_cast<int>(x))));
        }
      }
    }
    strips.clear();
  };
  for_each_strip(row, false, [&](const Strip& strip) {
    strips.push_back(strip);
    if (strips.size() == most_at_once) settle();
  });
  settle();
  // Of the trapezoids, and of W / b.
  const double factor = 0.5 / view_.b();
  for (std::size_t x = 0; x < pixels.size(); ++x) {
    const LineSums::Node &left = edges[x], &right = edges[x + 1];
    pixels[x].add({row.near, means.r + factor * (right.r - left.r), means.g + factor * (right.g - left.g),
                   means.b + factor * (right.b - left.b)});
  }
}

void Strips::add_by_texels(const LevelView::Row& row, int x0, std::vector<moire::Tally::Sum>& pixels) const {
  const bool clamped = texels_.wrap() == moire::Wrap::clamp;
  for_each_strip(row, clamped, [&](const Strip& strip) {
    for_each_texel(strip, x0, static_cast<int>(pixels.size()), clamped, [&](int x, std::int64_t i, double area) {
      pixels[static_cast<std::size_t>(x)].add(area, texel(strip, i).color);
    });
  });
}

void Strips::integrate(moire::PixelBlock& block) const {
  block.counters.queries += block.slots();
  std::vector<moire::Tally::Sum> pixels(static_cast<std::size_t>(block.width));
  for (int y = block.y0; y < block.y0 + block.height; ++y) {
    const LevelView::Row row = view_.row(y);
    std::fill(pixels.begin(), pixels.end(), moire::Tally::Sum{});
    if (row.near > 0) takes_sums(row) ? add_by_sums(row, block.x0, pixels) : add_by_texels(row, block.x0, pixels);

    if (row.sky < 1) block.counters.hits += static_cast<std::uint64_t>(block.width);
    block.fill([&](auto add) {
      for (int x = 0; x < block.width; ++x) {
        const std::size_t slot = block.slot(block.x0 + x, y);
        if (row.sky > 0) add(slot, moire::background, row.sky, surroundings_.sky);
        if (row.far > 0) add(slot, far_ground, row.far, surroundings_.far);
        if (row.near > 0) add.sum(slot, pixels[static_cast<std::size_t>(x)]);
      }
      if (row.near <= 0 || !block.recording()) return;
      for_each_strip(row, false, [&](const Strip& strip) {
        for_each_texel(strip, block.x0, block.width, false, [&](int x, std::int64_t i, double area) {
          const moire::Hit hit = texel(strip, i);
          add.record(block.slot(block.x0 + x, y), hit.element, area, hit.color);
        });
      });
    });
  }
}

}  // namespace textured_plane
