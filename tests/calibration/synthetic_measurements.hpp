// Simulated measurements of an arm with known parameters, with or without noise.
#pragma once

#include <Eigen/Cholesky>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <boost/random/uniform_real_distribution.hpp>
#include <cmath>
#include <map>

#include "calibration/measurements/measurement_prediction.hpp"
#include "calibration/measurements/steps.hpp"
#include "calibration/measurements/tip_placement.hpp"
#include "deflection/inverse/inverse_kinematics.hpp"
#include "tests/deflection/cobra.hpp"

namespace tubeplan::calibration {

inline const deflection::FlexibleKinematicsOptions kFine{1e-14, 200};

inline Eigen::Isometry3d poseOf(const Eigen::Vector3d& position, const Eigen::Vector3d& fixed_angles) {
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  X.translation() = position;
  X.linear() = deflection::rotationFromFixedAngles<double>(fixed_angles);
  return X;
}

/// Returns the Cobra arm on its mezzanine, with one base pose, which is known.
inline PlacedArm cobra() {
  return {deflection::cobraArm(), {{"", poseOf({0.1, -0.2, 0.05}, {0.02, -0.03, 0.4}), true}}};
}

/// Returns the Cobra arm with two base poses that a fit must find, one for each of the set-ups "A" and "B".
inline PlacedArm cobraTwice() {
  return {deflection::cobraArm(),
          {{"A", poseOf({0.1, -0.2, 0.05}, {0.02, -0.03, 0.4}), false},
           {"B", poseOf({-0.4, 0.3, 0.1}, {-0.01, 0.04, -0.7}), false}}};
}

/// Simulates measurements of an arm; equal seeds give equal measurements. The sigmas stated in the measurements do not
/// depend on whether noise is added.
class MeasurementMaker {
 public:
  enum class Noise { kNone, kStated };

  MeasurementMaker(PlacedArm truth, std::uint64_t seed, Noise noise = Noise::kNone, double touch_sigma = 0.005 * kInch)
      : truth_(std::move(truth)), random_(seed), has_noise_(noise == Noise::kStated), touch_sigma_(touch_sigma) {}

  std::vector<Measurement> measurements;
  /// Standard deviations and correlations of x, y and z, for measurements of kinds that measure these: stated, and used
  /// for the noise added.
  std::optional<Eigen::Vector3d> sigma_W, correlation_W;

  /// Adds `count` measurements of one kind, which must not be touches, at random postures. They measure the frame of
  /// row `of_row` if given, otherwise the tool frame.
  void add(MeasurementKind kind, int count, const std::string& setup = "", std::optional<int> of_row = {}) {
    for (int k = 0; k < count; ++k) {
      Measurement m = blank(kind, setup);
      m.row = of_row;
      m.q = drawPosture();
      m.load = uniform(10, 40) * kPound;
      const MeasurementKindRow& row = kindOf(kind);
      if (row.settle) {
        k -= touchSurface(row, m) ? 0 : 1;
        continue;
      }
      if (row.has_anchor) m.p_W = Eigen::Vector3d(uniform(-3, 3), uniform(-3, 3), uniform(-2, -1));
      if (row.has_direction)
        m.direction_W = Eigen::Vector3d(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)).normalized();
      if (row.is_to_gravity) m.direction_W = -truth_.arm.gravity_W;
      if (row.turn_rows > 0) m.turn_sigma = 0.01 * kDegree;
      if (row.is_from_measurement) m.reference = anotherMeasurement(setup);
      ToolPose tool = toolOf(m);
      if (row.is_from_measurement) {
        tool.p_W -= toolOf(*m.reference).p_W;
        m.reference = withEncoderNoise(*m.reference);
      }
      if (row.names_hole) m.p_W = tool.p_W + holeOffset(row);
      MeasuredValue noise_of_rows(row.rows);
      for (int i = 0; i < row.rows; ++i)
        noise_of_rows[i] = i < row.rows - row.turn_rows ? noise(m.sigma) : kTurnLever * noise(m.turn_sigma);
      if (sigma_W && row.has_coordinates) {
        m.sigma_W = sigma_W;
        m.correlation_W = correlation_W;
        m.sigma = std::sqrt(sigma_W->squaredNorm() / 3);
        const Eigen::Matrix3d R = correlationMatrix(correlation_W.value_or(Eigen::Vector3d::Zero()));
        noise_of_rows.head<3>() = sigma_W->asDiagonal() * Eigen::Matrix3d(R.llt().matrixL()) * noise3(1);
      }
      row.record(tool, 1, noise_of_rows, m);
      if (row.counts_steps && !settleSteps(m)) {
        --k;
        continue;
      }
      m.q += encoderNoise();
      measurements.push_back(m);
    }
  }

