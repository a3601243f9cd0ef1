// The known name that a misspelt one probably meant.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace moire {

// The first of those with the fewest letters put in, left out, changed or swapped with their neighbour; nothing if that
// takes more than a third of the name's letters (one is always allowed).
std::optional<std::string_view> nearest_name(std::string_view name, std::span<const std::string_view> known);

// `; did you mean "layout"?`, or only the `;` before what would be right.
std::string did_you_mean(std::string_view name, std::span<const std::string_view> known);

// "n, layout, lookup".
std::string listed(std::span<const std::string_view> names);

}  // namespace moire
