// Reads the ELF headers ("System V Application Binary Interface", chapters 4 and 5) just far enough to know how long
// the file ought to be.
#include "loading/elf.h"

#include <elf.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>

#include <fmt/format.h>

#include <moire/error.h>

namespace moire {

namespace {

// Requires: the value lies within `bytes`.
template <class T>
T at(std::string_view bytes, std::uint64_t offset) {
  T value;
  std::memcpy(&value, bytes.data() + offset, sizeof value);
  return value;
}

// The end of a stretch of the file. Damaged headers may hold anything.
std::uint64_t end_of(std::uint64_t offset, std::uint64_t length) {
  const std::uint64_t end = offset + length;
  return end < offset ? std::numeric_limits<std::uint64_t>::max() : end;
}

void require_length(const std::filesystem::path& file, std::string_view bytes, std::uint64_t needed) {
  if (bytes.size() >= needed) return;
  throw Error(
      fmt::format("{}: is cut short ({} bytes of {}); build or copy it again", file.string(), bytes.size(), needed));
}

void require_loadable_kind(const std::filesystem::path& file, const Elf64_Ehdr& header) {
  const int width = header.e_ident[EI_CLASS] == ELFCLASS64 ? 64 : 32;
  if (width != 64 || header.e_machine != EM_X86_64) {
    throw Error(fmt::format("{}: is for another machine ({}-bit, ELF machine {}); plugins are built for 64-bit x86-64",
                            file.string(), width, header.e_machine));
  }
  if (header.e_type != ET_DYN || header.e_phentsize != sizeof(Elf64_Phdr)) {
    throw Error(
        fmt::format("{}: is an ELF file, but no shared object (type {}, program headers of {} bytes); build it "
                    "with moire_add_sampler or moire_add_scene",
                    file.string(), header.e_type, header.e_phentsize));
  }
}

}  // namespace

void require_whole_shared_object(const std::filesystem::path& file, std::string_view bytes) {
  if (!bytes.starts_with(ELFMAG)) {
    throw Error(fmt::format("{}: is no shared object ({}); a plugin is built with moire_add_sampler or moire_add_scene",
                            file.string(), bytes.empty() ? "it is empty" : "it has no ELF header"));
  }
  require_length(file, bytes, sizeof(Elf64_Ehdr));
  const auto header = at<Elf64_Ehdr>(bytes, 0);
  require_loadable_kind(file, header);

  // The tables of program and section headers; the latter stands at the end, where strip leaves it, but may be missing.
  const std::uint64_t segments_end = end_of(header.e_phoff, std::uint64_t{header.e_phnum} * sizeof(Elf64_Phdr));
  const std::uint64_t sections_end =
      header.e_shoff == 0 ? 0 : end_of(header.e_shoff, std::uint64_t{header.e_shnum} * header.e_shentsize);
  std::uint64_t needed = std::max(segments_end, sections_end);
  require_length(file, bytes, needed);

  // What the segments map.
  for (std::uint64_t i = 0; i < header.e_phnum; ++i) {
    const auto segment = at<Elf64_Phdr>(bytes, header.e_phoff + i * sizeof(Elf64_Phdr));
    needed = std::max(needed, end_of(segment.p_offset, segment.p_filesz));
  }
  require_length(file, bytes, needed);
}

}  // namespace moire
