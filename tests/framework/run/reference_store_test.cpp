// Kept references: taken only where all that they depend on is the same, the same bits, and never what is damaged.
#include "run/reference_store.h"

#include <sys/wait.h>
#include <unistd.h>

#include <bit>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <cstdlib>
#include <set>

#include "files/whole_file.h"
#include "framework/run/keyed_plugins.h"
#include "message_of.h"
#include "temporary_folder.h"

namespace moire::test {

namespace {

using namespace parameter;
namespace fs = std::filesystem;

constexpr SamplerPlugin random_plugin{
    .summary = "", .source = "", .parameters = sampler_parameters, .claims = {.deterministic = false}};

constexpr ImageSize size{3, 2};

// A store and a request, whose parts a test may change one by one.
struct Case {
  TemporaryFolder folder;
  Plugin scene_file = scene_in(folder);
  Plugin sampler_file = sampler_in(folder, "truth");
  Plugin half_file = sampler_in(folder, "half");
  ReferenceRequest request;
  std::string program = "program 1";
  bool is_fresh = false;
  fs::path place = folder.path() / "cache" / "references";

  Case() {
    folder.file("a.png", "heights");
    request = {{{"truth", &sampler_file, Settings(sampler_parameters), "nearest"},
                SamplerChoice{"half", &half_file, Settings(sampler_parameters), "nearest"},
                false},
               {"a scene", &scene_file, Settings(scene_parameters)},
               "",
               size,
               5,
               7};
    request.scene.settings.set("height", (folder.path() / "a.png").string());
  }
  Case(const Case&) = delete;

  std::string key() const {
    ContentHashes hashes;
    return reference_key(request, program, hashes).dump();
  }

