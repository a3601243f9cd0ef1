// References that outlive a run: computed once, kept on disk under a key of all that they depend on.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include <nlohmann/json.hpp>

#include "run/content.h"
#include "run/reference.h"

namespace moire {

// All that a reference depends on: program, plugins, settings and data by content, the image; frame number and seed
// only if a sampler draws random numbers. Error: a file cannot be read.
nlohmann::ordered_json reference_key(const ReferenceRequest& request, const std::string& program,
                                     ContentHashes& hashes);

// Two files a reference, named by the hash of its key: NAME.floats, the pixels' r, g, b as they are in memory, row 0
// the top; NAME.json, the key, the error and a checksum of both files. Safe to use from many processes at once.
class ReferenceStore {
 public:
  // Keeps nothing.
  ReferenceStore() = default;
  // `folder` is made when it is first needed; empty: nothing is kept. `program`: a hash of what renders. `is_fresh`:
  // nothing is taken from what was kept before.
  ReferenceStore(std::filesystem::path folder, std::string program, bool is_fresh = false)
      : folder_(std::move(folder)), program_(std::move(program)), is_fresh_(is_fresh) {}

  // What is kept, if it is whole, or what `make` makes, which is kept if it can be. The reference's `origin` says
  // which, and why if that is no matter of course. Error: what `make` throws.
  Reference find_or_make(const ReferenceRequest& request, ContentHashes& hashes,
                         const std::function<Reference()>& make) const;

 private:
  std::filesystem::path folder_;
  std::string program_;
  bool is_fresh_ = false;
};

// Where references of a project are kept: `references` of the folder that MOIRE_CACHE names, or of the project's own
// .cache; empty without both. `project`: its root, or empty.
std::filesystem::path kept_references_folder(const std::filesystem::path& project);

}  // namespace moire
