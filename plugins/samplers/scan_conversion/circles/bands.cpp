#include "bands.h"

namespace scan_conversion {

RootTable::RootTable(std::int64_t radius, int bits) : radius_(radius), bits_(bits) {
  const std::int64_t rows = PixelCircle{{}, radius}.last_row() + 2;
  values_.reserve(static_cast<std::size_t>(rows));
  RootBand band(radius, bits);
  band.go_to(0);
  for (std::int64_t j = 0; j < rows; ++j, band.next()) values_.push_back(band.inner());
}

}  // namespace scan_conversion
