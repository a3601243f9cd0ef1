// Opens shared objects with Boost.DLL.
#include "loading/opening.h"

#include <dlfcn.h>

#include <deque>

#include <fmt/format.h>
#include <boost/dll/shared_library.hpp>

#include <moire/error.h>

namespace moire {

namespace {

namespace dll = boost::dll;

// Allocated once and never destroyed, so that no library is closed when the program ends.
dll::shared_library& kept(dll::shared_library library) {
  static auto& libraries = *new std::deque<dll::shared_library>;
  return libraries.emplace_back(std::move(library));
}

// Boost.DLL alone would end the program where a static constructor throws: <dlfcn.h> declares that dlopen never throws,
// so that its caller has no way out prepared. A pointer that the compiler cannot see through makes no such promise.
void run_static_constructors(const std::filesystem::path& file) {
  const std::filesystem::path absolute = std::filesystem::absolute(file);  // not looked for in the system's folders
  void* (*volatile const open_library)(const char*, int) = &dlopen;
  void* library = nullptr;
  try {
    library = open_library(absolute.c_str(), RTLD_NOW | RTLD_LOCAL);
  } catch (const std::exception& thrown) {
    throw Error(fmt::format("{}: threw an exception while it was opened ({}); a plugin's static objects must not throw",
                            file.string(), thrown.what()));
  }
  if (!library) {
    throw Error(fmt::format("{}: cannot be opened ({}); every library and symbol it uses must be there", file.string(),
                            dlerror()));
  }
}

const dll::shared_library& open(const std::filesystem::path& file) {
  run_static_constructors(file);
  return kept(
      dll::shared_library(std::filesystem::absolute(file), dll::load_mode::rtld_now | dll::load_mode::rtld_local));
}

template <class Description>
const Description& description(const dll::shared_library& library, const std::filesystem::path& file) {
  if (library.has("moire_plugin")) return library.get<const Description>("moire_plugin");
  throw Error(
      fmt::format("{}: has a moire_record but exports no moire_plugin; define both with MOIRE_SAMPLER or "
                  "MOIRE_SCENE",
                  file.string()));
}

void require_maker(const Plugin& plugin) {
  if (plugin.scene && !plugin.scene->make) {
    throw Error(fmt::format("{}: scene \"{}\" cannot be made (it has no make); give it one", plugin.file.string(),
                            plugin.name));
  }
  if (plugin.sampler && !plugin.sampler->make == !plugin.sampler->make_points) {
    throw Error(fmt::format("{}: sampler \"{}\" cannot be made (it has {} make_points); give it one of the two",
                            plugin.file.string(), plugin.name,
                            plugin.sampler->make ? "both make and" : "neither make nor"));
  }
}

}  // namespace

Plugin open_plugin(const std::filesystem::path& file, const Record& record) {
  const dll::shared_library& library = open(file);
  Plugin plugin{.file = file, .kind = record.kind, .name = record.name, .version = record.version};
  if (record.kind == Kind::sampler) {
    plugin.sampler = &description<SamplerPlugin>(library, file);
  } else {
    plugin.scene = &description<ScenePlugin>(library, file);
  }
  require_maker(plugin);
  return plugin;
}

}  // namespace moire
