// Mistake: the two motors of a differential were logged instead of the two joints that they drive. Each column then
// contains a mixture of both joints, such as their sum and difference.
#pragma once

#include <fmt/format.h>

#include <Eigen/LU>
#include <array>
#include <cmath>

#include "calibration/measurement_checks/mistake.hpp"

namespace tubeplan::calibration::mistakes::joint_pair {

/// Two joints whose correct readings are the matrix `shares` times the values in their columns.
struct Pair {
  int first = -1, second = -1;
  Eigen::Matrix2d shares = Eigen::Matrix2d::Zero();
};

/// Parses "JOINT:JOINT:A:B:C:D", where A to D are the coefficients row by row; nullopt if the string has another form
/// or the matrix is singular.
inline std::optional<Pair> pairOf(const deflection::Arm& arm, const std::string& value) {
  std::size_t names = value.size();
  for (int k = 0; k < 4 && names > 0 && names != std::string::npos; ++k) names = value.rfind(':', names - 1);
  if (names == 0 || names == std::string::npos) return std::nullopt;
  const auto shares = numbersAtColons(value.substr(names + 1), 4);
  const auto [first, second] = partedAtColon(value.substr(0, names));
  if (!shares) return std::nullopt;
  Pair pair{jointNamed(arm, first), jointNamed(arm, second), {}};
  pair.shares << (*shares)[0], (*shares)[1], (*shares)[2], (*shares)[3];
  const bool is_pair = pair.first >= 0 && pair.second >= 0 && pair.first != pair.second &&
                       arm.joint(pair.first).type == arm.joint(pair.second).type;
  return is_pair && std::abs(pair.shares.determinant()) > 1e-9 ? std::optional(pair) : std::nullopt;
}

/// Returns values for all pairs of neighbouring revolute joints. One joint of a pair turns by the sum of the motor
/// angles, the other by their difference. Either joint may be the sum, and either motor may come first in the
/// difference. `sizes` are the tried magnitudes of the coefficients: 0.5 if the motors turn by the sum and the
/// difference of the joint angles, 1 if they turn by half of these.
inline std::vector<std::string> valuesOf(const CheckedMeasurements& checked, const std::vector<double>& sizes) {
  static constexpr std::array<std::array<int, 4>, 4> kSigns{
      {{1, 1, 1, -1}, {1, 1, -1, 1}, {1, -1, 1, 1}, {-1, 1, 1, 1}}};
  const auto& arm = checked.start.arm;
  const auto turns = [&](int j) { return arm.joint(j).type == deflection::JointType::kRevolute; };
  std::vector<std::string> texts;
  for (int j = 0; j + 1 < arm.jointCount(); ++j)
    for (const double size : sizes)
      for (const auto& s : kSigns)
        if (turns(j) && turns(j + 1))
          texts.push_back(fmt::format("{}:{}:{:g}:{:g}:{:g}:{:g}", arm.joint(j).name, arm.joint(j + 1).name,
                                      s[0] * size, s[1] * size, s[2] * size, s[3] * size));
  return texts;
}
inline std::vector<std::string> values(const CheckedMeasurements& checked) { return valuesOf(checked, {0.5, 1}); }
inline std::vector<std::string> valuesWithOthers(const CheckedMeasurements& checked) {
  return valuesOf(checked, {0.5});
}

/// Returns a linear combination of two joint angles as text, such as "0.5 J5 - 0.5 J6" or "J5 - J6".
inline std::string mixtureText(const Eigen::RowVector2d& shares, const std::string& first, const std::string& second) {
  const auto term = [](double size, const std::string& name) {
    return size == 1 ? name : fmt::format("{:g} {}", size, name);
  };
  return (shares[0] == -1 ? "-" + first : term(shares[0], first)) + (shares[1] < 0 ? " - " : " + ") +
         term(std::abs(shares[1]), second);
}

/// Returns the sign of the last motion of a linear combination of two joints with the coefficients `shares`. The signs
/// of the joints' own last motions are `first` and `second`. Returns 0 if their contributions disagree.
inline int senseOf(const Eigen::RowVector2d& shares, int first, int second) {
  const auto sign = [](double number) { return (number > 0) - (number < 0); };
  const int a = sign(shares[0]) * first, b = sign(shares[1]) * second;
  return a == b || shares[1] == 0 ? a : shares[0] == 0 ? b : 0;
}

inline void unmix(const Pair& pair, Measurement& measurement) {
  const Eigen::Vector2d q = pair.shares * Eigen::Vector2d(measurement.q[pair.first], measurement.q[pair.second]);
  measurement.q[pair.first] = q[0];
  measurement.q[pair.second] = q[1];
  if (measurement.approach_directions.empty()) return;
  int& first = measurement.approach_directions[static_cast<std::size_t>(pair.first)];
  int& second = measurement.approach_directions[static_cast<std::size_t>(pair.second)];
  const int sense = senseOf(pair.shares.row(0), first, second);
  second = senseOf(pair.shares.row(1), first, second);
  first = sense;
}

inline std::optional<Correction> correction(const CheckedMeasurements& checked, const std::string& value) {
  const auto& arm = checked.start.arm;
  const auto pair = pairOf(arm, value);
  if (!pair) return std::nullopt;
  const std::string &first = arm.joint(pair->first).name, &second = arm.joint(pair->second).name;
  Correction correction{
      "joint-pair", value,
      fmt::format("the columns of {0} and {1} contain the motors of a differential: {0} is {2} of them, {1} is {3}",
                  first, second, mixtureText(pair->shares.row(0), first, second),
                  mixtureText(pair->shares.row(1), first, second))};
  correction.change = toEach([pair = *pair](Measurement& measurement) { unmix(pair, measurement); });
  return correction;
}

inline MistakeKind kind() {
  return {.name = "joint-pair",
          .value = "JOINT:JOINT:SHARES",
          .expected =
              "two joints and the shares of both columns in the first and in the second, such as "
              "theta3:theta4:0.5:0.5:0.5:-0.5",
          .values = values,
          .correction = correction,
          .values_with_others = valuesWithOthers};
}

}  // namespace tubeplan::calibration::mistakes::joint_pair
