// Plugins open, and what is wrong with some never ends the process or hides what is wrong with others.
#include "loading/catalog.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cstdlib>

#include "message_of.h"
#include "output_of.h"
#include "temporary_folder.h"

using moire::Catalog;
using moire::Kind;
using moire::test::bytes_of;
using moire::test::message_of;
using moire::test::output_of;
using moire::test::TemporaryFolder;

namespace {

namespace fs = std::filesystem;

// Copies a test plugin into a folder.
fs::path copy(const TemporaryFolder& folder, const std::string& plugin, const std::string& name) {
  return folder.file(name, bytes_of(fs::path(TEST_PLUGINS) / (plugin + ".so")));
}

Catalog open(const fs::path& folder) { return Catalog::open(std::vector{folder}); }

std::string complaint(const TemporaryFolder& folder) {
  return message_of([&] { open(folder.path()); });
}

}  // namespace

TEST_CASE("a catalog finds plugins by kind and name") {
  const TemporaryFolder folder;
  const auto sampler_file = copy(folder, "good_sampler", "any_name.so");
  copy(folder, "good_scene", "scene.so");
  folder.file("README.md", "not looked at");
  const Catalog catalog = open(folder.path());

  const moire::Plugin* const sampler = catalog.find(Kind::sampler, "good");
  REQUIRE(sampler);
  CHECK(sampler->file == sampler_file);
  CHECK(sampler->version == "1.2.3");
  CHECK(sampler->summary() == "A sampler without fault.");
  CHECK(sampler->scene == nullptr);

  const moire::Plugin* const scene = catalog.find(Kind::scene, "good");
  REQUIRE(scene);
  CHECK(scene->summary() == "A scene without fault.");
  CHECK(catalog.find(Kind::scene, "any_name") == nullptr);
  CHECK(catalog.all(Kind::scene) == std::vector{scene});
}

TEST_CASE("the plugins of the program open and work") {
  const Catalog catalog = Catalog::open(moire::plugin_folders({}));
  for (const char* name : {"bilinear", "point", "supersample"}) {
    const moire::Plugin* const plugin = catalog.find(Kind::sampler, name);
    REQUIRE(plugin);
    const auto sampler = plugin->sampler->make_points(moire::Settings(plugin->parameters()));
    moire::Points points;
    sampler->points({}, points);
    CHECK(points.entries().size() == (plugin->name == "supersample" ? 4 : 1));
  }
}

TEST_CASE("plugins are listed by name") {
  const Catalog catalog = Catalog::open(moire::plugin_folders({}));
  std::vector<std::string> names;
  for (const moire::Plugin* plugin : catalog.all(Kind::sampler)) names.push_back(plugin->name);
  CHECK(std::is_sorted(names.begin(), names.end()));
}

TEST_CASE("a folder without plugins gives an empty catalog") {
  const TemporaryFolder folder;
  CHECK(open(folder.path()).all(Kind::sampler).empty());
}

TEST_CASE("a missing folder of plugins is an error") {
  CHECK(message_of([] { open("no/such/folder"); }) ==
        "no/such/folder: plugins cannot be looked for (No such file or directory); name a folder that can be read");
}

TEST_CASE("two plugins of one kind and name are an error that names both files") {
  const TemporaryFolder folder;
  const auto first = copy(folder, "good_sampler", "first.so");
  const auto second = copy(folder, "good_sampler", "second.so");
  CHECK(complaint(folder) == second.string() + ": is a second sampler \"good\" (the first is " + first.string() +
                                 "); remove or rename one of them");
}

TEST_CASE("all that is wrong with the plugins is told at once") {
  const TemporaryFolder folder;
  const std::string a = copy(folder, "no_maker", "a.so"), b = copy(folder, "no_plugin", "b.so");
  const std::string c = folder.file("c.so", "text"), d = folder.file("d.so", "");
  CHECK(complaint(folder) ==
        c +
            ": is no shared object (it has no ELF header); a plugin is built with moire_add_sampler or "
            "moire_add_scene\n" +
            d + ": is no shared object (it is empty); a plugin is built with moire_add_sampler or moire_add_scene\n" +
            a +
            ": sampler \"no_maker\" cannot be made (it has neither make nor make_points); give it one of the two\n" +
            b + ": has a moire_record but exports no moire_plugin; define both with MOIRE_SAMPLER or MOIRE_SCENE");
}

TEST_CASE("a plugin that uses an unknown function is an error that names the function") {
  const TemporaryFolder folder;
  const std::string file = copy(folder, "missing_symbol", "missing_symbol.so");
  CHECK(complaint(folder) == file + ": cannot be opened (" + file +
                                 ": undefined symbol: moire_test_function_of_no_library); every library and symbol it "
                                 "uses must be there");
}

// In a program of its own, since the linker's lock stays taken where an exception leaves dlopen: harmless where that is
// reported and the program ends, but not for the threads of other tests.
TEST_CASE("a plugin whose static constructor throws is an error") {
  const TemporaryFolder folder;
  const std::string thrower = copy(folder, "throwing", "first.so");
  const std::string other = copy(folder, "no_plugin", "second.so");
  copy(folder, "good_sampler", "third.so");
  CHECK(output_of("'" CATALOG_PROBE "' " + folder.path().string()) ==
        thrower +
            ": threw an exception while it was opened (no table for this machine); a plugin's static objects must "
            "not throw\n" +
            other +
            ": has a moire_record but exports no moire_plugin; define both with MOIRE_SAMPLER or MOIRE_SCENE\nexit 2");
}

TEST_CASE("a stripped plugin opens") {
  const TemporaryFolder folder;
  const auto file = copy(folder, "good_sampler", "stripped.so");
  REQUIRE(std::system((std::string(STRIP " ") + file.string()).c_str()) == 0);
  CHECK(open(folder.path()).find(Kind::sampler, "good") != nullptr);
}

TEST_CASE("plugins cut short at any length leave the process alive") {
  const std::string whole = bytes_of(TEST_PLUGINS "/good_sampler.so");
  for (std::size_t part = 0; part < 64; ++part) {
    const TemporaryFolder folder;
    folder.file("cut.so", std::string_view(whole).substr(0, whole.size() * part / 64));
    CHECK_FALSE(complaint(folder) == "(no error)");
  }
}
