// All pictures. A new one is a file here and a line in registry.cpp.
#pragma once

#include <memory>
#include <span>

#include "metrics/description.h"
#include "pictures/picture_pass.h"

namespace moire {

struct RegisteredPicture {
  const PassDescription* description;
  std::unique_ptr<PicturePass> (*make)(const Settings&, const Extent&);
};

std::span<const PassDescription* const> picture_descriptions();
// Requires: a name of one of them.
const RegisteredPicture& registered_picture(std::string_view name);

extern const PassDescription column_over_time_description, enlarged_pixel_description, footprint_description;
std::unique_ptr<PicturePass> make_column_over_time(const Settings& settings, const Extent& extent);
std::unique_ptr<PicturePass> make_enlarged_pixel(const Settings& settings, const Extent& extent);
std::unique_ptr<PicturePass> make_footprint(const Settings& settings, const Extent& extent);

}  // namespace moire
