// The names of scenes and contenders: `supersample[n=4]`, in reports, tables, folders and messages.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "config/choices.h"

namespace moire {

// Why this cannot be a name, which is a folder's too; empty if it can.
std::string name_problem(std::string_view name);

// Names the choices of one list: by their label, or by their type and those settings that are not the default or not
// the same in all choices of the type. Names that cannot be, or are there twice, are problems. `noun`: "scene".
void name_choices(std::span<Choice> choices, std::string_view noun, Problems& problems);

}  // namespace moire
