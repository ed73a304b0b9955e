#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <map>

#include "calibration/measurements/measurement_prediction.hpp"
#include "calibration/measurements/surfaces.hpp"
#include "calibration/patterns/condition.hpp"
#include "calibration/patterns/constant.hpp"
#include "calibration/patterns/joint_reading.hpp"
#include "calibration/patterns/joint_sense.hpp"
#include "calibration/patterns/load.hpp"
#include "calibration/patterns/moment.hpp"
#include "calibration/patterns/order.hpp"
#include "calibration/patterns/pattern.hpp"
#include "calibration/patterns/place.hpp"
#include "calibration/patterns/point.hpp"
#include "calibration/patterns/setup.hpp"

namespace tubeplan::calibration {

using Eigen::Index, Eigen::Matrix3d, Eigen::MatrixXd, Eigen::Vector3d, Eigen::VectorXd;

namespace {

// Distance from the vertical through the base within which the radial direction is undefined [m].
constexpr double kOnAxis = 1e-6;
constexpr double kSameValue = 1e-9;

Matrix3d radialAxes(const Vector3d& from_base, const Vector3d& gravity) {
  const Vector3d up = -gravity.normalized();
  Vector3d away = from_base - from_base.dot(up) * up;
  if (away.norm() < kOnAxis) away = up.unitOrthogonal();
  away.normalize();
  Matrix3d axes;
  axes << away, up.cross(away), up;
  return axes;
}

/// Returns the smallest and the largest stated value; NaN means not stated.
std::pair<double, double> rangeOf(const VectorXd& value) {
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for (const double v : value)
    if (std::isfinite(v)) least = std::min(least, v), most = std::max(most, v);
  return {least, most};
}

}  // namespace

const std::vector<PatternKind>& patternKinds() {
  static const std::vector<PatternKind> kKinds = [] {
    std::vector<PatternKind> kinds = {patterns::constant::kind(), patterns::joint_reading::kind(),
                                      patterns::joint_sense::kind(), patterns::load::kind(), patterns::moment::kind()};
    for (const auto& condition : deflection::kConditionKinds) kinds.push_back(patterns::condition::kind(condition));
    for (auto* kind : {patterns::order::kind, patterns::place::kind, patterns::point::kind, patterns::setup::kind})
      kinds.push_back(kind());
    return kinds;
  }();
  return kKinds;
}

MeasurementScene observe(const PlacedArm& placed, const std::vector<Measurement>& measurements) {
  MeasurementScene scene{true, placed, measurements, {}, {}, {}, {}, {}};
  settleSurfaces(placed, scene.measurements);
  scene.tips.resize(3, static_cast<Index>(measurements.size()));
  scene.seen.resize(3, static_cast<Index>(measurements.size()));
  scene.tools.resize(measurements.size());
  scene.radials.resize(measurements.size());
  scene.moments_L.resize(measurements.size());
  std::atomic<bool> ok = true;
  tbb::parallel_for(std::size_t{0}, measurements.size(), [&](std::size_t k) {
    const auto& X_WB = basePoseAt(placed, measurements[k]);
    const auto shape = deflection::solveFlexibleKinematics(placed.arm, postureOf(measurements[k], placed.arm, X_WB));
    if (shape.status != deflection::KinematicsStatus::kConverged) {
      ok = false;
      return;
    }
    const Vector3d tip = X_WB * shape.X_BD.p;
    scene.tips.col(static_cast<Index>(k)) = scene.seen.col(static_cast<Index>(k)) = tip;
    if (const auto from = referencePostureOf(measurements[k], placed.arm, X_WB)) {
      const auto reference = deflection::solveFlexibleKinematics(placed.arm, *from);
      if (reference.status != deflection::KinematicsStatus::kConverged) {
        ok = false;
        return;
      }
      scene.seen.col(static_cast<Index>(k)) -= X_WB * reference.X_BD.p;
    }
    scene.tools[k] = X_WB.linear() * shape.X_BD.R;
    scene.radials[k] = radialAxes(tip - X_WB.translation(), placed.arm.gravity_W);
    scene.moments_L[k].resize(3, static_cast<Index>(shape.rows.size()));
    for (std::size_t i = 0; i < shape.rows.size(); ++i)
      scene.moments_L[k].col(static_cast<Index>(i)) = shape.rows[i].moment_L;
  });
  scene.ok = ok;
  return scene;
}

VectorXd centred(const VectorXd& value, double (*function)(double)) {
  VectorXd column = VectorXd::Zero(value.size());
  double sum = 0;
  int count = 0;
  for (Index k = 0; k < value.size(); ++k)
    if (std::isfinite(value[k])) column[k] = function(value[k]), sum += column[k], ++count;
  for (Index k = 0; k < value.size(); ++k)
    if (std::isfinite(value[k])) column[k] -= sum / count;
  return column;
}

bool varies(const VectorXd& value) {
  const auto [least, most] = rangeOf(value);
  return most - least > kSameValue * std::max(std::abs(least), std::abs(most));
}

MatrixXd slowWaves(const VectorXd& value) {
  const auto [least, most] = rangeOf(value);
  MatrixXd waves(value.size(), 3);
  const VectorXd phase = (value.array() - least) * (EIGEN_PI / (most - least));
  waves.col(0) = centred(phase, [](double p) { return std::cos(p); });
  waves.col(1) = centred(phase, [](double p) { return std::cos(2 * p); });
  waves.col(2) = centred(phase, [](double p) { return std::cos(3 * p); });
  return waves;
}

MatrixXd fasterWaves(const VectorXd& value) {
  constexpr Index kFirst = 4, kMostCycles = 12, kMeasurementsOfCycle = 8;  // the first three waves are the slow waves
  const Index cycles = std::min(kMostCycles, value.array().isFinite().count() / kMeasurementsOfCycle);
  if (2 * cycles < kFirst) return {};
  const auto [least, most] = rangeOf(value);
  MatrixXd waves(value.size(), 2 * cycles - kFirst + 1);
  for (Index k = 0; k < waves.cols(); ++k) {
    const VectorXd phase = (value.array() - least) * (static_cast<double>(k + kFirst) * EIGEN_PI / (most - least));
    waves.col(k) = centred(phase, [](double p) { return std::cos(p); });
  }
  return waves;
}

Variable groupVariable(const std::string& name, const std::vector<std::string>& group_of_measurement) {
  Variable variable{name, {}, VectorXd(static_cast<Index>(group_of_measurement.size())), {}, {}};
  std::map<std::string, std::size_t> index;
  for (std::size_t k = 0; k < group_of_measurement.size(); ++k) {
    const auto [at, is_new] = index.emplace(group_of_measurement[k], index.size());
    variable.value[static_cast<Index>(k)] = static_cast<double>(at->second);
    if (is_new) variable.groups.push_back(group_of_measurement[k]);
  }
  return variable;
}

}  // namespace tubeplan::calibration