  /// Adds touches of new points; each point is touched once under each of the loads [N], with the tool at the same
  /// tilt.
  void addTouches(int points, const std::vector<double>& loads, bool are_known, const std::string& setup = "") {
    for (int made = 0; made < points;) made += touchPoint(loads, are_known, setup) ? 1 : 0;
  }

  [[nodiscard]] double uniform(double from, double to) {
    return boost::random::uniform_real_distribution<double>(from, to)(random_);
  }
  [[nodiscard]] double noise(double sigma) {
    return has_noise_ ? boost::random::normal_distribution<double>(0, sigma)(random_) : 0;
  }
  [[nodiscard]] Eigen::Vector3d noise3(double sigma) {
    const double x = noise(sigma), y = noise(sigma), z = noise(sigma);
    return {x, y, z};
  }

  /// Returns a random posture. For the Cobra, it is well within the joint limits, with the elbow up; for other arms,
  /// each joint is in the middle half of its range.
  [[nodiscard]] Eigen::VectorXd drawPosture() {
    static constexpr double kFrom[] = {-120, 30, -110, -80}, kTo[] = {120, 110, -20, 20};
    Eigen::VectorXd q(truth_.arm.jointCount());
    for (int k = 0; k < q.size(); ++k) {
      const auto& joint = truth_.arm.joint(k);
      q[k] = q.size() == 4 ? uniform(kFrom[k], kTo[k]) * kDegree : uniform(joint.lower, joint.upper) / 2;
    }
    return q;
  }

 private:
  /// The surface touched last, and the number of measurements so far of its kind and in its set-up.
  struct Touched {
    Surface surface;
    int measurements = 0;
  };

