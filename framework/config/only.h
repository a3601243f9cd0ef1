// The part of an experiment that `--only SCENE/SAMPLER` asks for.
#pragma once

#include <string>
#include <vector>

#include "config/choices.h"

namespace moire {

// Keeps what is called so or is of a type called so; an empty half keeps all. It is a problem if nothing is left.
void keep_only(const std::string& only, std::vector<Choice>& scenes, std::vector<Choice>& samplers, Problems& problems);

}  // namespace moire
