// Parser of sexagesimal angles (hours or degrees, minutes and seconds), as used by telescopes, surveyors and almanacs.
#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace tubeplan::app {

inline constexpr double kDegreesPerHour = 15;

/// Notation of a sexagesimal angle: "12:34:56.7", "12 34 56.7", "12h34m56.7s", or 12d34'56.7" with d or °.
enum class SixtiethForm { kColons, kBlanks, kHours, kDegrees };

struct Sexagesimal {
  double value = 0;  ///< angle in hours or degrees, depending on `form`
  SixtiethForm form = SixtiethForm::kColons;
};

/// Returns the finite number in a field, which may have a plus sign; std::nullopt for any other text.
[[nodiscard]] std::optional<double> signedNumber(std::string_view field);

/// Returns true for a possible number of minutes or seconds; 60 is allowed because it may be a rounded 59.99.
[[nodiscard]] constexpr bool isSixtieth(double number) { return number >= 0 && number <= 60; }

/// Returns the signed sum of unsigned sexagesimal digits: each number counts sixtieths of the previous unit.
[[nodiscard]] double sumOfSixtieths(bool is_negative, std::span<const double> parts);

/// Parses an angle of two or three numbers with at most one sign in front; the last number may have decimals, with a
/// point or a comma. Returns std::nullopt for any other text, such as a plain number.
[[nodiscard]] std::optional<Sexagesimal> parseSexagesimal(std::string_view field);

/// Returns true if the notation leaves open whether the angle is in hours or degrees.
[[nodiscard]] constexpr bool isBare(SixtiethForm form) {
  return form == SixtiethForm::kColons || form == SixtiethForm::kBlanks;
}

}  // namespace tubeplan::app
