// The quantity of a number, from which readers and printers find its unit.
#pragma once

namespace tubeplan::deflection {

enum class Quantity {
  kNone,  ///< a plain number
  kLength,
  kAngle,
  kForce,
  kForcePerLength,
  kTorquePerAngle,
  kPressure,
  kLengthToTheFourth,
  kTorque,
  kAnglePerTorque,
  kPerBendingStiffness,  ///< 1/(N m^2)
  kPerTemperature,       ///< 1/K
  kSpeed,                ///< m/s
  kTime,
  kTemperature,  ///< absolute
};

/// Unit of a value: a quantity, for which every file chooses a unit, or a fixed unit of its own.
struct ValueUnit {
  Quantity quantity = Quantity::kNone;
  const char* own = "";  ///< unit of plain numbers: "percent"
};

/// Returns true for E, G, I, J and joint stiffnesses, of which a part's compliance is the inverse.
[[nodiscard]] constexpr bool isStiffness(Quantity quantity) {
  return quantity == Quantity::kTorquePerAngle || quantity == Quantity::kPressure ||
         quantity == Quantity::kLengthToTheFourth;
}

}  // namespace tubeplan::deflection