  /// Moves the tip onto a surface, which is shared by ten successive measurements, and adds the measurement; returns
  /// false if the tip cannot reach the surface.
  bool touchSurface(const MeasurementKindRow& row, Measurement& m) {
    constexpr int kOfSurface = 10;
    constexpr double kFarthest = 1.5;  // farthest motion to the surface, in joint space [rad]
    Touched& on = touched_[m.setup + row.name];
    const Eigen::Vector3d tip_W = toolOf(m).p_W;
    if (on.measurements % kOfSurface == 0)
      on.surface = row.through(tip_W, Eigen::Vector3d(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)).normalized());
    const Eigen::Vector3d goal_W = row.nearest(on.surface, tip_W) + noise3(m.sigma);
    const auto placed =
        placeTip(truth_.arm, postureOf(m, truth_.arm, baseOf(m)), baseOf(m).inverse() * goal_W, {.tolerance = 1e-13});
    if (placed.status != TipPlacementStatus::kPlaced || (placed.q - m.q).norm() > kFarthest) return false;
    m.q = placed.q + encoderNoise();
    m.point = m.setup + row.name + std::to_string(on.measurements++ / kOfSurface);
    m.surface = on.surface;
    row.record(toolOf(m), 1, MeasuredValue::Zero(row.rows), m);
    m.surface.reset();
    measurements.push_back(m);
    return true;
  }

  Measurement blank(MeasurementKind kind, const std::string& setup) {
    Measurement m;
    m.id = std::to_string(measurements.size() + 1);
    m.kind = kind;
    m.setup = setup;
    m.sigma = kind == MeasurementKind::kTouch ? touch_sigma_ : 0.003 * kInch;
    return m;
  }

  /// Returns the pose of the measured frame in the world; for a measurement of kind deflection, the position is the
  /// displacement caused by the load.
  [[nodiscard]] ToolPose toolOf(const Measurement& m) const {
    const auto& X_WB = truth_.base_poses[static_cast<std::size_t>(basePoseOf(truth_, m))].X_WB;
    ToolPose tool = *frameAt(truth_.arm, X_WB, m);
    Measurement unloaded = m;
    unloaded.load = 0;
    if (kindOf(m).departure && !kindOf(m).is_from_measurement) tool.p_W -= toolAt(truth_.arm, X_WB, unloaded)->p_W;
    return tool;
  }

  [[nodiscard]] std::shared_ptr<const Measurement> anotherMeasurement(const std::string& setup) {
    auto other = std::make_shared<Measurement>(blank(MeasurementKind::kPosition, setup));
    other->q = drawPosture();
    other->load = uniform(10, 40) * kPound;
    return other;
  }
  [[nodiscard]] std::shared_ptr<const Measurement> withEncoderNoise(const Measurement& measurement) {
    auto noisy = std::make_shared<Measurement>(measurement);
    noisy->q += encoderNoise();
    return noisy;
  }

  /// Returns a random position [m] of a hole relative to the tip, which is close to the tip for kinds that centre it in
  /// the hole.
  [[nodiscard]] Eigen::Vector3d holeOffset(const MeasurementKindRow& row) {
    const double far = row.is_centring ? 0.03 * kInch : 0.02, across = row.is_centring ? 0 : 0.05;
    return {far * noiseOf(), far * noiseOf(), across};
  }
  [[nodiscard]] double noiseOf() { return boost::random::normal_distribution<double>(0, 1)(random_); }

  /// Sets the number of steps that enter, for a tool with three steps; returns false if none enters.
  static bool settleSteps(Measurement& m) {
    static constexpr double kTolerances[] = {0.09 * kInch, 0.06 * kInch, 0.03 * kInch};
    const double off = m.kind_values.tail<2>().norm();
    int inserted = 0;
    while (inserted < 3 && off <= kTolerances[inserted]) ++inserted;
    if (inserted == 0) return false;
    m.kind_values = {static_cast<double>(inserted), inserted < 3 ? kTolerances[inserted] : 0,
                     kTolerances[inserted - 1]};
    m.sigma = steps::sigmaBetween(m.kind_values[1], m.kind_values[2]);
    return true;
  }

  const Eigen::Isometry3d& baseOf(const Measurement& m) const {
    return truth_.base_poses[static_cast<std::size_t>(basePoseOf(truth_, m))].X_WB;
  }

  Eigen::VectorXd encoderNoise() {
    Eigen::VectorXd d(truth_.arm.jointCount());
    for (int k = 0; k < d.size(); ++k) d[k] = noise(truth_.arm.joint(k).encoder_sigma);
    return d;
  }

  bool touchPoint(const std::vector<double>& loads, bool is_known, const std::string& setup) {
    Measurement m = blank(MeasurementKind::kTouch, setup);
    m.point = setup + "P" + std::to_string(measurements.size() + 1);
    m.q = drawPosture();
    m.load = loads.front();
    const Eigen::Isometry3d X_WB = baseOf(m);
    const auto gravity_B = deflection::gravityInBase(truth_.arm, X_WB);
    const auto shape = deflection::solveFlexibleKinematics(truth_.arm, {m.q, m.load, gravity_B}, kFine);
    const Eigen::Vector3d axis_B = shape.X_BD.R * truth_.arm.tool_axis_L;
    std::vector<Measurement> made;
    for (const double load : loads) {
      const deflection::ToolGoal goal{shape.X_BD.p + X_WB.linear().transpose() * noise3(m.sigma), axis_B};
      deflection::InverseKinematicsOptions options;
      options.position_tolerance = options.pitch_tolerance = 1e-13;
      options.kinematics = kFine;
      const auto branch = deflection::refineBranch(truth_.arm, goal, load, gravity_B, m.q, options);
      if (branch.position_error > 1e-9 || (branch.q - m.q).norm() > 0.3) return false;
      made.push_back(m);
      made.back().id = std::to_string(measurements.size() + made.size());
      made.back().load = load;
      made.back().q = branch.q + encoderNoise();
      if (is_known) made.back().p_W = X_WB * shape.X_BD.p;
    }
    measurements.insert(measurements.end(), made.begin(), made.end());
    return true;
  }

  PlacedArm truth_;
  boost::random::mt19937_64 random_;
  std::map<std::string, Touched> touched_;  ///< the surface touched last, by kind and set-up
  bool has_noise_;
  double touch_sigma_;
};

/// Adds `count` measurements of every kind except touches; a few touches of a surface would give no information
/// (surfaces_test.cpp). Every second measurement measures a point of the tool away from its tip.
inline void addUntouched(MeasurementMaker& maker, int count, const std::string& setup = "") {
  const std::size_t first = maker.measurements.size();
  for (const MeasurementKindRow& row : measurementKinds())
    if (!row.is_touch && !row.settle) maker.add(row.kind, count, setup);
  for (std::size_t k = first; k < maker.measurements.size(); k += 2)
    if (!isDisplacement(maker.measurements[k])) maker.measurements[k].p_TQ = Eigen::Vector3d(0.03, -0.02, 0.05);
}

/// Adds, in one set-up, `count` positions, deflections and distances, and touches of `count` known and `count` unknown
/// points.
inline void addEveryKind(MeasurementMaker& maker, int count, const std::string& setup = "") {
  maker.add(MeasurementKind::kPosition, count, setup);
  maker.add(MeasurementKind::kDeflection, count, setup);
  maker.add(MeasurementKind::kDistance, count, setup);
  maker.addTouches(count, {0, 30 * kPound}, true, setup);
  maker.addTouches(count, {0, 20 * kPound, 40 * kPound}, false, setup);
}

}  // namespace tubeplan::calibration
