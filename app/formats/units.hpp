// Units of files, and conversion to internal units: metre, newton, radian, second, kelvin.
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

/// Weight of a kilogram at standard gravity [N]. Kilograms in files, also the masses of arms, become weights by it.
inline constexpr double kWeightOfKilogram = 9.80665;

/// Unit with its conversion: internal = (value + offset) * factor.
struct Unit {
  UnitKind kind;
  std::string_view name;
  double factor;
  double offset = 0;
};

/// Returns all units: an open table, with one row for each unit.
[[nodiscard]] std::span<const Unit> unitTable();

/// Returns the unit of that kind and name; null if there is none.
[[nodiscard]] const Unit* findUnit(UnitKind kind, std::string_view name);

/// Returns the names of a kind of units: in, mm, cm, m, ft.
[[nodiscard]] std::vector<std::string> unitNames(UnitKind kind);

/// Dimension of a quantity by its exponents; a temperature is a temperature difference. Joint speeds and accelerations
/// have no exponent for time: in the arm file they are per second for any unit of time (6 is 6 deg/s in a file in
/// minutes). The rates of effects follow the unit of time.
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

/// Returns the dimension of a quantity. A prismatic joint's offset has the quantity angle but is a length, which the
/// caller must consider.
[[nodiscard]] Dimension dimensionOf(deflection::Quantity quantity);

/// Units block of a file.
class Units {
 public:
  /// Creates internal units: m, rad, N, K, s.
  Units();

  /// Reads `units: {length, angle, force, temperature, time}`; temperature and time are optional (degC, s). Throws
  /// InputError for an unknown key or unit.
  explicit Units(const YamlNode& node);

  [[nodiscard]] double toInternal(double value, Dimension dimension) const;

  /// Returns a value in file units, rounded to 12 significant digits, so that a number read and written again has the
  /// same decimals.
  [[nodiscard]] double toFile(double value, Dimension dimension) const;

  /// Convert values that may be absolute temperatures, or have a unit of their own.
  [[nodiscard]] double toInternal(double value, const deflection::ValueUnit& unit) const;
  [[nodiscard]] double toFile(double value, const deflection::ValueUnit& unit) const;

  /// Returns the internal units per unit of the file, for numbers that are scaled but not rounded (covariances,
  /// Jacobians).
  [[nodiscard]] double factor(Dimension dimension) const;

  /// Returns the name of a dimension's unit: "lbf*in/deg", "in^4", "1" for a plain number.
  [[nodiscard]] std::string nameOf(Dimension dimension) const;

  /// Returns the name of a value's unit: "degF", "percent", "" for a plain number.
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

/// Returns a value rounded to 12 significant digits.
[[nodiscard]] double rounded(double value);

/// Returns the shortest decimal of a number after rounding to 12 significant digits.
[[nodiscard]] std::string formatNumber(double value);

/// Returns a length [m] in file units.
[[nodiscard]] inline double lengthOf(double metres, const Units& units) {
  return units.toFile(metres, dimension::kLength);
}

[[nodiscard]] inline double angleOf(double radians, const Units& units) {
  return units.toFile(radians, dimension::kAngle);
}

}  // namespace tubeplan::app
