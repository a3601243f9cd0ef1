#include "files/whole_file.h"

#include <catch2/catch_test_macros.hpp>
#include <iterator>

#include "message_of.h"
#include "temporary_folder.h"

namespace moire::test {

TEST_CASE("a file written whole replaces the one before and leaves nothing else behind") {
  const TemporaryFolder folder;
  const auto file = folder.file("results.csv", "old and longer");
  write_whole_file(file, "new");
  CHECK(bytes_of(file) == "new");
  CHECK(std::distance(std::filesystem::directory_iterator(folder.path()), {}) == 1);
}

TEST_CASE("a file that cannot be written is named with the reason") {
  const TemporaryFolder folder;
  const auto missing = folder.path() / "missing" / "results.csv";
  CHECK(message_of([&] { write_whole_file(missing, "text"); }) ==
        missing.string() +
            ": cannot be written (No such file or directory); the folder must exist, be writable and have room");

  const auto occupied = folder.path() / "occupied";
  std::filesystem::create_directory(occupied);
  CHECK(message_of([&] { write_whole_file(occupied, "text"); }) ==
        occupied.string() + ": cannot be written (Is a directory); the folder must exist, be writable and have room");
  CHECK(std::distance(std::filesystem::directory_iterator(folder.path()), {}) == 1);
}

TEST_CASE("a folder cannot be read as a file") {
  const TemporaryFolder folder;
  CHECK(message_of([&] { read_whole_file(folder.path()); }) ==
        folder.path().string() + ": cannot be read (Is a directory); a readable file is needed");
}

}  // namespace moire::test
