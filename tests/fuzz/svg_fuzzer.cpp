// Gives the SVG reader any text: it answers with a drawing or with a moire::Error.
#include <string_view>

#include "look.h"
#include "reading/svg.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    moire::fuzz::look_at(cartoon::read_svg(text, "fuzzed", cartoon::Unmodelled::skip));
  } catch (const moire::Error&) {
  }
  return 0;
}
