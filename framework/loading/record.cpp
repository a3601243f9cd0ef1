// Finds the record by its magic words and compares it with this program's interface.
#include "loading/record.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <optional>
#include <system_error>

#include <fmt/format.h>

#include <moire/error.h>

#include "loading/elf.h"

namespace moire {

namespace {

std::string read_bytes(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  if (stream.bad() || !stream.is_open()) {
    throw Error(fmt::format("{}: cannot be read ({}); make it readable or remove it", file.string(),
                            std::generic_category().message(errno)));
  }
  return bytes;
}

// The magic words may also stand in the file as text, which ends with a 0 where a record has its interface version,
// counted from 1 and far from 256.
bool is_record(const Record& candidate) {
  return candidate.interface_version >= 1 && candidate.interface_version <= 255;
}

std::optional<Record> find_record(std::string_view bytes) {
  const std::string_view magic(record_magic, sizeof Record::magic);
  for (auto place = bytes.find(magic); place != bytes.npos; place = bytes.find(magic, place + 1)) {
    Record record;
    if (bytes.size() - place < sizeof record) break;
    std::memcpy(&record, bytes.data() + place, sizeof record);
    if (is_record(record)) return record;
  }
  return std::nullopt;
}

template <std::size_t size>
bool is_text(const char (&field)[size]) {
  return field[0] != 0 && std::memchr(field, 0, size);
}

void require_this_interface(const std::filesystem::path& file, const Record& record) {
  // First of all, since another version may mean other things by the rest.
  if (record.interface_version != interface_version) {
    throw Error(
        fmt::format("{}: was built for another interface (version {}); this program takes version {}: rebuild "
                    "the plugin with this program's SDK",
                    file.string(), record.interface_version, interface_version));
  }
  if (record.abi_tag != abi_tag()) {
    throw Error(
        fmt::format("{}: was built with other type sizes, sanitizers or standard library settings (ABI tag "
                    "{:016x}); this program has {:016x}: rebuild the plugin with the same SDK and flags",
                    file.string(), record.abi_tag, abi_tag()));
  }
  if (record.kind != Kind::sampler && record.kind != Kind::scene) {
    throw Error(fmt::format("{}: is of an unknown kind ({}); plugins are samplers ({}) or scenes ({})", file.string(),
                            static_cast<unsigned>(record.kind), static_cast<unsigned>(Kind::sampler),
                            static_cast<unsigned>(Kind::scene)));
  }
  if (!is_text(record.name) || !is_text(record.version)) {
    throw Error(
        fmt::format("{}: has a damaged moire_record (its name or version is empty or has no end); build it with "
                    "moire_add_sampler or moire_add_scene",
                    file.string()));
  }
}

}  // namespace

Record read_record(const std::filesystem::path& file) {
  const std::string bytes = read_bytes(file);
  require_whole_shared_object(file, bytes);
  const std::optional<Record> record = find_record(bytes);
  if (!record) {
    throw Error(
        fmt::format("{}: is no plugin (it has no moire_record); build it with moire_add_sampler or "
                    "moire_add_scene, or remove it from this folder",
                    file.string()));
  }
  require_this_interface(file, *record);
  return *record;
}

}  // namespace moire
