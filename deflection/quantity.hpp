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
  kTemperature,  ///< absolute
};

/// What values are measured in: a quantity, which every file has a unit of, or a unit of their own that none chooses.
struct ValueUnit {
  Quantity quantity = Quantity::kNone;
  const char* own = "";  ///< of plain numbers: "percent"
};

/// E, G, I, J and joint stiffnesses: what a part's compliance is the inverse of.
[[nodiscard]] constexpr bool isStiffness(Quantity quantity) {
  return quantity == Quantity::kTorquePerAngle || quantity == Quantity::kPressure ||
         quantity == Quantity::kLengthToTheFourth;
}

}  // namespace tubeplan::deflection
