// Images come back as they were stored, faulty files as messages, and OpenImageIO only when it is needed.
#include <moire/image.h>

#include <sys/resource.h>

#include <bit>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <csignal>
#include <limits>
#include <string>
#include <thread>

#include <moire/random.h>

#include "framework/sdk/png_bytes.h"
#include "message_of.h"
#include "output_of.h"
#include "temporary_folder.h"

#ifdef __SANITIZE_ADDRESS__
#include <sanitizer/lsan_interface.h>
#endif

using moire::Color;
using moire::Depth;
using moire::Image;
using moire::test::bytes_of;
using moire::test::message_of;
using moire::test::output_of;
using moire::test::png_bytes;
using moire::test::PngColor;
using moire::test::TemporaryFolder;

namespace {

namespace fs = std::filesystem;

// The message about an image that ends too early. OpenImageIO 2.4's PNG reader leaks an error text then: libpng jumps
// over its destructor. What is allocated here is not reported as a leak.
std::string message_of_reading(const fs::path& file) {
#ifdef __SANITIZE_ADDRESS__
  const __lsan::ScopedDisabler leaks_allowed;
#endif
  return message_of([&] { moire::read_image(file); });
}

// Colours without pattern, so that no compression makes them small.
std::vector<Color> noise(int width, int height) {
  std::vector<Color> pixels;
  for (int i = 0; i < width * height; ++i) {
    const auto number = [i](std::uint32_t channel) { return static_cast<float>(moire::random({.x = i}, 0, channel)); };
    pixels.push_back({number(0), number(1), number(2)});
  }
  return pixels;
}

std::size_t files_in(const TemporaryFolder& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()));
}

// Every file may have this many bytes, and writing more fails, as on a disk that is full.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) : old_handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &old_);
    const rlimit limit{bytes, old_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;
  ~FileSizeLimit() {
    setrlimit(RLIMIT_FSIZE, &old_);
    std::signal(SIGXFSZ, old_handler_);
  }

 private:
  rlimit old_{};
  void (*old_handler_)(int);
};

}  // namespace

TEST_CASE("an 8-bit PNG gives its code values") {
  std::string samples;
  for (int i = 0; i < 256; ++i) samples += static_cast<char>(i);
  const TemporaryFolder folder;
  const Image image = moire::read_image(folder.file("grey.png", png_bytes(16, 16, 8, PngColor::grey, samples)));
  CHECK(image.width == 16);
  CHECK(image.height == 16);
  CHECK(image.channels == 1);
  CHECK(image.white == 255);
  CHECK_FALSE(image.is_linear);
  for (int i = 0; i < 256; ++i) REQUIRE(image.value(i % 16, i / 16, 0) == static_cast<float>(i));
}

TEST_CASE("a 16-bit PNG gives its code values") {
  std::string samples;
  for (int i = 0; i < 65536; ++i) {
    samples += static_cast<char>(i >> 8);
    samples += static_cast<char>(i & 0xff);
  }
  const TemporaryFolder folder;
  const Image image = moire::read_image(folder.file("grey.png", png_bytes(256, 256, 16, PngColor::grey, samples)));
  CHECK(image.white == 65535);
  CHECK_FALSE(image.is_linear);
  for (int i = 0; i < 65536; ++i) REQUIRE(image.value(i % 256, i / 256, 0) == static_cast<float>(i));
}

TEST_CASE("colours are not multiplied by alpha") {
  const TemporaryFolder folder;
  const Image image = moire::read_image(
      folder.file("alpha.png", png_bytes(1, 1, 8, PngColor::rgba, std::string_view("\xff\x80\x01\x40", 4))));
  CHECK(image.values == std::vector<float>{255, 128, 1, 64});
}

TEST_CASE("a single pixel is an image, its colour in linear light") {
  const TemporaryFolder folder;
  const Image rgb =
      moire::read_image(folder.file("rgb.png", png_bytes(1, 1, 8, PngColor::rgb, std::string_view("\xff\x80\0", 3))));
  const auto middle = static_cast<float>(moire::srgb_to_linear(128 / 255.0));
  CHECK(color_at(rgb, 0, 0) == Color{1, middle, 0});
  const Image grey = moire::read_image(folder.file("grey.png", png_bytes(1, 1, 8, PngColor::grey, "\x80")));
  CHECK(color_at(grey, 0, 0) == Color{middle, middle, middle});
}

