// A pyramid as OpenImageIO's TextureSystem sees it: levels and tiles of a file that only exists in memory, float by
// float. All tiles are loaded at once, so that none is read while threads ask.
#include "images/oiio_texture.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <mutex>
#include <vector>

#include <OpenImageIO/imagecache.h>
#include <OpenImageIO/imageio.h>
#include <OpenImageIO/texture.h>

#include "images/boundary.h"
#include "images/images.h"

namespace moire {

namespace {

constexpr char pyramid_attribute[] = "moire:pyramid";
constexpr int tile = 64, channels = 3;

// OpenImageIO's reader of such a file.
class PyramidInput final : public OIIO::ImageInput {
 public:
  const char* format_name() const override { return "moire"; }
  bool open(const std::string&, OIIO::ImageSpec&) override { return false; }
  bool open(const std::string&, OIIO::ImageSpec& spec, const OIIO::ImageSpec& config) override {
    const OIIO::ParamValue* const given = config.find_attribute(pyramid_attribute, OIIO::TypeDesc::PTR);
    if (!given) return false;
    std::memcpy(&pyramid_, given->data(), sizeof pyramid_);
    if (!seek_subimage(0, 0)) return false;
    spec = m_spec;
    return true;
  }
  bool close() override { return true; }
  int current_subimage() const override { return 0; }
  int current_miplevel() const override { return level_; }
  bool seek_subimage(int subimage, int level) override {
    if (subimage != 0 || level < 0 || level >= pyramid_->levels()) return false;
    level_ = level;
    const Pyramid::Level& own = pyramid_->level(level);
    m_spec = OIIO::ImageSpec(own.width, own.height, channels, OIIO::TypeDesc::FLOAT);
    m_spec.tile_width = m_spec.tile_height = tile;
    m_spec.tile_depth = 1;
    m_spec["textureformat"] = "Plain Texture";
    m_spec["oiio:ColorSpace"] = "Linear";
    return true;
  }
  bool read_native_scanline(int, int, int, int, void*) override { return false; }
  bool read_native_tile(int subimage, int level, int x, int y, int, void* data) override {
    if (!seek_subimage(subimage, level)) return false;
    const Pyramid::Level& own = pyramid_->level(level);
    auto* out = static_cast<float*>(data);
    for (int j = y; j < y + tile; ++j) {
      for (int i = x; i < x + tile; ++i, out += channels) {
        if (i >= own.width || j >= own.height) {
          std::fill_n(out, channels, 0.0F);
        } else {
          std::copy_n(own.rgba.data() + 4 * (static_cast<std::size_t>(j) * static_cast<std::size_t>(own.width) +
                                             static_cast<std::size_t>(i)),
                      channels, out);
        }
      }
    }
    return true;
  }

 private:
  const Pyramid* pyramid_ = nullptr;
  int level_ = 0;
};

// The TextureSystem of the process, in which every texture is a file of its own. It is never destroyed: OpenImageIO
// would delete it as another type than the one that it made.
class System {
 public:
  static System& get() {
    static System* const system = new System;
    return *system;
  }

  OIIO::TextureSystem& operator*() { return *system_; }
  OIIO::TextureSystem* operator->() { return system_; }

  // A name that no other texture has, and room for that many megabytes of tiles until release().
  OIIO::ustring reserve(float megabytes) {
    const std::lock_guard lock(mutex_);
    add(megabytes);
    return OIIO::ustring(fmt::format("moire texture {}", ++textures_));
  }
  void release(OIIO::ustring file, float megabytes) {
    const std::lock_guard lock(mutex_);
    system_->invalidate(file, true);
    add(-megabytes);
  }

 private:
  System() : system_(OIIO::TextureSystem::create(false)) {}
  void add(float megabytes) {
    megabytes_ += megabytes;
    system_->attribute("max_memory_MB", megabytes_);
  }

