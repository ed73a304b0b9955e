// The physical quantity of a number, which determines its unit in files and printed output.
#pragma once

namespace tubeplan::deflection {

enum class Quantity {
  kNone,  ///< plain number without a quantity
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
  kTemperature,  ///< absolute temperature
};

/// Unit of a value: the unit of its quantity, which each file chooses, or a fixed unit.
struct ValueUnit {
  Quantity quantity = Quantity::kNone;
  const char* fixed_unit = "";  ///< fixed unit of a plain number, such as "percent"; empty if none
};

/// Returns true for E, G, I, J and joint stiffnesses, to which an element's compliance is inversely proportional.
[[nodiscard]] constexpr bool isStiffness(Quantity quantity) {
  return quantity == Quantity::kTorquePerAngle || quantity == Quantity::kPressure ||
         quantity == Quantity::kLengthToTheFourth;
}

}  // namespace tubeplan::deflection
