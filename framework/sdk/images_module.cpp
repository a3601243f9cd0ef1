#include "sdk/images_module.h"

#include <dlfcn.h>

#include <fmt/format.h>

#include <moire/error.h>

namespace moire {

namespace {

// moire/moire_images.so beside this library, in the build tree as in an installation.
std::filesystem::path module_file() {
  Dl_info library;
  dladdr(reinterpret_cast<void*>(&module_file), &library);
  return std::filesystem::path(library.dli_fname).parent_path() / "moire" / "moire_images.so";
}

void* symbol(void* library, const char* name, const std::filesystem::path& file) {
  if (void* const found = dlsym(library, name)) return found;
  throw Error(fmt::format("{}: has no {}; build it together with this libmoire", file.string(), name));
}

ImagesModule open_module() {
  const std::filesystem::path file = module_file();
  void* const library = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!library) {
    throw Error(
        fmt::format("{}: cannot be opened ({}); images and the lookup \"oiio\" need this part of moire and the "
                    "OpenImageIO library (Debian: libopenimageio-dev)",
                    file.string(), dlerror()));
  }
  return {reinterpret_cast<ReadImage*>(symbol(library, read_image_symbol, file)),
          reinterpret_cast<WriteImage*>(symbol(library, write_image_symbol, file)),
          reinterpret_cast<MakeOiioTexture*>(symbol(library, make_oiio_texture_symbol, file))};
}

}  // namespace

const ImagesModule& images_module() {
  static const ImagesModule opened = open_module();
  return opened;
}

}  // namespace moire
