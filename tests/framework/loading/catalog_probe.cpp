// Opens the plugins of a folder and ends as the program does: for plugins that should not be opened by the tests.
#include <iostream>
#include <vector>

#include <moire/error.h>

#include "loading/catalog.h"

int main(int, char** arguments) {
  try {
    moire::Catalog::open(std::vector<std::filesystem::path>{arguments[1]});
  } catch (const moire::Error& error) {
    std::cout << error.what() << '\n';
    return 2;
  }
}
