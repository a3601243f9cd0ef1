#include "run/reference_store.h"

#include <cmath>
#include <cstdlib>
#include <cstring>

#include <fmt/format.h>

#include <moire/error.h>

#include "files/whole_file.h"
#include "run/hash.h"

namespace moire {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

static_assert(sizeof(Color) == 3 * sizeof(float), "pixels are written as they are");

std::string bytes_of(const Picture& picture) {
  return {reinterpret_cast<const char*>(picture.pixels.data()), picture.pixels.size() * sizeof(Color)};
}

// One reference on disk.
class Kept {
 public:
  Kept(const fs::path& folder, const Json& key) : key_(key) {
    const std::string name = hash_of(key.dump());
    json_ = folder / (name + ".json");
    floats_ = folder / (name + ".floats");
  }

  bool is_there() const { return fs::exists(json_); }

  // Error: what is there is damaged, or is something else.
  Reference read(const ReferenceRequest& request) const {
    Json json = parsed(read_whole_file(json_));
    try {
      const std::string checksum = json.at("checksum");
      json.erase("checksum");
      if (checksum != hash_of(json.dump())) refuse(json_, "has a wrong checksum");
      if (json.at("key").dump() != key_.dump()) refuse(json_, "is of another reference");
      Reference reference{recipe_of(request), {request.image, {}}, std::nan(""), json.at("how"), "kept from before"};
      if (!json.at("error").is_null()) reference.error = json.at("error");
      reference.picture.pixels = pixels(request.image, json.at("floats"));
      return reference;
    } catch (const Json::exception&) {
      refuse(json_, "lacks what such a file has");
    }
  }

  // The pixels first: without the other file they do not count.
  void write(const ReferenceRequest& request, const Reference& reference) const {
    std::error_code problem;
    fs::create_directories(json_.parent_path(), problem);
    if (problem) throw Error(fmt::format("{}: cannot be made ({})", json_.parent_path().string(), problem.message()));
    const std::string bytes = bytes_of(reference.picture);
    write_whole_file(floats_, bytes);
    Json json{{"recipe", reference.recipe},
              {"scene", request.scene.name},
              {"error", std::isnan(reference.error) ? Json(nullptr) : Json(reference.error)},
              {"how", reference.how},
              {"floats", hash_of(bytes)},
              {"key", key_}};
    json["checksum"] = hash_of(json.dump());
    write_whole_file(json_, json.dump(2) + "\n");
  }

 private:
  [[noreturn]] static void refuse(const fs::path& file, const char* what) {
    throw Error(fmt::format("{}: {}", file.string(), what));
  }

  Json parsed(const std::string& text) const {
    Json json = Json::parse(text, nullptr, false);
    if (json.is_discarded()) refuse(json_, "is not JSON");
    return json;
  }

  std::vector<Color> pixels(ImageSize size, const std::string& hash) const {
    const std::string bytes = read_whole_file(floats_);
    std::vector<Color> pixels(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height));
    if (bytes.size() != pixels.size() * sizeof(Color)) refuse(floats_, "has another length");
    if (hash_of(bytes) != hash) refuse(floats_, "has a wrong checksum");
    std::memcpy(static_cast<void*>(pixels.data()), bytes.data(), bytes.size());
    return pixels;
  }

  const Json& key_;
  fs::path json_, floats_;
};

bool draws_random_numbers(const SamplerChoice& sampler) { return !sampler.plugin->sampler->claims.deterministic; }

}  // namespace

Json reference_key(const ReferenceRequest& request, const std::string& program, ContentHashes& hashes) {
  const ReferenceChoice& choice = request.choice;
  Json key{{"program", program},
           {"interface", interface_version},
           {"scene", content_of(request.scene, hashes)},
           {"sampler", content_of(choice.sampler, hashes)},
           {"half", choice.half ? content_of(*choice.half, hashes) : Json(nullptr)},
           {"is_exact", choice.is_exact},
           {"image", {request.image.width, request.image.height}}};
  if (draws_random_numbers(choice.sampler) || (choice.half && draws_random_numbers(*choice.half))) {
    key["frame"] = request.frame_number;
    key["seed"] = request.seed;
  }
  return key;
}

Reference ReferenceStore::find_or_make(const ReferenceRequest& request, ContentHashes& hashes,
                                       const std::function<Reference()>& make) const {
  if (folder_.empty()) return make();
  const Json key = reference_key(request, program_, hashes);
  const Kept kept(folder_, key);
  std::string damage;
  try {
    if (!is_fresh_ && kept.is_there()) return kept.read(request);
  } catch (const Error& error) {
    damage = fmt::format(": what was kept cannot be used, {}", error.what());
  }
  Reference reference = make();
  reference.origin += damage;
  try {
    kept.write(request, reference);
  } catch (const Error& error) {
    reference.origin += fmt::format("; not kept, {}", error.what());
  }
  return reference;
}

fs::path kept_references_folder(const fs::path& project) {
  const char* const variable = std::getenv("MOIRE_CACHE");
  if (variable && *variable) return fs::path(variable) / "references";
  return project.empty() ? fs::path() : project / ".cache" / "references";
}

}  // namespace moire
