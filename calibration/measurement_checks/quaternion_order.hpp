// Mistake: the rotations were converted from quaternions whose four numbers were taken in another order: the real part
// w last instead of first, or first instead of last.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>

#include "calibration/measurement_checks/mistake.hpp"
#include "deflection/rotation.hpp"

namespace tubeplan::calibration::mistakes::quaternion_order {

/// Order in which the four numbers were written, with the order in which they were read. `x`, `y`, `z` and `w` are the
/// places (0: x, 1: y, 2: z, 3: w) that the true components have among the components as read.
struct Order {
  const char *name, *written, *read;
  int x, y, z, w;
};

inline constexpr std::array kOrders{Order{"xyzw", "x, y, z, w", "w, x, y, z", 3, 0, 1, 2},
                                    Order{"wxyz", "w, x, y, z", "x, y, z, w", 1, 2, 3, 0}};

inline std::vector<std::string> values(const CheckedMeasurements& checked) {
  std::vector<std::string> texts;
  if (std::ranges::none_of(checked.measurements, statesFrame)) return texts;
  for (const Order& order : kOrders) texts.emplace_back(order.name);
  return texts;
}

inline std::optional<Correction> correction(const CheckedMeasurements&, const std::string& value) {
  const auto order = std::ranges::find(kOrders, value, &Order::name);
  if (order == kOrders.end()) return std::nullopt;
  Correction correction{
      "quaternion", value,
      std::string("the turns were quaternions with the numbers ") + order->written + ", taken as " + order->read};
  correction.change = toEach([order](Measurement& measurement) {
    if (!statesFrame(measurement)) return;
    const Eigen::Vector4d read =
        Eigen::Quaterniond(deflection::rotationFromFixedAngles<double>(measurement.kind_values)).coeffs();
    const Eigen::Quaterniond right(read[order->w], read[order->x], read[order->y], read[order->z]);
    measurement.kind_values = deflection::fixedAnglesOf(right.toRotationMatrix());
  });
  return correction;
}

inline MistakeKind kind() {
  return {.name = "quaternion",
          .value = "ORDER",
          .expected = "the order in which the numbers of the quaternions were written, xyzw or wxyz",
          .values = values,
          .correction = correction,
          .values_with_others = noValues,
          .is_of_turns = true};
}

}  // namespace tubeplan::calibration::mistakes::quaternion_order
