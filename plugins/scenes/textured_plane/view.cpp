#include "view.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include <moire/error.h>

#include "convex.h"

namespace textured_plane {

namespace {

constexpr double farthest_texel = 0x1p28 - 1;
// Filters ask for points outside the picture too.
constexpr double margin = 16;

Linear combined(double a, const Linear& p, double b, const Linear& q) {
  return {a * p.u + b * q.u, a * p.v + b * q.v, a * p.constant + b * q.constant};
}

// Of a full turn: how far it is from a multiple of 90 degrees.
double beyond_quarters(double degrees) { return std::remainder(degrees, 90); }

}  // namespace

Camera camera_of(const moire::Settings& settings, moire::ImageSize size, double texel) {
  return {.size = size,
          .x = settings.real("view.x") / texel,
          .y = settings.real("view.y") / texel,
          .height = settings.real("view.height") / texel,
          .far = settings.real("far") / texel,
          .yaw_deg = settings.real("view.yaw_deg"),
          .pitch_deg = settings.real("view.pitch_deg"),
          .roll_deg = settings.real("view.roll_deg"),
          .fov_deg = settings.real("view.fov_deg")};
}

View::View(const Camera& camera)
    : size_(camera.size),
      center_{camera.size.width / 2.0, camera.size.height / 2.0},
      focal_(camera.size.width / 2.0 / std::tan(camera.fov_deg * std::numbers::pi / 360)),
      height_(camera.height),
      far_(camera.far),
      s0_(camera.x),
      t0_(camera.y),
      yaw_(moire::turn_of(camera.yaw_deg)),
      pitch_(moire::turn_of(camera.pitch_deg)),
      roll_(moire::turn_of(camera.roll_deg)),
      aligned_(beyond_quarters(camera.yaw_deg) == 0 && std::remainder(camera.roll_deg, 360) == 0) {
  // Pixels to the right and down in a picture with a level horizon.
  const Linear right{roll_.cosine, -roll_.sine, 0}, down{roll_.sine, roll_.cosine, 0}, one{0, 0, 1};
  const Linear ahead = combined(pitch_.cosine, one, pitch_.sine / focal_, down);
  fall_ = combined(-pitch_.sine, one, pitch_.cosine / focal_, down);
  s_ = combined(height_ * yaw_.cosine, ahead, -height_ * yaw_.sine / focal_, right);
  t_ = combined(height_ * yaw_.sine, ahead, height_ * yaw_.cosine / focal_, right);
  nearness_ = combined(far_, fall_, -height_, ahead);
}

moire::Point View::image_of(double s, double t) const {
  const double ahead = s * yaw_.cosine + t * yaw_.sine, aside = t * yaw_.cosine - s * yaw_.sine;
  const double scale = focal_ / (ahead * pitch_.cosine - height_ * pitch_.sine);
  const double right = scale * aside, down = scale * (ahead * pitch_.sine + height_ * pitch_.cosine);
  return {right * roll_.cosine + down * roll_.sine, down * roll_.cosine - right * roll_.sine};
}

void check_reach(const View& view) {
  const double u = view.center().x + margin, v = view.center().y + margin;
  Convex seen = Convex::rectangle(-u, -v, u, v);
  seen = seen.part([&](moire::Point p) { return view.fall()(p.x, p.y); });
  seen = seen.part([&](moire::Point p) { return view.nearness()(p.x, p.y); });
  double reach = 0;
  for (const moire::Point& p : seen) {
    const double fall = view.fall()(p.x, p.y);
    reach = std::max(
        {reach, std::abs(view.s0() + view.s()(p.x, p.y) / fall), std::abs(view.t0() + view.t()(p.x, p.y) / fall)});
  }
  if (reach < farthest_texel) return;
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", reach);
  throw moire::Error(std::string("textured_plane: ground is seen ") + text +
                     " texels from the texture's corner; texels have names up to 268435455: give a smaller far, or "
                     "larger texels");
}

}  // namespace textured_plane
