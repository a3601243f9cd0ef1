#include <algorithm>

#include <fmt/format.h>

#include <moire/error.h>

#include "app/commands.h"
#include "app/replaced.h"
#include "app/sampler_template.h"
#include "files/whole_file.h"

namespace moire::app {

namespace {

// "my_sampler" to "MySampler".
std::string class_name(const std::string& name) {
  std::string result;
  bool starts = true;
  for (char c : name) {
    if (c == '_') {
      starts = true;
    } else {
      result += starts ? static_cast<char>(c - 'a' + 'A') : c;
      starts = false;
    }
  }
  return result;
}

}  // namespace

int new_plugin(const std::string& kind, const std::string& name, const std::filesystem::path& given) {
  const bool fits = !name.empty() && name[0] >= 'a' && name[0] <= 'z' && name.find("__") == std::string::npos &&
                    name.back() != '_' && std::all_of(name.begin(), name.end(), [](char c) {
                      return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
                    });
  if (!fits)
    throw Error(
        fmt::format("new {}: name is \"{}\"; small letters, digits and single underscores would do, such as my_sampler",
                    kind, name));

  const std::filesystem::path of_tree = "plugins/samplers";
  const std::filesystem::path parent = !given.empty()                           ? given
                                       : std::filesystem::is_directory(of_tree) ? of_tree
                                                                                : std::filesystem::path(".");
  const std::filesystem::path folder = parent / name;
  if (std::filesystem::exists(folder)) throw Error(folder.string() + ": is there already; choose another name");
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error)
    throw Error(
        fmt::format("{}: cannot be made ({}); choose another folder with -o", folder.string(), error.message()));
  write_whole_file(folder / (name + ".cpp"),
                   replaced(replaced(sampler_source, "@name@", name), "@Class@", class_name(name)));
  write_whole_file(folder / "CMakeLists.txt", replaced(sampler_build, "@name@", name));
  fmt::print("{}: a sampler with one point in each pixel's middle; change points() and build it\n",
             (folder / (name + ".cpp")).string());
  return done;
}

}  // namespace moire::app
