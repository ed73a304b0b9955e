// What kind of number something is: readers and printers find its unit from it.
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
};

/// E, G, I, J and joint stiffnesses: what a part's compliance is the inverse of.
[[nodiscard]] constexpr bool isStiffness(Quantity quantity) {
  return quantity == Quantity::kTorquePerAngle || quantity == Quantity::kPressure ||
         quantity == Quantity::kLengthToTheFourth;
}

}  // namespace tubeplan::deflection
