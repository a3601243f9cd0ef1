// What is found out about a plugin before it is opened: the bytes of a good one are changed in one place each.
#include "loading/record.h"

#include <elf.h>

#include <fmt/format.h>
#include <catch2/catch_test_macros.hpp>
#include <cstring>

#include "framework/loading/changed_record.h"
#include "message_of.h"
#include "temporary_folder.h"

using moire::test::bytes_of;
using moire::test::message_of;
using moire::test::TemporaryFolder;

namespace {

std::string good_bytes() { return bytes_of(TEST_PLUGINS "/good_sampler.so"); }

template <class Change>
std::string with_record(Change change) {
  std::string bytes = good_bytes();
  moire::test::change_record(bytes, change);
  return bytes;
}

template <class Change>
std::string with_header(Change change) {
  std::string bytes = good_bytes();
  Elf64_Ehdr header;
  std::memcpy(&header, bytes.data(), sizeof header);
  change(header);
  std::memcpy(bytes.data(), &header, sizeof header);
  return bytes;
}

// The message about a file of these bytes, after its name.
std::string complaint(const std::string& bytes) {
  const TemporaryFolder folder;
  const auto file = folder.file("tried.so", bytes);
  const std::string message = message_of([&] { moire::read_record(file); });
  REQUIRE(message.starts_with(file.string() + ": "));
  return message.substr(file.string().size() + 2);
}

}  // namespace

TEST_CASE("a record is read from the file without opening it") {
  const moire::Record record = moire::read_record(TEST_PLUGINS "/throwing.so");
  CHECK(record.kind == moire::Kind::sampler);
  CHECK(std::string(record.name) == "throwing");
  CHECK(std::string(record.version) == "1.0.0");
}

TEST_CASE("the magic words as text are not taken for a record") {
  std::string bytes = with_record([](moire::Record& record) { record.magic[0] = 'M'; });
  bytes.append(moire::record_magic, sizeof moire::record_magic);
  bytes.append(sizeof(moire::Record), 'x');
  CHECK(complaint(bytes).starts_with("is no plugin (it has no moire_record)"));
}

TEST_CASE("a stripped library has its record") {
  const TemporaryFolder folder;
  const auto file = folder.file("stripped.so", good_bytes());
  REQUIRE(std::system(fmt::format("{} {}", STRIP, file.string()).c_str()) == 0);
  REQUIRE(bytes_of(file).size() < good_bytes().size());
  CHECK(std::string(moire::read_record(file).name) == "good");
}

TEST_CASE("a library without section headers has its record") {
  std::size_t end = 0;
  std::string bytes = with_header([&](Elf64_Ehdr& header) {
    end = header.e_shoff;
    header.e_shoff = 0;
    header.e_shnum = header.e_shstrndx = 0;
  });
  const TemporaryFolder folder;
  bytes.resize(end);
  CHECK(std::string(moire::read_record(folder.file("headless.so", bytes)).name) == "good");
}

TEST_CASE("files that are no shared objects are refused") {
  const std::string rest = "; a plugin is built with moire_add_sampler or moire_add_scene";
  CHECK(complaint("") == "is no shared object (it is empty)" + rest);
  CHECK(complaint("# a note\n") == "is no shared object (it has no ELF header)" + rest);
  CHECK(
      complaint(with_header([](Elf64_Ehdr& header) { header.e_type = ET_REL; })) ==
      "is an ELF file, but no shared object (type 1, program headers of 56 bytes); build it with moire_add_sampler or "
      "moire_add_scene");
}

TEST_CASE("libraries for other machines are refused") {
  const std::string rest = "; plugins are built for 64-bit x86-64";
  CHECK(complaint(with_header([](Elf64_Ehdr& header) { header.e_machine = EM_AARCH64; })) ==
        "is for another machine (64-bit, ELF machine 183)" + rest);
  CHECK(complaint(with_header([](Elf64_Ehdr& header) { header.e_ident[EI_CLASS] = ELFCLASS32; })) ==
        "is for another machine (32-bit, ELF machine 62)" + rest);
}

TEST_CASE("libraries that are cut short are refused") {
  const std::string whole = good_bytes();
  for (const std::size_t length : {std::size_t{65}, std::size_t{100}, whole.size() / 2, whole.size() - 1}) {
    CHECK(complaint(whole.substr(0, length)) ==
          fmt::format("is cut short ({} bytes of {}); build or copy it again", length, whole.size()));
  }
  CHECK(complaint(whole.substr(0, 20)) == "is cut short (20 bytes of 64); build or copy it again");
}

TEST_CASE("a library without section headers that is cut short is refused") {
  std::string bytes = with_header([](Elf64_Ehdr& header) { header.e_shoff = 0; });
  bytes.resize(1000);
  const std::string message = complaint(bytes);
  CHECK(message.starts_with("is cut short (1000 bytes of "));
  CHECK(message.ends_with("); build or copy it again"));
}

TEST_CASE("headers that speak of impossible lengths are refused") {
  const std::string whole = good_bytes();
  CHECK(complaint(with_header([](Elf64_Ehdr& header) { header.e_phoff = ~0ULL - 8; })) ==
        fmt::format("is cut short ({} bytes of 18446744073709551615); build or copy it again", whole.size()));
}

TEST_CASE("a library without a record is no plugin") {
  CHECK(complaint(with_record([](moire::Record& record) { record.magic[0] = 'M'; })) ==
        "is no plugin (it has no moire_record); build it with moire_add_sampler or moire_add_scene, or remove it from "
        "this folder");
}

TEST_CASE("a plugin of another interface version is refused") {
  CHECK(complaint(with_record([](moire::Record& record) {
          record.interface_version = 7;
          record.abi_tag = 0;  // means nothing in another version
        })) == fmt::format("was built for another interface (version 7); this program takes version {}: rebuild the "
                           "plugin with this program's SDK",
                           moire::interface_version));
}

TEST_CASE("a plugin of another ABI is refused") {
  CHECK(complaint(with_record([](moire::Record& record) { record.abi_tag = 0xabc; })) ==
        fmt::format("was built with other type sizes, sanitizers or standard library settings (ABI tag "
                    "0000000000000abc); this program has {:016x}: rebuild the plugin with the same SDK and flags",
                    moire::abi_tag()));
}

TEST_CASE("records with senseless fields are refused") {
  CHECK(complaint(with_record([](moire::Record& record) { record.kind = static_cast<moire::Kind>(9); })) ==
        "is of an unknown kind (9); plugins are samplers (1) or scenes (2)");
  const std::string damaged =
      "has a damaged moire_record (its name or version is empty or has no end); build it with moire_add_sampler or "
      "moire_add_scene";
  CHECK(complaint(with_record([](moire::Record& record) { record.name[0] = 0; })) == damaged);
  CHECK(complaint(with_record(
            [](moire::Record& record) { std::memset(record.version, '1', sizeof record.version); })) == damaged);
}

TEST_CASE("a file that cannot be read is refused") {
  const TemporaryFolder folder;
  const auto file = folder.path() / "tried.so";
  std::filesystem::create_symlink("nowhere", file);
  CHECK(message_of([&] { moire::read_record(file); }) ==
        file.string() + ": cannot be read (No such file or directory); make it readable or remove it");
}
