// PNG files made by hand, so that images are tested against something other than what writes them. After
// "Portable Network Graphics (PNG) Specification", https://www.w3.org/TR/png-3/, and RFC 1950 and 1951.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace moire::test {

inline std::string big_endian(std::uint32_t value) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift & 0xff);
  return bytes;
}

inline std::uint32_t crc32(std::string_view bytes) {
  std::uint32_t crc = 0xffffffffU;
  for (const char c : bytes) {
    crc ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ (crc & 1 ? 0xedb88320U : 0);
  }
  return ~crc;
}

inline std::uint32_t adler32(std::string_view bytes) {
  std::uint32_t a = 1, b = 0;
  for (const char c : bytes) {
    a = (a + static_cast<unsigned char>(c)) % 65521;
    b = (b + a) % 65521;
  }
  return b << 16 | a;
}

inline std::string chunk(std::string_view type, std::string_view data) {
  const std::string body = std::string(type) + std::string(data);
  return big_endian(static_cast<std::uint32_t>(data.size())) + body + big_endian(crc32(body));
}

// A zlib stream that compresses nothing: stored blocks of at most 65535 bytes.
inline std::string stored(std::string_view bytes) {
  std::string stream = "\x78\x01";
  for (std::size_t start = 0; start < bytes.size(); start += 65535) {
    const std::string_view block = bytes.substr(start, 65535);
    const auto length = static_cast<std::uint32_t>(block.size());
    stream += start + block.size() == bytes.size() ? '\1' : '\0';
    for (const std::uint32_t number : {length, ~length}) {
      stream += static_cast<char>(number & 0xff);
      stream += static_cast<char>(number >> 8 & 0xff);
    }
    stream += block;
  }
  return stream + big_endian(adler32(bytes));
}

enum class PngColor { grey = 0, rgb = 2, rgba = 6 };

// `samples` are all rows as the file stores them, 16-bit samples big-endian.
inline std::string png_bytes(std::uint32_t width, std::uint32_t height, int bits, PngColor color,
                             std::string_view samples) {
  std::string header = big_endian(width) + big_endian(height);
  for (const int field : {bits, static_cast<int>(color), 0, 0, 0}) header += static_cast<char>(field);
  std::string rows;
  for (std::uint32_t y = 0; y < height && !samples.empty(); ++y) {
    rows += '\0';  // no filter
    rows += samples.substr(y * (samples.size() / height), samples.size() / height);
  }
  return "\x89PNG\r\n\x1a\n" + chunk("IHDR", header) + chunk("IDAT", stored(rows)) + chunk("IEND", "");
}

}  // namespace moire::test
