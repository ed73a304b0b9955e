// Angles in sixtieths: hours or degrees, minutes and seconds, as telescopes, surveyors and almanacs write them.
#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace tubeplan::app {

inline constexpr double kDegreesPerHour = 15;

/// How an angle is written: "12:34:56.7", "12 34 56.7", "12h34m56.7s", or as 12d34'56.7", with d or °.
enum class SixtiethForm { kColons, kBlanks, kHours, kDegrees };

struct Sexagesimal {
  double value = 0;  ///< hours or degrees, by the form where it says so
  SixtiethForm form = SixtiethForm::kColons;
};

/// Returns the finite number of a field, which may begin with a plus; nothing for any other text.
[[nodiscard]] std::optional<double> signedNumber(std::string_view field);

/// Returns whether a number may be one of minutes or seconds: 60 is what rounding makes of 59.99.
[[nodiscard]] constexpr bool isSixtieth(double number) { return number >= 0 && number <= 60; }

/// Returns the sum of a number without sign and of its sixtieths, each a sixtieth of the one before.
[[nodiscard]] double sumOfSixtieths(bool is_negative, std::span<const double> parts);

/// Returns the angle of two or three numbers behind one sign at most, of which the last may have decimals, with a point
/// or a comma. Nothing for any other text, a plain number among them.
[[nodiscard]] std::optional<Sexagesimal> parseSexagesimal(std::string_view field);

/// Returns whether the form leaves open whether hours or degrees are meant.
[[nodiscard]] constexpr bool isBare(SixtiethForm form) {
  return form == SixtiethForm::kColons || form == SixtiethForm::kBlanks;
}

}  // namespace tubeplan::app