  // What the store gives; `made` counts how often it was made.
  mutable int made = 0;
  Reference find_or_make(const Reference& reference) const {
    ContentHashes hashes;
    return ReferenceStore(place, program, is_fresh).find_or_make(request, hashes, [&] {
      ++made;
      return reference;
    });
  }
  fs::path kept(const char* extension) const {
    for (const auto& entry : fs::directory_iterator(place)) {
      if (entry.path().extension() == extension) return entry.path();
    }
    return {};
  }
};

// With what a picture may hold: no number, infinities, -0, what is too small for its exponent.
Reference some_reference(float first = 0.1F) {
  const float nan = std::bit_cast<float>(0x7fc12345U), least = std::bit_cast<float>(1U);
  return {"truth",
          {size, {{first, 1, 1e-30F}, {-0.0F, HUGE_VALF, -HUGE_VALF}, {nan, least, 3}, {}, {1, 2, 3}, {4, 5, 6}}},
          0.1 + 0.2,
          "by hand",
          "computed now"};
}

std::vector<std::uint32_t> bits(const Picture& picture) {
  std::vector<std::uint32_t> result;
  for (const Color& c : picture.pixels) {
    for (float channel : {c.r, c.g, c.b}) result.push_back(std::bit_cast<std::uint32_t>(channel));
  }
  return result;
}

void set_cache(const char* value) {
  if (value) {
    setenv("MOIRE_CACHE", value, 1);
  } else {
    unsetenv("MOIRE_CACHE");
  }
}

}  // namespace

TEST_CASE("a reference is made once, and then found with the same bits") {
  const Case c;
  const Reference made = c.find_or_make(some_reference());
  CHECK(made.origin == "computed now");
  const Reference found = c.find_or_make(some_reference(0.9F));
  CHECK(c.made == 1);
  CHECK(found.origin == "kept from before");
  CHECK(bits(found.picture) == bits(some_reference().picture));
  CHECK(found.picture.size == size);
  CHECK(found.error == some_reference().error);
  CHECK(found.how == "by hand");
}

TEST_CASE("an unknown error of a kept reference stays unknown") {
  const Case c;
  Reference reference = some_reference();
  reference.error = std::nan("");
  c.find_or_make(reference);
  CHECK(std::isnan(c.find_or_make(reference).error));
  CHECK(c.made == 1);
}

TEST_CASE("labels, where files lie, and numbers that nobody draws by do not matter") {
  Case c;
  c.find_or_make(some_reference());
  fs::rename(c.folder.path() / "a.png", c.folder.path() / "b.png");
  c.request.scene.settings.set("height", (c.folder.path() / "b.png").string());
  c.request.scene.name = "another label";
  c.request.changes = "far=10";
  c.request.choice.sampler.name = "another truth";
  c.request.choice.half->name = "another half";
  c.request.frame_number = 6;
  c.request.seed = 8;
  const Reference found = c.find_or_make(some_reference());
  CHECK(c.made == 1);
  CHECK(found.recipe == "another truth; far=10");
}

TEST_CASE("whatever changes a reference changes its key") {
  std::set<std::string> keys{Case().key()};
  const auto changed = [&](auto change) {
    Case c;
    change(c);
    return keys.insert(c.key()).second;
  };
  CHECK_FALSE(changed([](Case&) {}));
  CHECK(changed([](Case& c) { c.program = "program 2"; }));
  CHECK(changed([](Case& c) { c.request.image.width = 4; }));
  CHECK(changed([](Case& c) { c.request.image.height = 4; }));
  CHECK(changed([](Case& c) { c.request.scene.settings.set("far", 11.0); }));
  CHECK(changed([](Case& c) { c.request.scene.settings.set("height", std::string()); }));
  CHECK(changed([](Case& c) { c.folder.file("a.png", "other heights"); }));
  CHECK(changed([](Case& c) { c.folder.file("hills.so", "hills 2"); }));
  CHECK(changed([](Case& c) { c.folder.file("truth.so", "truth 2"); }));
  CHECK(changed([](Case& c) { c.folder.file("half.so", "half 2"); }));
  CHECK(changed([](Case& c) { c.request.choice.sampler.settings.set("n", std::int64_t{5}); }));
  CHECK(changed([](Case& c) { c.request.choice.sampler.lookup = "bilinear"; }));
  CHECK(changed([](Case& c) { c.request.choice.half->settings.set("n", std::int64_t{5}); }));
  CHECK(changed([](Case& c) { c.request.choice.half.reset(); }));
  CHECK(changed([](Case& c) { c.request.choice.is_exact = true; }));
}

TEST_CASE("seed and frame matter to a reference that draws random numbers, or whose weaker form does") {
  for (const bool in_half : {false, true}) {
    CAPTURE(in_half);
    std::set<std::string> keys;
    const auto changed = [&](std::uint64_t seed, int frame) {
      Case c;
      (in_half ? c.half_file : c.sampler_file).sampler = &random_plugin;
      c.request.seed = seed;
      c.request.frame_number = frame;
      return keys.insert(c.key()).second;
    };
    CHECK(changed(1, 1));
    CHECK(changed(2, 1));
    CHECK(changed(1, 2));
    CHECK_FALSE(changed(1, 1));
  }
}

TEST_CASE("a kept reference that is damaged, cut short or something else is made again, said and put right") {
  const auto check = [](const char* extension, auto damage, const std::string& what) {
    CAPTURE(extension, what);
    const Case c;
    c.find_or_make(some_reference());
    const fs::path file = c.kept(extension);
    std::string bytes = read_whole_file(file);
    damage(bytes);
    write_whole_file(file, bytes);
    const Reference again = c.find_or_make(some_reference());
    CHECK(c.made == 2);
    CHECK(again.origin == "computed now: what was kept cannot be used, " + file.string() + ": " + what);
    CHECK(bits(again.picture) == bits(some_reference().picture));
    CHECK(c.find_or_make(some_reference()).origin == "kept from before");
  };
  check(
      ".floats", [](std::string& b) { b[17] = static_cast<char>(b[17] ^ 4); }, "has a wrong checksum");
  check(
      ".floats", [](std::string& b) { b.pop_back(); }, "has another length");
  check(
      ".floats", [](std::string& b) { b.clear(); }, "has another length");
  check(
      ".json", [](std::string& b) { b.resize(b.size() / 2); }, "is not JSON");
  check(
      ".json", [](std::string& b) { b.clear(); }, "is not JSON");
  check(
      ".json", [](std::string& b) { b = "{}"; }, "lacks what such a file has");
  check(
      ".json", [](std::string& b) { b = "[1, 2]"; }, "lacks what such a file has");
  check(
      ".json", [](std::string& b) { b.replace(b.find("0.30000"), 3, "0.2"); }, "has a wrong checksum");
  check(
      ".json", [](std::string& b) { b.replace(b.find("by hand"), 2, "my"); }, "has a wrong checksum");
}

TEST_CASE("the file of another reference under this one's name is not taken") {
  Case c;
  c.find_or_make(some_reference());
  const std::string other = read_whole_file(c.kept(".json"));
  fs::remove_all(c.place);
  c.request.scene.settings.set("far", 11.0);
  c.find_or_make(some_reference());
  write_whole_file(c.kept(".json"), other);
  CHECK(c.find_or_make(some_reference()).origin ==
        "computed now: what was kept cannot be used, " + c.kept(".json").string() + ": is of another reference");
}

TEST_CASE("pixels that are gone are made again") {
  const Case c;
  c.find_or_make(some_reference());
  fs::remove(c.kept(".floats"));
  CHECK(c.find_or_make(some_reference()).origin.starts_with("computed now: what was kept cannot be used, "));
  CHECK(c.find_or_make(some_reference()).origin == "kept from before");
}

TEST_CASE("where nothing can be written nothing is kept, and the run goes on") {
  Case c;
  c.place = c.folder.path() / "a.png" / "references";  // below a file
  for (int k = 1; k <= 2; ++k) {
    const Reference reference = c.find_or_make(some_reference());
    CHECK(c.made == k);
    CHECK(reference.origin == "computed now; not kept, " + c.place.string() + ": cannot be made (Not a directory)");
    CHECK(bits(reference.picture) == bits(some_reference().picture));
  }
}

TEST_CASE("fresh references are made whatever is kept, and kept") {
  Case c;
  c.find_or_make(some_reference());
  c.is_fresh = true;
  CHECK(c.find_or_make(some_reference(0.5F)).origin == "computed now");
  CHECK(c.made == 2);
  c.is_fresh = false;
  CHECK(c.find_or_make(some_reference()).picture.pixels[0].r == 0.5F);
}

TEST_CASE("a store without a folder asks for no file and keeps nothing") {
  Case c;
  c.scene_file.file = "/nowhere";
  ContentHashes hashes;
  for (int k = 0; k < 2; ++k)
    CHECK(ReferenceStore().find_or_make(c.request, hashes, [] { return some_reference(); }).origin == "computed now");
}

TEST_CASE("what throws while a reference is made comes out, and nothing is kept") {
  const Case c;
  ContentHashes hashes;
  CHECK(message_of([&] {
          ReferenceStore(c.place, c.program).find_or_make(c.request, hashes, []() -> Reference {
            throw Error("no reference today");
          });
        }) == "no reference today");
  CHECK_FALSE(fs::exists(c.place));
}

TEST_CASE("two processes that keep and read at once never see half of a reference") {
  const Case c;
  std::vector<pid_t> children;
  for (int child = 0; child < 2; ++child) {
    const pid_t pid = fork();
    REQUIRE(pid >= 0);
    if (pid == 0) {
      // Fresh ones write all the time; in between all that is read must be whole.
      bool is_right = true;
      for (int k = 0; k < 200; ++k) {
        ContentHashes hashes;
        const Reference found = ReferenceStore(c.place, c.program, k % 2 == child).find_or_make(c.request, hashes, [] {
          return some_reference();
        });
        is_right = is_right && bits(found.picture) == bits(some_reference().picture) &&
                   (found.origin == "computed now" || found.origin == "kept from before");
      }
      _exit(is_right ? 0 : 1);
    }
    children.push_back(pid);
  }
  for (const pid_t pid : children) {
    int status = -1;
    REQUIRE(waitpid(pid, &status, 0) == pid);
    CHECK(status == 0);
  }
  CHECK(c.find_or_make(some_reference()).origin == "kept from before");
  CHECK(std::distance(fs::directory_iterator(c.place), fs::directory_iterator()) == 2);  // no temporary file is left
}

TEST_CASE("references are kept in the folder of MOIRE_CACHE, else with the project, else nowhere") {
  const char* const given = std::getenv("MOIRE_CACHE");
  const std::string before = given ? given : "";
  set_cache("/somewhere");
  CHECK(kept_references_folder("/project") == "/somewhere/references");
  CHECK(kept_references_folder("") == "/somewhere/references");
  set_cache("");
  CHECK(kept_references_folder("/project") == "/project/.cache/references");
  CHECK(kept_references_folder("") == "");
  set_cache(nullptr);
  CHECK(kept_references_folder("/project") == "/project/.cache/references");
  set_cache(given ? before.c_str() : nullptr);
}

}  // namespace moire::test
