#include "report/result_folder.h"

#include <fmt/format.h>

#include <moire/error.h>
#include <moire/image.h>

#include "files/whole_file.h"
#include "report/csv.h"
#include "report/error_map.h"
#include "report/json.h"

namespace moire::report {

namespace {

void make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error)
    throw Error(fmt::format("{}: cannot be made ({}); name another folder with -o", folder.string(), error.message()));
}

}  // namespace

ResultFolder::ResultFolder(std::filesystem::path folder) : folder_(std::move(folder)) {
  make_folder(folder_);
  // Found out now rather than after the first hour.
  const std::filesystem::path probe = folder_ / ".writable";
  write_whole_file(probe, "");
  std::filesystem::remove(probe);
}

std::filesystem::path ResultFolder::picture(const std::string& scene, const std::string& sampler,
                                            const Picture& picture) {
  const std::filesystem::path place = std::filesystem::path("images") / scene / sampler;
  make_folder(folder_ / place);
  for (const char* name : {"frame_0000.exr", "frame_0000.png"}) {
    write_image(folder_ / place / name, picture.size.width, picture.size.height, picture.pixels);
  }
  return place / "frame_0000.png";
}

std::filesystem::path ResultFolder::map(const std::string& scene, const std::string& sampler, ImageSize size,
                                        const Map& map) {
  const std::filesystem::path place = std::filesystem::path("images") / scene / sampler;
  make_folder(folder_ / place);
  std::vector<Color> values, colors;
  for (double value : map.values) {
    const auto v = static_cast<float>(value);
    values.push_back({v, v, v});
    colors.push_back(map.kind == "error_signed" ? signed_error_color(value, map.scale)
                                                : absolute_error_color(value, map.scale));
  }
  const std::filesystem::path file = place / fmt::format("{}_0000.png", map.kind);
  write_image(folder_ / file, size.width, size.height, colors);
  write_image(folder_ / std::filesystem::path(file).replace_extension(".exr"), size.width, size.height, values);
  return file;
}

std::filesystem::path ResultFolder::drawing(const std::string& scene, const std::string& sampler,
                                            const std::string& kind, const Picture& picture) {
  const std::filesystem::path place = std::filesystem::path("images") / scene / sampler;
  make_folder(folder_ / place);
  const std::filesystem::path file = place / (kind + ".png");
  write_image(folder_ / file, picture.size.width, picture.size.height, picture.pixels);
  return file;
}

void ResultFolder::save(const Results& results) {
  write_csv(folder_, results);
  write_json(folder_, results);
}

void ResultFolder::save_request(const nlohmann::ordered_json& request) {
  write_whole_file(folder_ / "experiment.json", request.dump(2) + "\n");
}

}  // namespace moire::report