  OIIO::TextureSystem* system_;
  std::mutex mutex_;
  float megabytes_ = 64;
  std::uint64_t textures_ = 0;
};

OIIO::TextureOpt::Wrap wrap_of(Wrap wrap) {
  switch (wrap) {
    case Wrap::mirror:
      return OIIO::TextureOpt::WrapMirror;
    case Wrap::repeat:
      return OIIO::TextureOpt::WrapPeriodic;
    case Wrap::clamp:
      break;
  }
  return OIIO::TextureOpt::WrapClamp;
}

OIIO::TextureOpt::MipMode mip_mode_of(OiioOptions::Mip mip) {
  switch (mip) {
    case OiioOptions::Mip::anisotropic:
      return OIIO::TextureOpt::MipModeAniso;
    case OiioOptions::Mip::trilinear:
      return OIIO::TextureOpt::MipModeTrilinear;
    case OiioOptions::Mip::one_level:
      return OIIO::TextureOpt::MipModeOneLevel;
    case OiioOptions::Mip::none:
      break;
  }
  return OIIO::TextureOpt::MipModeNoMIP;
}

OIIO::TextureOpt::InterpMode interpolation_mode_of(OiioOptions::Interpolation interpolation) {
  switch (interpolation) {
    case OiioOptions::Interpolation::smart_bicubic:
      return OIIO::TextureOpt::InterpSmartBicubic;
    case OiioOptions::Interpolation::bicubic:
      return OIIO::TextureOpt::InterpBicubic;
    case OiioOptions::Interpolation::bilinear:
      return OIIO::TextureOpt::InterpBilinear;
    case OiioOptions::Interpolation::closest:
      break;
  }
  return OIIO::TextureOpt::InterpClosest;
}

constexpr Color nothing() {
  constexpr float none = std::numeric_limits<float>::quiet_NaN();
  return {none, none, none};
}

// In textures, the unit of OpenImageIO, without the copies that lie before it: a float keeps no fraction of places far
// out. Two textures are the period where every other one is mirrored.
float place(double coordinate, int size, Wrap wrap) {
  const double textures = coordinate / size;
  if (wrap == Wrap::clamp) return static_cast<float>(std::clamp(textures, -1.0, 2.0));
  const double period = wrap == Wrap::mirror ? 2 : 1;
  return static_cast<float>(textures - period * std::floor(textures / period));
}

// A derivative in textures; one that nobody knows is longer than any pyramid can tell from infinite.
float way(float derivative, int size) {
  constexpr float longest = 1e6F;
  const float textures = derivative / static_cast<float>(size);
  return std::isnan(textures) ? longest : std::clamp(textures, -longest, longest);
}

class PyramidTexture final : public OiioTexture {
 public:
  PyramidTexture(const Pyramid& pyramid, Wrap wrap)
      : width_(pyramid.level(0).width),
        height_(pyramid.level(0).height),
        wrap_(wrap),
        megabytes_(static_cast<float>(8e-5 * width_ * height_) + 1),
        file_(system_.reserve(megabytes_)) {
    try {
      open(pyramid);
    } catch (...) {
      system_.release(file_, megabytes_);
      throw;
    }
  }
  ~PyramidTexture() override { system_.release(file_, megabytes_); }
  PyramidTexture(const PyramidTexture&) = delete;

  Color read(const SurfacePoint& point, const OiioOptions& options) const noexcept override {
    if (!std::isfinite(point.s) || !std::isfinite(point.t)) return nothing();
    OIIO::TextureOpt opt;
    opt.swrap = opt.twrap = wrap_of(wrap_);
    opt.mipmode = mip_mode_of(options.mip);
    opt.interpmode = interpolation_mode_of(options.interpolation);
    opt.anisotropic = options.anisotropic;
    opt.swidth = opt.twidth = options.width;
    float rgb[channels];
    const bool is_read = system_->texture(
        texture_, nullptr, opt, place(point.s, width_, wrap_), place(point.t, height_, wrap_), way(point.ds_dx, width_),
        way(point.dt_dx, height_), way(point.ds_dy, width_), way(point.dt_dy, height_), channels, rgb);
    return is_read ? Color{rgb[0], rgb[1], rgb[2]} : nothing();
  }

 private:
  void open(const Pyramid& pyramid) {
    OIIO::ImageSpec config;
    const Pyramid* const pointer = &pyramid;
    config.attribute(pyramid_attribute, OIIO::TypeDesc::PTR, &pointer);
    system_->imagecache()->add_file(
        file_, []() -> OIIO::ImageInput* { return new PyramidInput; }, &config);
    texture_ = system_->get_texture_handle(file_);
    if (!texture_ || !system_->good(texture_)) refuse();
    load(pyramid);
  }

  [[noreturn]] void refuse() const {
    throw Error(fmt::format("OpenImageIO: cannot hold a texture of {} x {} texels ({})", width_, height_,
                            one_line(system_->geterror())));
  }

  void load(const Pyramid& pyramid) {
    OIIO::TextureOpt opt;
    std::vector<float> texels(channels * static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
    for (int l = 0; l < pyramid.levels(); ++l) {
      const Pyramid::Level& level = pyramid.level(l);
      if (!system_->get_texels(texture_, nullptr, opt, l, 0, level.width, 0, level.height, 0, 1, 0, channels,
                               OIIO::TypeDesc::FLOAT, texels.data())) {
        refuse();
      }
    }
  }

  int width_, height_;
  Wrap wrap_;
  System& system_ = System::get();
  float megabytes_;
  OIIO::ustring file_;
  OIIO::TextureSystem::TextureHandle* texture_ = nullptr;
};

}  // namespace

extern "C" __attribute__((visibility("default"))) MakeOiioTexture moire_make_oiio_texture;

OiioTexture* moire_make_oiio_texture(const Pyramid& pyramid, Wrap wrap, std::string& problem) noexcept {
  OiioTexture* made = nullptr;
  keep_exceptions_inside("OpenImageIO", problem, [&] { made = new PyramidTexture(pyramid, wrap); });
  return made;
}

}  // namespace moire
