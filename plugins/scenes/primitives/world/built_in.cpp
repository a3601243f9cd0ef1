#include "built_in.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include <moire/random.h>
#include <moire/turn.h>

namespace primitives {

namespace {

using moire::Point;
using moire::Settings;

// What a kind is made from.
struct Request {
  const Settings& settings;
  const Style& style;
  moire::ImageSize size;

  double half() const { return std::min(size.width, size.height) / 2.0; }  // of the image's shorter side
  int count() const { return static_cast<int>(settings.integer("count")); }
};

constexpr std::string_view palette[] = {"#d1495b", "#00798c", "#edae49", "#30638e", "#6a994e", "#7b4b94", "#2b2d42"};
moire::Color palette_color(std::size_t k) { return moire::parse_color(palette[k % std::size(palette)]); }

moire::LineCurve line(Point from, Point to, const Style& style) {
  return {moire::background, style.color, from, to, style.width, style.cap};
}
moire::CircleCurve circle(Point center, double radius, const Style& style) {
  return {moire::background, style.color, center, radius, style.width};
}

// At this distance from (0, 0), clockwise from the x axis.
Point at(double angle_deg, double distance) {
  const moire::Turn turn = moire::turn_of(angle_deg);
  return {distance * turn.cosine, distance * turn.sine};
}

Picture one_line(const Request& request) {
  const Settings& s = request.settings;
  const Point middle{s.real("x"), s.real("y")}, half = at(s.real("angle_deg"), s.real("length") / 2);
  return {{{line({middle.x - half.x, middle.y - half.y}, {middle.x + half.x, middle.y + half.y}, request.style),
            {{s.real("velocity.x"), s.real("velocity.y")}, s.real("spin_deg")}}},
          {}};
}

Picture one_circle(const Request& request) {
  const Settings& s = request.settings;
  return {{{circle({s.real("x"), s.real("y")}, s.real("radius"), request.style),
            {{s.real("velocity.x"), s.real("velocity.y")}, 0}}},
          {}};
}

// Lines from near the middle to near the border.
Picture fan(const Request& request) {
  Picture picture;
  const double first = request.settings.real("angle_deg"), half = request.half();
  for (int k = 0; k < request.count(); ++k) {
    const double angle = first + 360.0 * k / request.count();
    picture.primitives.push_back({line(at(angle, 0.08 * half), at(angle, 0.96 * half), request.style), {}});
  }
  return picture;
}

Picture circles(const Request& request) {
  Picture picture;
  for (int k = 1; k <= request.count(); ++k) {
    picture.primitives.push_back({circle({}, 0.96 * request.half() * k / request.count(), request.style), {}});
  }
  return picture;
}

// Anywhere in the image and some beyond it, of any size up to a quarter of its shorter side, one in three a circle.
Picture random_ones(const Request& request) {
  Picture picture;
  const auto seed = static_cast<std::uint64_t>(request.settings.integer("seed"));
  const double half = request.half();
  for (int k = 0; k < request.count(); ++k) {
    const auto draw = [&](std::uint32_t dimension) { return moire::random({.x = k, .seed = seed}, 0, dimension); };
    const Point middle{1.1 * (draw(0) - 0.5) * request.size.width, 1.1 * (draw(1) - 0.5) * request.size.height};
    const double reach = half * (0.02 + 0.48 * draw(2));
    Style style = request.style;
    style.color = palette_color(static_cast<std::size_t>(draw(3) * std::size(palette)));
    style.width *= 1 + 3 * draw(4);
    if (k % 3 == 2) {
      picture.primitives.push_back({circle(middle, reach, style), {}});
    } else {
      const Point end = at(360 * draw(5), reach);
      picture.primitives.push_back(
          {line({middle.x - end.x, middle.y - end.y}, {middle.x + end.x, middle.y + end.y}, style), {}});
    }
  }
  return picture;
}

// Rings that overlap, lines that cross them and each other, of all widths and caps, and disks.
Picture mixed(const Request& request) {
  Picture picture;
  const double unit = request.half() / 100, thin = request.style.width;
  std::size_t color = 0;
  const auto style = [&](double width, moire::Cap cap = moire::Cap::butt) {
    return Style{palette_color(color++), width, cap};
  };
  const auto put = [&](const Curve& curve, Motion motion = {}) { picture.primitives.push_back({curve, motion}); };

  // Three rings, each over the next, and a hairline in each.
  for (int k = 0; k < 3; ++k) {
    const Point center = at(90.0 + 120 * k, 34 * unit);
    put(circle(center, 40 * unit, style(9 * unit)), {});
    put(circle(center, 27.5 * unit, {request.style.color, thin, moire::Cap::butt}));
  }
  // Slats of growing width behind one another.
  for (int k = 0; k < 5; ++k) {
    const double y = (-86 + 7.5 * k) * unit;
    put(line({-88 * unit, y}, {(-20 + 16 * k) * unit, y + (4 + 3 * k) * unit}, style((0.5 + k) * unit)));
  }
  // The three caps, each turning about its middle.
  for (int k = 0; k < 3; ++k) {
    const Point middle{(-62 + 20 * k) * unit, 78 * unit}, end = at(-60, 14 * unit);
    put(line({middle.x - end.x, middle.y - end.y}, {middle.x + end.x, middle.y + end.y},
             style(9 * unit, static_cast<moire::Cap>(k))),
        {{}, 20});
  }
  // Thin lines of nearly the same angle from a disk.
  const Point hub{72 * unit, -62 * unit};
  for (int k = 0; k < 24; ++k) {
    const Point end = at(15.0 * k + 3, 26 * unit);
    put(line(hub, {hub.x + end.x, hub.y + end.y}, {request.style.color, thin, moire::Cap::butt}));
  }
  put(circle(hub, 0, style(12 * unit)));
  // A target.
  for (int k = 0; k < 6; ++k) {
    put(circle({68 * unit, 68 * unit}, (3 + 4 * k) * unit, {request.style.color, thin, moire::Cap::butt}));
  }
  // Two lines over all.
  put(line({-96 * unit, 40 * unit}, {96 * unit, -27 * unit}, style(3 * unit, moire::Cap::round)));
  put(line({-90 * unit, -30 * unit}, {92 * unit, 44 * unit}, style(1.5 * unit)));
  return picture;
}

struct Kind {
  std::string_view name;
  Picture (*make)(const Request&);
};
constexpr std::array kinds{Kind{"mixed", mixed},        Kind{"fan", fan},       Kind{"circles", circles},
                           Kind{"random", random_ones}, Kind{"line", one_line}, Kind{"circle", one_circle}};

}  // namespace

Picture built_in(const Settings& settings, const Style& style, moire::ImageSize size) {
  const auto kind =
      std::find_if(kinds.begin(), kinds.end(), [&](const Kind& k) { return k.name == settings.text("kind"); });
  return kind->make({settings, style, size});
}

}  // namespace primitives