TEST_CASE("a float EXR keeps every bit") {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  std::vector<Color> pixels = noise(31, 17);
  pixels[0] = {nan, infinity, -infinity};
  pixels[1] = {-1.5F, 3.0e38F, std::numeric_limits<float>::denorm_min()};
  const TemporaryFolder folder;
  moire::write_image(folder.path() / "a.exr", 31, 17, pixels);
  const Image image = moire::read_image(folder.path() / "a.exr");
  CHECK(image.white == 1);
  CHECK(image.is_linear);
  REQUIRE(image.values.size() == 3 * pixels.size());
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    REQUIRE(std::bit_cast<std::uint32_t>(image.values[3 * i]) == std::bit_cast<std::uint32_t>(pixels[i].r));
    REQUIRE(std::bit_cast<std::uint32_t>(image.values[3 * i + 1]) == std::bit_cast<std::uint32_t>(pixels[i].g));
    REQUIRE(std::bit_cast<std::uint32_t>(image.values[3 * i + 2]) == std::bit_cast<std::uint32_t>(pixels[i].b));
  }
  CHECK(color_at(image, 1, 0).g == 3.0e38F);
}

TEST_CASE("a half EXR keeps eleven bits") {
  const std::vector<Color> pixels = noise(16, 16);
  const TemporaryFolder folder;
  moire::write_image(folder.path() / "half.exr", 16, 16, pixels, Depth::half);
  moire::write_image(folder.path() / "full.exr", 16, 16, pixels, Depth::full);
  const Image image = moire::read_image(folder.path() / "half.exr");
  for (int i = 0; i < 256; ++i) {
    const float exact = pixels[static_cast<std::size_t>(i)].g;
    REQUIRE(std::abs(image.value(i % 16, i / 16, 1) - exact) <= std::max(exact, 0x1p-14F) * 0x1p-11F);
  }
  CHECK(fs::file_size(folder.path() / "half.exr") < fs::file_size(folder.path() / "full.exr"));
}

TEST_CASE("a PNG holds sRGB code values, ends cut off, and shows what is not a number in magenta") {
  std::vector<Color> pixels;
  for (int code = 0; code < 256; ++code) {
    const auto light = static_cast<float>(moire::srgb_to_linear(code / 255.0));
    pixels.push_back({light, light, light});
  }
  pixels.push_back({-1, 2, std::numeric_limits<float>::infinity()});
  pixels.push_back({0, std::numeric_limits<float>::quiet_NaN(), 0});
  const TemporaryFolder folder;
  moire::write_image(folder.path() / "a.png", 129, 2, pixels);
  const Image image = moire::read_image(folder.path() / "a.png");
  CHECK(image.white == 255);
  for (std::size_t code = 0; code < 256; ++code) REQUIRE(image.values[3 * code + 1] == static_cast<float>(code));
  CHECK(std::vector(image.values.end() - 6, image.values.end()) == std::vector<float>{0, 255, 255, 255, 0, 255});
}

TEST_CASE("images that are not there are errors") {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "none.png";
  CHECK(message_of([&] { moire::read_image(file); }) == file.string() + ": does not exist; an image file is needed");
  CHECK(message_of([&] { moire::read_image(folder.path()); }) ==
        folder.path().string() + ": is no file; an image file is needed");
}

// The reasons in parentheses are OpenImageIO's and change with its version.
TEST_CASE("files that are no images are errors") {
  const TemporaryFolder folder;
  for (const std::string bytes : {"", "some text\n", "\x89PNG\r\n\x1a\n"}) {
    const fs::path file = folder.file("a.png", bytes);
    const std::string message = message_of_reading(file);
    CHECK(message.starts_with(file.string() + ": cannot be read as an image ("));
    CHECK(message.ends_with("); any format that OpenImageIO knows will do"));
    CHECK(message.find('\n') == message.npos);
  }
}

TEST_CASE("images that are cut short are errors, not images with rows made up") {
  const TemporaryFolder folder;
  moire::write_image(folder.path() / "whole.png", 64, 64, noise(64, 64));
  moire::write_image(folder.path() / "whole.exr", 64, 64, noise(64, 64));
  for (const std::string extension : {".png", ".exr"}) {
    const std::string whole = bytes_of(folder.path() / ("whole" + extension));
    for (const std::size_t length : {whole.size() / 2, whole.size() - 100}) {
      const fs::path file = folder.file("cut" + extension, whole.substr(0, length));
      const std::string message = message_of_reading(file);
      CHECK(message.starts_with(file.string() + ": is damaged or cut short ("));
      CHECK(message.ends_with("); get the file again"));
      CHECK(message.find('\n') == message.npos);
    }
  }
}

TEST_CASE("an image too large is refused from its header") {
  const TemporaryFolder folder;
  const fs::path file = folder.file("huge.png", png_bytes(100000, 100000, 8, PngColor::rgb, ""));
  CHECK(message_of([&] { moire::read_image(file); }) ==
        file.string() + ": is too large (100000 x 100000 pixels, channels: 3); at most 268435456 values can be read");
}

TEST_CASE("an image without pixels is an error") {
  const TemporaryFolder folder;
  const fs::path file = folder.file("empty.png", png_bytes(0, 7, 8, PngColor::rgb, ""));
  const std::string message = message_of([&] { moire::read_image(file); });
  CHECK(message.starts_with(file.string() + ": "));
}

