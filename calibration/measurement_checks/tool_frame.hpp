// Mistake: the rotations are of another frame than the tool frame of the arm's file. Value "yzx": another convention of
// the flange, whose x, y and z are the tool's y, z and x. Value "90:0:35": a tracked body that is mounted on the tool
// with this roll, pitch and yaw.
#pragma once

#include <fmt/format.h>

#include <Eigen/SVD>

#include "calibration/measurement_checks/axes.hpp"
#include "calibration/measurement_checks/robust_fit.hpp"
#include "calibration/measurements/measurement_prediction.hpp"
#include "deflection/rotation.hpp"

namespace tubeplan::calibration::mistakes::tool_frame {

inline double angleOf(const Eigen::Matrix3d& R) { return Eigen::AngleAxisd(R).angle(); }

/// Parses the rotation R_TM of the measured frame M relative to the tool T: an order of axes such as "yzx", or roll,
/// pitch and yaw separated by colons, in the unit of the file's angles. Returns nullopt if the string has neither form.
inline std::optional<Eigen::Matrix3d> turnOf(const CheckedMeasurements& checked, const std::string& value) {
  if (const auto R_TM = axes::matrixOf(value)) return R_TM->determinant() > 0 ? R_TM : std::nullopt;
  const auto rpy = numbersAtColons(value, 3);
  if (!rpy) return std::nullopt;
  return deflection::rotationFromFixedAngles<double>(Eigen::Vector3d(rpy->data()) * checked.units.angles.factor);
}

/// Returns roll, pitch and yaw of a rotation in the unit of the file's angles.
inline Eigen::Vector3d fixedAngles(const CheckedMeasurements& checked, const Eigen::Matrix3d& R) {
  return deflection::fixedAnglesOf(R) / checked.units.angles.factor + Eigen::Vector3d::Zero();
}

/// Returns the mean rotation R_TM of the measured frame relative to the tool, with the tool's pose from a fit of the
/// positions alone. Returns nullopt if too few measurements state both a position and a rotation.
inline std::optional<Eigen::Matrix3d> meanTurn(const CheckedMeasurements& checked) {
  constexpr std::size_t kLeast = 6;
  std::vector<Measurement> places;
  for (Measurement measurement : checked.measurements)
    if (statesFrame(measurement) && measurement.p_W && !measurement.row) {
      measurement.kind = MeasurementKind::kPosition;
      places.push_back(std::move(measurement));
    }
  if (places.size() < kLeast) return std::nullopt;
  const RobustFit fit = fitRobustly(checked.start, places, {{{"tool.tip"}, true, checked.free.priors}});
  if (!fit.ok) return std::nullopt;
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (const Measurement& measurement : places)
    if (const auto tool = toolAt(fit.placed, measurement))
      sum += tool->R_WT.transpose() * deflection::rotationFromFixedAngles<double>(measurement.kind_values);
  if (!(sum.determinant() > 0)) return std::nullopt;  // widely scattered rotations have no mean
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(sum, Eigen::ComputeFullU | Eigen::ComputeFullV);
  return Eigen::Matrix3d(svd.matrixU() * svd.matrixV().transpose());
}

inline std::vector<std::string> values(const CheckedMeasurements& checked) {
  constexpr double kSmall = 0.1;  // prior sigma of a mounting (`tool.turn`) [rad]; the fit finds smaller rotations
  std::vector<std::string> texts;
  if (std::ranges::none_of(checked.measurements, statesFrame)) return texts;
  const auto mean = meanTurn(checked);
  bool is_order = !mean || angleOf(*mean) < kSmall;
  for (const std::string& text : axes::signedOrders())
    if (const auto R_TM = turnOf(checked, text); text != "xyz" && R_TM) {
      texts.push_back(text);
      is_order = is_order || angleOf(R_TM->transpose() * *mean) < kSmall;
    }
  if (is_order) return texts;
  const Eigen::Vector3d rpy = fixedAngles(checked, *mean);
  texts.push_back(fmt::format("{:.6g}:{:.6g}:{:.6g}", rpy.x(), rpy.y(), rpy.z()));
  return texts;
}

/// Returns, as text, the value of the tool's `rpy` with which the tool frame of the arm's file is the measured frame.
inline std::string rpyText(const CheckedMeasurements& checked, const Eigen::Matrix3d& R_TM) {
  const Eigen::Vector3d rpy = fixedAngles(checked, checked.start.arm.R_LT * R_TM);
  return fmt::format("[{:.6g}, {:.6g}, {:.6g}] {}", rpy.x(), rpy.y(), rpy.z(), checked.units.angles.name);
}

inline std::optional<Correction> correction(const CheckedMeasurements& checked, const std::string& value) {
  const auto R_TM = turnOf(checked, value);
  if (!R_TM) return std::nullopt;
  const bool is_order = axes::matrixOf(value).has_value();
  Correction correction{"tool-frame", value,
                        is_order ? "the turns are of a frame whose x, y and z are " + value + " of the tool's"
                                 : "the turns are those of a body mounted on the tool with roll, pitch and yaw " +
                                       value + " " + checked.units.angles.name};
  correction.sentence += ": `rpy` of the tool is " + rpyText(checked, *R_TM);
  correction.numbers_fitted = is_order ? 0 : 3;
  correction.change = toEach([R_MT = Eigen::Matrix3d(R_TM->transpose())](Measurement& measurement) {
    if (statesFrame(measurement))
      measurement.kind_values =
          deflection::fixedAnglesOf(deflection::rotationFromFixedAngles<double>(measurement.kind_values) * R_MT);
  });
  return correction;
}

inline MistakeKind kind() {
  return {.name = "tool-frame",
          .value = "ORDER",
          .expected =
              "the tool frame's axes that x, y, z of the measured frame are, right-handed, such as yzx or -yxz; or "
              "roll, pitch and yaw of a mounted body on the tool, such as 90:0:35",
          .values = values,
          .correction = correction,
          .values_with_others = noValues,  // the search for pairs uses positions alone
          .is_of_turns = true};
}

}  // namespace tubeplan::calibration::mistakes::tool_frame
