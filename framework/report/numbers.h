// Numbers as text: for files, which must give back the same number, and for people.
#pragma once

#include <span>
#include <string>

namespace moire::report {

// The shortest text that reads back as the same number; "nan", "inf" and "-inf" for what is not finite.
std::string exact_text(double value);

// How many decimals a column of numbers needs so that its smallest (but 0) has three digits that count; 0 to 4.
int decimals_for(std::span<const double> column);

// With that many decimals; numbers that would read as 0 and numbers of more than 9 digits are written as 3.1e-06.
std::string readable_text(double value, int decimals);

// Three digits that count, for a number that stands alone.
std::string readable_text(double value);

}  // namespace moire::report
