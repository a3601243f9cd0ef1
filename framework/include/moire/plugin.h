// What a plugin exports: `moire_record`, read from the file before it is opened, and `moire_plugin`, reached after.
//
//   MOIRE_SAMPLER(point, "1.0.0", (moire::SamplerPlugin{.summary = "...", ...}))
//
// A plugin is one shared object built with hidden visibility; objects it made are destroyed before the program ends,
// and it is never unloaded.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>

#include <moire/sampler.h>
#include <moire/scene.h>
#include <moire/settings.h>

namespace moire {

// Rises whenever a type or function of the SDK changes so that plugins must be rebuilt.
inline constexpr std::uint32_t interface_version = 5;

enum class Kind : std::uint32_t { sampler = 1, scene = 2 };

// The questions of a Frame, as a set.
enum class Questions : std::uint32_t {
  none = 0,
  points = 1,               // Frame::trace
  lines = 2,                // Frame::lines
  radial_lines = 4,         // Frame::lines, with a pole
  polygons = 8,             // Frame::polygons
  surface = 16,             // Frame::surface
  curves = 32,              // Frame::curves
  averages = 64,            // Frame::averages over pixels
  filtered_averages = 128,  // Frame::averages under any filter
  spectrum = 256,           // Frame::spectrum
  receivers = 512,          // Frame::receivers
};
constexpr Questions operator|(Questions a, Questions b) {
  return static_cast<Questions>(static_cast<std::uint32_t>(a) | static_cast<std::uint32_t>(b));
}
constexpr Questions operator&(Questions a, Questions b) {
  return static_cast<Questions>(static_cast<std::uint32_t>(a) & static_cast<std::uint32_t>(b));
}

// What the author promises and the conformance tests check.
struct Claims {
  bool deterministic = true;  // draws no random numbers
  bool unbiased = false;      // its mean over seeds is the exact image
  bool exact = false;         // no sampling error
};

// How far a sampler can be trusted as the reference of a scene.
enum class Trust : std::uint32_t { none, many_points, many_lines, exact };

struct SamplerPlugin {
  std::string_view summary;  // one sentence
  std::string_view source;   // paper, section, equation
  std::span<const Parameter> parameters = {};
  Questions (*asks)(const Settings&) = [](const Settings&) { return Questions::points; };
  Claims claims = {};
  // Changes `settings` (all defaults) to the best this sampler can do for a scene that answers `answered`, and says how
  // good that is; `effort` 2 takes twice as many lines, or points along each axis, as 1. Null: it is no reference.
  Trust (*reference)(Questions answered, int effort, Settings& settings) = nullptr;
  std::string_view lookup = "nearest";  // the lookup used unless the experiment names one
  // Whether renderings save time by RenderRequest::previous.
  bool (*continues)(const Settings&) = [](const Settings&) { return false; };
  // Whether it heeds RenderRequest::filter; of a pattern of points the host does it.
  bool takes_filters = false;
  // Part of an installation only where what it needs is there: schemas leave it out, experiments name it
  // "if_installed".
  bool is_optional = false;
  // One of the two.
  std::unique_ptr<PointSampler> (*make_points)(const Settings&) = nullptr;
  std::unique_ptr<Sampler> (*make)(const Settings&) = nullptr;
};

struct ScenePlugin {
  std::string_view summary;
  std::string_view source;
  std::span<const Parameter> parameters = {};
  Questions (*answers)(const Settings&) = [](const Settings&) { return Questions::points; };
  // What the table cannot say, such as two settings that exclude each other: a phrase, or nothing. Cheap, reads no
  // data.
  std::string (*problem)(const Settings&) = [](const Settings&) { return std::string(); };
  std::unique_ptr<Scene> (*make)(const Settings&) = nullptr;
};

// Flat bytes without pointers, found in the file by its magic words.
struct Record {
  char magic[16];
  std::uint32_t interface_version;
  Kind kind;
  std::uint64_t abi_tag;
  char name[64];
  char version[16];
};

inline constexpr char record_magic[17] = "moire plugin\x01\x02\x03\x04";

// From the sizes of what crosses the boundary and from what changes the standard library's; not from the compiler.
constexpr std::uint64_t abi_tag() {
  std::uint64_t tag = 14695981039346656037U;  // FNV-1a
  const auto mix = [&tag](std::uint64_t value) { tag = (tag ^ value) * 1099511628211U; };
  for (std::uint64_t size : {sizeof(Tally), sizeof(PixelBlock), sizeof(SurfacePoint), sizeof(SamplePoint), sizeof(Hit),
                             sizeof(Texture), sizeof(Polygon), sizeof(RenderRequest), sizeof(Points), sizeof(Settings),
                             sizeof(Parameter), sizeof(SamplerPlugin), sizeof(ScenePlugin), sizeof(std::string)}) {
    mix(size);
  }
#ifdef _GLIBCXX_DEBUG
  mix(1);
#endif
#if defined(_GLIBCXX_USE_CXX11_ABI) && !_GLIBCXX_USE_CXX11_ABI
  mix(2);
#endif
#ifdef __SANITIZE_ADDRESS__
  mix(3);
#endif
#ifdef __SANITIZE_THREAD__
  mix(4);
#endif
  return tag;
}

constexpr Record make_record(Kind kind, std::string_view name, std::string_view version) {
  Record record{{}, interface_version, kind, abi_tag(), {}, {}};
  for (std::size_t i = 0; i < sizeof record.magic; ++i) record.magic[i] = record_magic[i];
  for (std::size_t i = 0; i < name.size() && i + 1 < sizeof record.name; ++i) record.name[i] = name[i];
  for (std::size_t i = 0; i < version.size() && i + 1 < sizeof record.version; ++i) record.version[i] = version[i];
  return record;
}

}  // namespace moire

#define MOIRE_EXPORT_PLUGIN(kind, type, name, version, plugin)                        \
  extern "C" __attribute__((visibility("default"))) const moire::Record moire_record; \
  extern "C" __attribute__((visibility("default"))) const type moire_plugin;          \
  constexpr moire::Record moire_record = moire::make_record(kind, #name, version);    \
  constexpr type moire_plugin = plugin;

// `plugin` is a SamplerPlugin in parentheses, made of constants.
#define MOIRE_SAMPLER(name, version, plugin) \
  MOIRE_EXPORT_PLUGIN(moire::Kind::sampler, moire::SamplerPlugin, name, version, plugin)

// The same for a ScenePlugin.
#define MOIRE_SCENE(name, version, plugin) \
  MOIRE_EXPORT_PLUGIN(moire::Kind::scene, moire::ScenePlugin, name, version, plugin)
