#include "tubesheets/length_unit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>
#include <cmath>

namespace tubeplan::tubesheets {
namespace {

constexpr std::array kUnits{kInch, kMillimetre, kMetre};

struct LengthWord {
  std::string_view word;
  LengthUnit unit;
};

/// Alternative names of units, in addition to the suffixes.
constexpr LengthWord kLengthWords[] = {
    {"inch", kInch},
    {"inches", kInch},
    {"millimeter", kMillimetre},
    {"millimeters", kMillimetre},
    {"millimetre", kMillimetre},
    {"millimetres", kMillimetre},
    {"meter", kMetre},
    {"meters", kMetre},
    {"metre", kMetre},
    {"metres", kMetre},
};
constexpr int kGridExponent = 44;
constexpr double kLargestSnapped = 256;  // length above which the spacing of doubles is coarser than the grid [m]

double readBack(std::string_view text) {
  double value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

}  // namespace

std::span<const LengthUnit> lengthUnits() { return kUnits; }

const LengthUnit* findLengthUnit(std::string_view suffix) {
  const auto unit = std::find_if(kUnits.begin(), kUnits.end(), [&](const LengthUnit& u) { return u.suffix == suffix; });
  return unit == kUnits.end() ? nullptr : &*unit;
}

const LengthUnit* findLengthWord(std::string_view word) {
  std::string small(word);
  std::ranges::transform(small, small.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; });
  if (const LengthUnit* unit = findLengthUnit(small)) return unit;
  const auto known = std::ranges::find(kLengthWords, small, &LengthWord::word);
  return known == std::end(kLengthWords) ? nullptr : &known->unit;
}

double snapLength(double metres) {
  if (!(std::abs(metres) < kLargestSnapped)) return metres;
  // adding 0.0 turns -0.0 into 0.0
  return std::ldexp(std::round(std::ldexp(metres, kGridExponent)), -kGridExponent) + 0.0;
}

std::string formatLength(double metres, const LengthUnit& unit) {
  assert(std::isfinite(metres));
  const double value = metres / unit.metres;
  for (int digits = 4; digits < 17; ++digits) {
    std::string text = fmt::format("{:.{}g}", value, digits);
    if (snapLength(readBack(text) * unit.metres) == metres) return text;
  }
  return fmt::format("{:.17g}", value);
}

}  // namespace tubeplan::tubesheets
