// Reads an image and says whether OpenImageIO is in memory before and after.
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>

#include <moire/error.h>
#include <moire/image.h>

namespace {

bool has_openimageio() {
  std::ifstream maps("/proc/self/maps");
  const std::string text{std::istreambuf_iterator<char>(maps), {}};
  return text.find("libOpenImageIO") != text.npos;
}

}  // namespace

int main(int, char** arguments) {
  std::cout << "before: " << has_openimageio() << '\n';
  try {
    const moire::Image image = moire::read_image(arguments[1]);
    std::cout << "width: " << image.width << '\n';
  } catch (const moire::Error& error) {
    std::cout << error.what() << '\n';
  }
  std::cout << "after: " << has_openimageio() << '\n';
}
