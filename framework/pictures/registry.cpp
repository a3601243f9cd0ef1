#include "pictures/registry.h"

#include <algorithm>
#include <array>

namespace moire {

namespace {

constexpr std::array entries{
    RegisteredPicture{&footprint_description, make_footprint},
    RegisteredPicture{&enlarged_pixel_description, make_enlarged_pixel},
    RegisteredPicture{&column_over_time_description, make_column_over_time},
};

}  // namespace

std::span<const PassDescription* const> picture_descriptions() {
  static constexpr auto descriptions = [] {
    std::array<const PassDescription*, entries.size()> result{};
    std::transform(entries.begin(), entries.end(), result.begin(), [](const auto& e) { return e.description; });
    return result;
  }();
  return descriptions;
}

const RegisteredPicture& registered_picture(std::string_view name) {
  return *std::find_if(entries.begin(), entries.end(), [&](const auto& e) { return e.description->name == name; });
}

}  // namespace moire
