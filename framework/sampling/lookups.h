// The lookups: how a place on a texture becomes colour. A new one is a file in lookups/ and a line in lookups.cpp.
#pragma once

#include <memory>
#include <span>
#include <string_view>

#include <moire/texture.h>

#include "config/experiment.h"

namespace moire {

// "nearest" first.
std::span<const NamedSummary> lookups();

// Null for "nearest": the scene's own colours. What `settings` lacks of the lookup's table has its default.
// Requires: a name from lookups().
std::unique_ptr<Lookup> make_lookup(std::string_view name, const Settings& settings = {});

std::unique_ptr<Lookup> make_linear_across();
std::unique_ptr<Lookup> make_bilinear();
// Their settings are of their rows in lookups.cpp.
std::unique_ptr<Lookup> make_mipmap(const Settings& settings);
std::unique_ptr<Lookup> make_anisotropic(const Settings& settings);
std::unique_ptr<Lookup> make_oiio(const Settings& settings);

}  // namespace moire
