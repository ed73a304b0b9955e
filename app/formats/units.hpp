// The units a file is written in, and the way between them and the internal ones: metre, newton, radian, second,
// kelvin.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "deflection/parameters.hpp"
#include "deflection/quantity.hpp"

namespace tubeplan::app {

struct YamlNode;

enum class UnitKind { kLength, kAngle, kForce, kTorque, kTemperature, kTime };

/// N: at standard gravity. Files of kilograms, and of arms as masses, are weights here.
inline constexpr double kWeightOfKilogram = 9.80665;

/// internal = (value + offset) * factor
struct Unit {
  UnitKind kind;
  std::string_view name;
  double factor;
  double offset = 0;
};

/// All of them, the open table: a new unit is one row.
[[nodiscard]] std::span<const Unit> unitTable();

/// Null where there is no such unit of that kind.
[[nodiscard]] const Unit* findUnit(UnitKind kind, std::string_view name);

/// The names of a kind: in, mm, cm, m, ft.
[[nodiscard]] std::vector<std::string> unitNames(UnitKind kind);

/// A quantity by its exponents; a temperature is a difference of two. Joint speeds and accelerations have none for
/// time: in the arm file they are per second whatever the unit of time is (6 is 6 deg/s in a file whose time unit is
/// the minute). The rates of effects follow the unit of time.
struct Dimension {
  int length = 0, angle = 0, force = 0, temperature = 0, time = 0;
};

namespace dimension {
inline constexpr Dimension kNone{};
inline constexpr Dimension kLength{1, 0, 0};
inline constexpr Dimension kAngle{0, 1, 0};
inline constexpr Dimension kForce{0, 0, 1};
inline constexpr Dimension kForcePerLength{-1, 0, 1};
inline constexpr Dimension kTorquePerAngle{1, -1, 1};
inline constexpr Dimension kPressure{-2, 0, 1};
inline constexpr Dimension kLengthToTheFourth{4, 0, 0};
inline constexpr Dimension kTorque{1, 0, 1};
inline constexpr Dimension kAnglePerTorque{-1, 1, -1};
inline constexpr Dimension kPerBendingStiffness{-2, 0, -1};
inline constexpr Dimension kTemperature{0, 0, 0, 1};
inline constexpr Dimension kPerTemperature{0, 0, 0, -1};
inline constexpr Dimension kSpeed{1, 0, 0, 0, -1};
inline constexpr Dimension kTime{0, 0, 0, 0, 1};
}  // namespace dimension

/// The offset of a prismatic joint is a length although its quantity says angle: that is for the caller to see.
[[nodiscard]] Dimension dimensionOf(deflection::Quantity quantity);

/// The units block of a file.
class Units {
 public:
  /// Internal units: m, rad, N, K, s.
  Units();

  /// `units: {length, angle, force, temperature, time}`; temperature and time may be left out (degC, s). Throws
  /// InputError for an unknown key or unit.
  explicit Units(const YamlNode& node);

  [[nodiscard]] double toInternal(double value, Dimension dimension) const;

  /// Rounded to 12 significant digits, so that a number read and written again is the same decimal.
  [[nodiscard]] double toFile(double value, Dimension dimension) const;

  /// Convert values that may be absolute temperatures, or have a unit of their own.
  [[nodiscard]] double toInternal(double value, const deflection::ValueUnit& unit) const;
  [[nodiscard]] double toFile(double value, const deflection::ValueUnit& unit) const;

  /// Internal units per unit of the file, for numbers that are scaled but not rounded (covariances, Jacobians).
  [[nodiscard]] double factor(Dimension dimension) const;

  /// "lbf*in/deg", "in^4", "1" for a plain number.
  [[nodiscard]] std::string nameOf(Dimension dimension) const;

  /// "degF", "percent", "" for a plain number.
  [[nodiscard]] std::string nameOf(const deflection::ValueUnit& unit) const;

  [[nodiscard]] const Unit& length() const { return *length_; }
  [[nodiscard]] const Unit& angle() const { return *angle_; }
  [[nodiscard]] const Unit& force() const { return *force_; }
  [[nodiscard]] const Unit& temperature() const { return *temperature_; }
  [[nodiscard]] const Unit& time() const { return *time_; }

 private:
  [[nodiscard]] double zeroOf(deflection::Quantity quantity) const;

  const Unit *length_, *angle_, *force_, *temperature_, *time_;  // rows of unitTable()
};

/// To 12 significant digits.
[[nodiscard]] double rounded(double value);

/// The shortest decimal that is that number, after rounding to 12 significant digits.
[[nodiscard]] std::string formatNumber(double value);

/// One number, in file units.
[[nodiscard]] inline double lengthOf(double metres, const Units& units) {
  return units.toFile(metres, dimension::kLength);
}

[[nodiscard]] inline double angleOf(double radians, const Units& units) {
  return units.toFile(radians, dimension::kAngle);
}

}  // namespace tubeplan::app