TEST_CASE("values of 32-bit integers are refused") {
  const TemporaryFolder folder;
  // A TIFF of one pixel, little-endian, with seven entries of (tag, type, count, value).
  std::string bytes("II*\0\x08\0\0\0\x07\0", 10);
  const auto entry = [&](int tag, int type, std::uint32_t value) {
    for (const int byte : {tag & 0xff, tag >> 8, type, 0, 1, 0, 0, 0}) bytes += static_cast<char>(byte);
    for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(value >> shift & 0xff);
  };
  entry(256, 4, 1), entry(257, 4, 1), entry(258, 3, 32), entry(259, 3, 1), entry(262, 3, 1), entry(273, 4, 98);
  entry(279, 4, 4);
  bytes.append(8, '\0');
  const fs::path file = folder.file("wide.tif", bytes);
  CHECK(message_of([&] { moire::read_image(file); }) ==
        file.string() + ": has values of type uint; 8-bit, 16-bit and floating-point images can be read");
}

TEST_CASE("images are written to .exr and .png only") {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "a.jpg";
  CHECK(message_of([&] { moire::write_image(file, 1, 1, {{}}); }) ==
        file.string() + ": is no kind of image that is written here (\".jpg\"); use .exr or .png");
  CHECK(files_in(folder) == 0);
}

TEST_CASE("an image that cannot be written is an error that names its file") {
  const TemporaryFolder folder;
  const std::string rest = "; the folder must exist, be writable and have room";
  const fs::path below_a_file = folder.file("file", "") / "a.png";  // refused to the superuser too
  CHECK(message_of([&] { moire::write_image(below_a_file, 1, 1, {{}}); }) ==
        below_a_file.string() + ": cannot be written (Not a directory)" + rest);
  const fs::path nowhere = folder.path() / "none" / "a.exr";
  CHECK(message_of([&] { moire::write_image(nowhere, 1, 1, {{}}); }) ==
        nowhere.string() + ": cannot be written (No such file or directory)" + rest);
  const fs::path taken = folder.path() / "taken.png";
  fs::create_directory(taken);
  CHECK(message_of([&] { moire::write_image(taken, 1, 1, {{}}); }) ==
        taken.string() + ": cannot be written (Is a directory)" + rest);
  CHECK(files_in(folder) == 2);
}

TEST_CASE("a disk that fills up leaves the old image and nothing else") {
  const TemporaryFolder folder;
  for (const char* name : {"a.png", "a.exr"}) {
    const fs::path file = folder.file(name, "the old image");
    const std::string message = message_of([&] {
      const FileSizeLimit limit(4096);
      moire::write_image(file, 128, 128, noise(128, 128));
    });
    CHECK(message ==
          file.string() + ": cannot be written (File too large); the folder must exist, be writable and have room");
    const bool is_unchanged = bytes_of(file) == "the old image";  // else bytes that no terminal should see
    CHECK(is_unchanged);
  }
  CHECK(files_in(folder) == 2);
}

TEST_CASE("the same pixels give the same file") {
  const TemporaryFolder folder;
  for (const std::string extension : {".png", ".exr"}) {
    moire::write_image(folder.path() / ("a" + extension), 40, 40, noise(40, 40));
    moire::write_image(folder.path() / ("b" + extension), 40, 40, noise(40, 40));
    const bool is_same = bytes_of(folder.path() / ("a" + extension)) == bytes_of(folder.path() / ("b" + extension));
    CHECK(is_same);
  }
}

TEST_CASE("images are read and written by many threads at once") {
  const TemporaryFolder folder;
  const auto file = [&](int t) { return folder.path() / (std::to_string(t) + ".exr"); };
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t) threads.emplace_back([&, t] { moire::write_image(file(t), 8, 8, noise(8, 8)); });
  for (std::thread& thread : threads) thread.join();
  for (int t = 0; t < 4; ++t) CHECK(moire::read_image(file(t)).value(3, 5, 1) == noise(8, 8)[43].g);
}

TEST_CASE("OpenImageIO is loaded by the first image and not before") {
  const TemporaryFolder folder;
  const fs::path file = folder.file("a.png", png_bytes(1, 1, 8, PngColor::grey, "\x80"));
  CHECK(output_of("'" IMAGE_PROBES "/image_probe' " + file.string()) == "before: 0\nwidth: 1\nafter: 1\nexit 0");
}

TEST_CASE("without its module the SDK says what is missing") {
  const std::string module = IMAGE_PROBES "/moire/moire_images.so";
  CHECK(output_of("'" IMAGE_PROBES "/image_probe_alone' a.png") ==
        "before: 0\n" + module + ": cannot be opened (" + module +
            ": cannot open shared object file: No such file or directory); images and the lookup \"oiio\" need this "
            "part of moire "
            "and the OpenImageIO library (Debian: libopenimageio-dev)\nafter: 0\nexit 0");
}
