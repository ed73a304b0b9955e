// Units of measurement in files, and conversion to the internal units: metre, newton, radian, second, kelvin.
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

/// Weight of one kilogram at standard gravity [N], which converts kilograms in files, including masses of arms, to
/// weights.
inline constexpr double kWeightOfKilogram = 9.80665;

/// Unit of measurement with its conversion: internal value = (value + offset) * factor.
struct Unit {
  UnitKind kind;
  std::string_view name;
  double factor;
  double offset = 0;
};

/// Returns all units that files may state.
[[nodiscard]] std::span<const Unit> unitTable();

/// Returns the unit of the given kind and name; null if there is none.
[[nodiscard]] const Unit* findUnit(UnitKind kind, std::string_view name);

/// Returns the names of all units of a kind: for lengths "in", "mm", "cm", "m", "ft".
[[nodiscard]] std::vector<std::string> unitNames(UnitKind kind);

/// Dimension of a quantity: the exponents of its base dimensions. A temperature here means a temperature difference.
/// Joint speeds and accelerations have the time exponent 0, because arm files always state them per second (6 means 6
/// deg/s even in a file whose unit of time is the minute). Rates of effects follow the file's unit of time.
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

/// Returns the dimension of a quantity. The offset of a prismatic joint has the quantity angle but is a length; the
/// caller must handle this case.
[[nodiscard]] Dimension dimensionOf(deflection::Quantity quantity);

/// Units of a file, from its `units` block.
class Units {
 public:
  /// Creates the internal units: m, rad, N, K, s.
  Units();

  /// Reads `units: {length, angle, force, temperature, time}`; temperature and time are optional (default: degC, s).
  /// Throws InputError for an unknown key or unit.
  explicit Units(const YamlNode& node);

  [[nodiscard]] double toInternal(double value, Dimension dimension) const;

  /// Returns a value in file units, rounded to 12 significant digits, so that a number that is read and written again
  /// keeps its decimals.
  [[nodiscard]] double toFile(double value, Dimension dimension) const;

  /// Convert values that may be absolute temperatures, or that may have a unit outside the `units` block, such as
  /// percent.
  [[nodiscard]] double toInternal(double value, const deflection::ValueUnit& unit) const;
  [[nodiscard]] double toFile(double value, const deflection::ValueUnit& unit) const;

  /// Returns the number of internal units per file unit, for values that are scaled without rounding (covariances,
  /// Jacobians).
  [[nodiscard]] double factor(Dimension dimension) const;

  /// Returns the name of the file's unit for a dimension: "lbf*in/deg", "in^4"; "1" for a dimensionless number.
  [[nodiscard]] std::string nameOf(Dimension dimension) const;

  /// Returns the name of the file's unit for a value: "degF", "percent"; "" for a dimensionless number.
  [[nodiscard]] std::string nameOf(const deflection::ValueUnit& unit) const;

  [[nodiscard]] const Unit& length() const { return *length_; }
  [[nodiscard]] const Unit& angle() const { return *angle_; }
  [[nodiscard]] const Unit& force() const { return *force_; }
  [[nodiscard]] const Unit& temperature() const { return *temperature_; }
  [[nodiscard]] const Unit& time() const { return *time_; }

 private:
  [[nodiscard]] double zeroOf(deflection::Quantity quantity) const;

  const Unit *length_, *angle_, *force_, *temperature_, *time_;  // pointers into unitTable()
};

/// Returns a value rounded to 12 significant digits.
[[nodiscard]] double rounded(double value);

/// Returns a number, rounded to 12 significant digits, in the shortest decimal notation.
[[nodiscard]] std::string formatNumber(double value);

/// Converts a length from metres to file units.
[[nodiscard]] inline double lengthOf(double metres, const Units& units) {
  return units.toFile(metres, dimension::kLength);
}

[[nodiscard]] inline double angleOf(double radians, const Units& units) {
  return units.toFile(radians, dimension::kAngle);
}

}  // namespace tubeplan::app
