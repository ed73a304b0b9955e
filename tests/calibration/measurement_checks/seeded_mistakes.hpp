// Common mistakes introduced on purpose into clean measurements, and the judgement of whether the checks name them.
#pragma once

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "calibration/measurements/measurement_posture.hpp"
#include "calibration/measurements/measurement_prediction.hpp"
#include "tests/calibration/measurement_checks/seeded_sets.hpp"

namespace tubeplan::calibration {

/// One kind of mistake. `make` introduces it into a set and returns its correction as a value of `--assume`; empty if
/// the set does not allow the mistake.
struct SeededMistake {
  const char* name;  ///< name of the check that should find the mistake
  const char* label;
  std::optional<std::string> (*make)(SeededSet&, SeededRandom&);
};

namespace seeded {

using Made = std::optional<std::string>;

inline void scalePlaces(SeededSet& set, double factor) {
  for (auto& m : set.table.measurements) {
    if (m.p_W) *m.p_W *= factor;
    m.kind_values[0] *= factor;
  }
}

/// Converts the coordinates to `unit`, without changing the unit that their columns state.
inline Made writtenIn(SeededSet& set, const std::string& unit) {
  const auto& units = set.table.units;
  if (unit == units.coordinates.name || !set.table.measurements.front().p_W) return std::nullopt;
  scalePlaces(set, units.coordinates.factor / app::findUnit(app::UnitKind::kLength, unit)->factor);
  return "coordinates=" + unit;
}
inline Made loadsIn(SeededSet& set, const std::string& unit) {
  const double factor = set.table.units.loads.factor / app::findUnit(app::UnitKind::kForce, unit)->factor;
  bool has_load = false;
  for (auto& m : set.table.measurements) m.load *= factor, has_load = has_load || m.load > 0;
  return has_load && unit != set.table.units.loads.name ? Made("loads=" + unit) : std::nullopt;
}
inline Made sigmaIn(SeededSet& set, const std::string& unit, double factor) {
  for (auto& m : set.table.measurements) m.sigma *= factor;
  return "sigma=" + unit;
}
inline bool arePlaces(const SeededSet& set) {
  return std::all_of(set.table.measurements.begin(), set.table.measurements.end(),
                     [](const Measurement& m) { return m.p_W.has_value(); });
}
inline bool areHoles(const SeededSet& set) {
  return set.cell.sheet && set.table.measurements.front().kind == MeasurementKind::kTouch &&
         tubesheets::parseTubeName(set.table.measurements.front().point);
}
inline int drawnJoint(const SeededSet& set, SeededRandom& random) {
  return drawnBelow(static_cast<int>(set.table.joints.size()), random);
}
inline std::string jointName(const SeededSet& set, int joint) { return set.cell.arm.joint(joint).name; }

inline Made millimetres(SeededSet& s, SeededRandom&) { return writtenIn(s, "mm"); }
inline Made centimetres(SeededSet& s, SeededRandom&) { return writtenIn(s, "cm"); }
inline Made metres(SeededSet& s, SeededRandom&) { return writtenIn(s, "m"); }
inline Made feet(SeededSet& s, SeededRandom&) { return writtenIn(s, "ft"); }
inline Made newtons(SeededSet& s, SeededRandom&) { return loadsIn(s, "N"); }
inline Made kilograms(SeededSet& s, SeededRandom&) { return loadsIn(s, "kgf"); }
inline Made sigmaThousandfold(SeededSet& s, SeededRandom&) { return sigmaIn(s, "mil", 1000); }
inline Made sigmaInMillimetres(SeededSet& s, SeededRandom&) { return sigmaIn(s, "mm", 25.4); }
inline Made sigmaThousandth(SeededSet& s, SeededRandom&) { return sigmaIn(s, "*", 1e-3); }
inline Made radians(SeededSet& s, SeededRandom&) {
  for (auto& m : s.table.measurements) m.q *= std::numbers::pi / 180;
  return "angles=rad";
}
inline Made degrees(SeededSet& s, SeededRandom&) {
  for (auto& m : s.table.measurements) m.q *= 180 / std::numbers::pi;
  s.table.units.angles = {"rad", 1};
  return "angles=deg";
}
inline Made jointInRadians(SeededSet& s, SeededRandom& random) {
  const int joint = drawnJoint(s, random);
  for (auto& m : s.table.measurements) m.q[joint] *= std::numbers::pi / 180;
  return "joint-unit=" + jointName(s, joint) + ":rad";
}
inline Made coordinateInMillimetres(SeededSet& s, SeededRandom& random) {
  if (!arePlaces(s) || areHoles(s)) return std::nullopt;
  const int axis = drawnBelow(3, random);
  for (auto& m : s.table.measurements) (*m.p_W)[axis] *= s.table.units.coordinates.factor / 1e-3;
  return std::string("coordinate-unit=") + "xyz"[axis] + ":mm";
}
inline Made coordinateTimesFactor(SeededSet& s, SeededRandom& random) {
  if (!arePlaces(s) || areHoles(s)) return std::nullopt;
  const int axis = drawnBelow(3, random);
  const double factor = drawnBetween(1.2, 8, random);
  for (auto& m : s.table.measurements) (*m.p_W)[axis] *= factor;
  return std::string("coordinate-scale=") + "xyz"[axis];
}
/// Converts the sigmas of measurement `first` and of all later measurements to `unit`, the actual unit of the
/// coordinates.
inline Made withSigma(SeededSet& set, const std::string& unit, std::size_t first, Made correction) {
  const double factor = set.table.units.coordinates.factor / app::findUnit(app::UnitKind::kLength, unit)->factor;
  for (std::size_t k = first; correction && k < set.table.measurements.size(); ++k)
    set.table.measurements[k].sigma *= factor;
  return correction;
}
inline Made millimetresWithSigma(SeededSet& s, SeededRandom&) { return withSigma(s, "mm", 0, writtenIn(s, "mm")); }
inline Made feetWithSigma(SeededSet& s, SeededRandom&) { return withSigma(s, "ft", 0, writtenIn(s, "ft")); }
inline Made coordinateInMillimetresWithSigma(SeededSet& s, SeededRandom& random) {
  const Made correction = coordinateInMillimetres(s, random);
  if (!correction) return correction;
  s.table.units.axis_sigma_columns = s.table.units.coordinates;
  s.table.units.sigma_column = {"", 1};
  for (auto& m : s.table.measurements) {
    m.sigma_W = Eigen::Vector3d::Constant(m.sigma);
    (*m.sigma_W)[correction->at(correction->find('=') + 1) - 'x'] *= s.table.units.coordinates.factor / 1e-3;
  }
  return correction;
}
/// Draws a run of measurements that extends to the end of the table, as if one file had been appended to another.
/// Returns the index of its first measurement and its name "FIRST..LAST".
inline std::pair<std::size_t, std::string> drawnEnd(const SeededSet& set, SeededRandom& random) {
  const auto& measurements = set.table.measurements;
  const int count = static_cast<int>(measurements.size());
  const auto first = static_cast<std::size_t>(count - 2 - drawnBelow(count / 2, random));
  return {first, measurements[first].id + ".." + measurements.back().id};
}
inline Made lastInMillimetres(SeededSet& s, SeededRandom& random) {
  if (!arePlaces(s) || areHoles(s)) return std::nullopt;
  const auto [first, name] = drawnEnd(s, random);
  for (std::size_t k = first; k < s.table.measurements.size(); ++k)
    *s.table.measurements[k].p_W *= s.table.units.coordinates.factor / 1e-3;
  return "coordinates-of=" + name + ":mm";
}
inline Made lastInMillimetresWithSigma(SeededSet& s, SeededRandom& random) {
  SeededRandom again = random;
  const Made correction = lastInMillimetres(s, random);
  return correction ? withSigma(s, "mm", drawnEnd(s, again).first, correction) : correction;
}
inline Made lastInRadians(SeededSet& s, SeededRandom& random) {
  if (!arePlaces(s)) return std::nullopt;
  const auto [first, name] = drawnEnd(s, random);
  for (std::size_t k = first; k < s.table.measurements.size(); ++k) s.table.measurements[k].q *= std::numbers::pi / 180;
  return "angles-of=" + name + ":rad";
}
inline Made mirrored(SeededSet& s, SeededRandom& random) {
  if (!arePlaces(s) || areHoles(s)) return std::nullopt;
  const int axis = drawnBelow(3, random);
  for (auto& m : s.table.measurements) (*m.p_W)[axis] *= -1;
  return std::string("mirror=") + "xyz"[axis];
}
inline Made exchangedAxes(SeededSet& s, SeededRandom& random) {
  if (!arePlaces(s) || areHoles(s)) return std::nullopt;
  const int kept = drawnBelow(3, random), a = (kept + 1) % 3, b = (kept + 2) % 3;
  for (auto& m : s.table.measurements) std::swap((*m.p_W)[a], (*m.p_W)[b]);
  std::string order = "xyz";
  std::swap(order[static_cast<std::size_t>(a)], order[static_cast<std::size_t>(b)]);
  return "axes=" + order;
}
inline Made jointSign(SeededSet& s, SeededRandom& random) {
  const int joint = drawnJoint(s, random);
  for (auto& m : s.table.measurements) m.q[joint] *= -1;
  return "joint-sign=" + jointName(s, joint);
}
/// Adds another joint's reading to a joint's column or subtracts it, for example theta3 + theta2 in place of
/// theta3.
inline Made jointCoupling(SeededSet& s, SeededRandom& random) {
  const int joints = static_cast<int>(s.table.joints.size());
  const int joint = drawnJoint(s, random), of = (joint + (joint + 1 < joints ? 1 : -1));
  const int share = random() % 2 ? 1 : -1;
  for (auto& m : s.table.measurements) m.q[joint] -= share * m.q[of];
  return fmt::format("joint-coupling={}:{}:{}", jointName(s, joint), jointName(s, of), share);
}
/// Puts the angles of a differential's motors into the columns of two adjacent joints, with the sum in either column
/// and either order of the difference. The motors turn by the sum of the joints or by half of it.
inline Made jointPair(SeededSet& s, SeededRandom& random) {
  const int a = drawnBelow(static_cast<int>(s.table.joints.size()) - 1, random), b = a + 1;
  const double size = random() % 2 ? 0.5 : 1;
  const int negative = drawnBelow(4, random);
  Eigen::Matrix2d shares = Eigen::Matrix2d::Constant(size);
  shares(negative / 2, negative % 2) *= -1;
  const Eigen::Matrix2d to_motors = shares.inverse();
  for (auto& m : s.table.measurements) {
    const Eigen::Vector2d motors = to_motors * Eigen::Vector2d(m.q[a], m.q[b]);
    m.q[a] = motors[0], m.q[b] = motors[1];
  }
  return fmt::format("joint-pair={}:{}:{:g}:{:g}:{:g}:{:g}", jointName(s, a), jointName(s, b), shares(0, 0),
                     shares(0, 1), shares(1, 0), shares(1, 1));
}
/// Converts the readings of a joint to encoder pulses, at 200 to 5000 pulses per degree.
inline Made jointInPulses(SeededSet& s, SeededRandom& random) {
  if (!arePlaces(s)) return std::nullopt;
  const int joint = drawnJoint(s, random);
  const double factor = drawnBetween(200, 5000, random) * (random() % 2 ? 1 : -1);
  for (auto& m : s.table.measurements)
    m.q[joint] = std::round(m.q[joint] * 180 / std::numbers::pi * factor) * std::numbers::pi / 180;
  return "joint-scale=" + jointName(s, joint);
}
/// Reverses the signs of two or three joint columns.
inline Made severalSigns(SeededSet& s, SeededRandom& random) {
  const int joints = static_cast<int>(s.table.joints.size());
  std::string correction;
  const int spared = drawnBelow(joints, random);
  for (int joint = 0; joint < joints; ++joint) {
    if (joint == spared || (joint == (spared + 1) % joints && random() % 2)) continue;
    for (auto& m : s.table.measurements) m.q[joint] *= -1;
    correction += (correction.empty() ? "joint-sign=" : ",joint-sign=") + jointName(s, joint);
  }
  return correction;
}
inline Made quarterTurn(SeededSet& s, SeededRandom& random) {
  const int joint = drawnJoint(s, random);
  const double turn = random() % 2 ? 90 : -90;
  for (auto& m : s.table.measurements) m.q[joint] -= turn * std::numbers::pi / 180;
  return "joint-zero=" + jointName(s, joint);
}
inline Made partOfATurn(SeededSet& s, SeededRandom& random) {
  const int joint = drawnJoint(s, random);
  const double turn = drawnBetween(10, 60, random) * (random() % 2 ? 1 : -1);
  for (auto& m : s.table.measurements) m.q[joint] -= turn * std::numbers::pi / 180;
  return "joint-zero=" + jointName(s, joint);
}
inline Made jointOrder(SeededSet& s, SeededRandom& random) {
  const int a = drawnJoint(s, random), b = (a + 1 + drawnBelow(static_cast<int>(s.table.joints.size()) - 1, random)) %
                                           static_cast<int>(s.table.joints.size());
  for (auto& m : s.table.measurements) std::swap(m.q[a], m.q[b]);
  return "joint-order=" + jointName(s, std::min(a, b)) + ":" + jointName(s, std::max(a, b));
}
/// Permutes the columns of three joints cyclically, as when the first of them is logged last.
inline Made jointRing(SeededSet& s, SeededRandom& random) {
  const int joints = static_cast<int>(s.table.joints.size());
  if (joints < 3) return std::nullopt;
  const int spared = drawnBelow(joints, random);
  std::vector<int> ring;
  for (int j = 0; j < joints && ring.size() < 3; ++j)
    if (j != spared) ring.push_back(j);
  if (random() % 2) std::swap(ring[1], ring[2]);
  for (auto& m : s.table.measurements) {  // the column of ring[k] contains ring[k + 1]
    const double first = m.q[ring[0]];
    m.q[ring[0]] = m.q[ring[1]], m.q[ring[1]] = m.q[ring[2]], m.q[ring[2]] = first;
  }
  return fmt::format("joint-order={}:{}:{}", jointName(s, ring[0]), jointName(s, ring[1]), jointName(s, ring[2]));
}
inline Made shiftedRows(SeededSet& s, SeededRandom& random) {
  if (areHoles(s)) return std::nullopt;
  auto& measurements = s.table.measurements;
  const auto unshifted = measurements;
  const int by = random() % 2 ? 1 : -1;
  const int count = static_cast<int>(measurements.size());
  for (int k = 0; k < count; ++k) {
    const auto& from = unshifted[static_cast<std::size_t>((k - by + count) % count)];
    auto& to = measurements[static_cast<std::size_t>(k)];
    to.point = from.point, to.p_W = from.p_W, to.kind_values[0] = from.kind_values[0];
  }
  return "shift=" + std::to_string(by);
}
/// Drops or duplicates a measured point, which shifts all following points by one row.
inline Made shiftedFromAPoint(SeededSet& s, SeededRandom& random) {
  auto& measurements = s.table.measurements;
  const int count = static_cast<int>(measurements.size());
  if (!arePlaces(s) || areHoles(s) || count < 12) return std::nullopt;
  const auto original = measurements;
  const int by = random() % 2 ? 1 : -1, first = 4 + drawnBelow(count - 8, random);
  for (int k = first; k < count; ++k) {
    const int from = k - by;
    if (from >= count) break;
    auto& to = measurements[static_cast<std::size_t>(k)];
    const auto& measured = original[static_cast<std::size_t>(from)];
    if (measured.kind != to.kind || measured.setup != to.setup) return std::nullopt;
    to.point = measured.point, to.p_W = measured.p_W, to.kind_values = measured.kind_values;
  }
  if (by < 0) measurements.pop_back();
  return "shift=" + std::to_string(by) + "@" + measurements[static_cast<std::size_t>(first)].id;
}
/// Shifts the names of all holes by one row or column; only for a known base, because an unknown base would absorb the
/// shift.
inline Made holesOff(SeededSet& s, SeededRandom& random) {
  if (!areHoles(s) || !s.cell.base_known) return std::nullopt;
  const bool of_rows = random() % 2;
  const int by = random() % 2 ? 1 : -1;
  for (auto& m : s.table.measurements) {
    const auto hole = tubesheets::parseTubeName(m.point);
    const auto* tube = s.cell.sheet->find(hole->row - (of_rows ? by : 0), hole->column - (of_rows ? 0 : by));
    if (!tube) return std::nullopt;
    m.point = fmt::format("R{}C{}", tube->row, tube->column);
    m.p_W = Eigen::Vector3d(tube->x, tube->y, 0);
  }
  return fmt::format("holes={}{:+d}", of_rows ? "R" : "C", by);
}
inline Made sheetMirrored(SeededSet& s, SeededRandom&) {
  if (!areHoles(s)) return std::nullopt;
  for (auto& m : s.table.measurements) {
    const auto hole = tubesheets::parseTubeName(m.point);
    const auto* tube = s.cell.sheet->find(hole->row, s.cell.sheet->columns + 1 - hole->column);
    if (!tube) return std::nullopt;
    m.point = fmt::format("R{}C{}", tube->row, tube->column);
    m.p_W = Eigen::Vector3d(tube->x, tube->y, 0);
  }
  return "sheet-mirrored=columns";
}
inline Made oneHole(SeededSet& s, SeededRandom& random) {
  if (!areHoles(s) || s.table.measurements.size() < 12) return std::nullopt;
  auto& m =
      s.table.measurements[static_cast<std::size_t>(drawnBelow(static_cast<int>(s.table.measurements.size()), random))];
  const auto hole = tubesheets::parseTubeName(m.point);
  const auto* tube = s.cell.sheet->find(hole->row, hole->column + 1);
  if (!tube) return std::nullopt;
  const std::string correction = "hole=" + m.id + ":" + m.point;
  m.point = fmt::format("R{}C{}", tube->row, tube->column);
  m.p_W = Eigen::Vector3d(tube->x, tube->y, 0);
  return correction;
}
/// Displaces a known base by up to 0.15 of the reach and rotates it by 0.05 to 0.4 rad about gravity, so that the arm's
/// sag does not change.
inline Made baseElsewhere(SeededSet& s, SeededRandom& random) {
  if (!s.cell.base_known || !arePlaces(s)) return std::nullopt;
  const double reach = deflection::reachOf(s.cell.arm);
  Eigen::Vector3d shift;
  for (double& along : shift) along = drawnBetween(-0.15, 0.15, random) * reach;
  const Eigen::AngleAxisd turn(drawnBetween(0.05, 0.4, random), s.cell.arm.gravity_W.normalized());
  for (auto& m : s.table.measurements)
    if (m.kind == MeasurementKind::kPosition || m.kind == MeasurementKind::kTouch) *m.p_W = turn * *m.p_W + shift;
  return "base=unknown";
}
/// Moves the reflector to another point of the last link before the last set-up, which displaces the tip in the tool
/// frame.
inline Made tipAnew(SeededSet& s, SeededRandom& random) {
  std::vector<std::string> setups;
  for (const auto& m : s.table.measurements)
    if (std::find(setups.begin(), setups.end(), m.setup) == setups.end()) setups.push_back(m.setup);
  if (setups.size() < 2) return std::nullopt;
  const double reach = deflection::reachOf(s.cell.arm);
  Eigen::Vector3d by;
  do
    for (double& b : by) b = drawnBetween(-0.1, 0.1, random) * reach;
  while (by.head<2>().norm() < 0.04 * reach);
  const PlacedArm placed = app::startOf(s.cell, s.table.measurements);
  for (auto& m : s.table.measurements) {
    if (m.setup != setups.back() || !m.p_W) continue;
    // Apart from small errors of the set-up, the base is at the cell's pose, so the tool's computed rotation is nearly
    // exact.
    const auto shape =
        deflection::solveFlexibleKinematics(placed.arm, postureOf(m, placed.arm, placed.base_poses.front().X_WB));
    *m.p_W += placed.base_poses.front().X_WB.linear() * shape.X_BD.R * by;
  }
  return "setup=" + setups.front();
}
inline Made outOfReach(SeededSet& s, SeededRandom& random) {
  if (!arePlaces(s) || areHoles(s) || s.table.measurements.size() < 12) return std::nullopt;
  auto& m =
      s.table.measurements[static_cast<std::size_t>(drawnBelow(static_cast<int>(s.table.measurements.size()), random))];
  if (m.kind == MeasurementKind::kDeflection || m.kind == MeasurementKind::kDistance ||
      m.p_W->cwiseAbs().maxCoeff() < 0.3)
    return std::nullopt;
  *m.p_W *= 10;
  return "without=" + m.id;
}
inline Made duplicate(SeededSet& s, SeededRandom& random) {
  auto m =
      s.table.measurements[static_cast<std::size_t>(drawnBelow(static_cast<int>(s.table.measurements.size()), random))];
  m.id += "-again";
  s.table.measurements.push_back(m);
  return "without=" + m.id;
}

/// Copies the joints of the preceding measurement, as if logged before the controller had updated them.
inline Made staleJoints(SeededSet& s, SeededRandom& random) {
  auto& measurements = s.table.measurements;
  if (!arePlaces(s) || areHoles(s) || measurements.size() < 12) return std::nullopt;
  const auto k = static_cast<std::size_t>(1 + drawnBelow(static_cast<int>(measurements.size()) - 1, random));
  const Measurement& before = measurements[k - 1];
  if (measurements[k].kind == MeasurementKind::kDeflection || measurements[k].kind != before.kind ||
      measurements[k].setup != before.setup || (measurements[k].q - before.q).norm() < 0.3)
    return std::nullopt;
  measurements[k].q = before.q;
  measurements[k].side_q = before.side_q;
  measurements[k].load = before.load;
  return "without=" + measurements[k].id;
}

/// Step to be introduced: from measurement `first` on, the measured points are displaced, by 10 to 1000 times the
/// noise.
struct SeededStep {
  std::size_t first = 0;
  double motion = 0;  // displacement of the measured points [m]
  std::string from;
};
inline std::optional<SeededStep> drawnStep(const SeededSet& s, SeededRandom& random, double times_noise) {
  const auto& measurements = s.table.measurements;
  const int count = static_cast<int>(measurements.size());
  const bool are_positions =
      std::ranges::all_of(measurements, [](const auto& m) { return m.kind == MeasurementKind::kPosition; });
  if (!are_positions || count < 24) return std::nullopt;
  // With fewer measurements, the thirty parameters that the drawing leaves uncertain absorb most of such a small step.
  if (times_noise == 10 && count < 40) return std::nullopt;
  constexpr int kAround = 6;  // measurements of the same set-up required before and after
  const auto first = static_cast<std::size_t>(kAround + drawnBelow(count - 2 * kAround, random));
  for (std::size_t k = first - kAround; k < first + kAround; ++k)
    if (measurements[k].setup != measurements[first].setup) return std::nullopt;
  return SeededStep{first, times_noise * measurements[first].sigma, measurements[first].id};
}
inline double drawnTimes(SeededRandom& random) { return 10 * std::pow(10., drawnBetween(0, 2, random)); }

/// Lets a joint lose encoder counts at a drawn measurement: as many as displace the tip by the drawn distance on
/// average. The last joint is excluded, because its lost counts would look like a tool mounted elsewhere.
inline Made zeroFrom(SeededSet& s, SeededRandom& random, double times_noise) {
  const auto step = drawnStep(s, random, times_noise);
  if (!step) return std::nullopt;
  const int joint = drawnBelow(static_cast<int>(s.table.joints.size()) - 1, random);
  const PlacedArm placed = app::startOf(s.cell, s.table.measurements);
  double lever = 0;
  for (const auto& m : s.table.measurements)
    lever += predictMeasurement(placed.arm, placed.base_poses.front().X_WB, m, {.numbers = {}, .by_joints = true})
                 .by_joints.col(joint)
                 .norm() /
             static_cast<double>(s.table.measurements.size());
  const double lost = step->motion / lever * (random() % 2 ? 1 : -1);
  for (std::size_t k = step->first; k < s.table.measurements.size(); ++k) s.table.measurements[k].q[joint] -= lost;
  return fmt::format("joint-zero={}:{:.6g}@{}", jointName(s, joint), lost / s.table.units.angles.factor, step->from);
}
/// Moves the reflector to another point of the last link at a drawn measurement, for this and all later measurements.
inline Made tipFrom(SeededSet& s, SeededRandom& random, double times_noise) {
  const auto step = drawnStep(s, random, times_noise);
  if (!step) return std::nullopt;
  Eigen::Vector3d by;
  for (double& b : by) b = drawnBetween(-1, 1, random);
  by *= step->motion / by.norm();
  const PlacedArm placed = app::startOf(s.cell, s.table.measurements);
  const auto& X_WB = placed.base_poses.front().X_WB;
  for (std::size_t k = step->first; k < s.table.measurements.size(); ++k) {
    auto& m = s.table.measurements[k];
    *m.p_W +=
        X_WB.linear() * deflection::solveFlexibleKinematics(placed.arm, postureOf(m, placed.arm, X_WB)).X_BD.R * by;
  }
  by /= s.table.units.coordinates.factor;
  return fmt::format("tip={:.5g}:{:.5g}:{:.5g}@{}", by[0], by[1], by[2], step->from);
}
/// Displaces the tracker at a drawn measurement, and removes the times of all measurements, because with times the
/// displacement would be an effect of the catalogue.
inline Made baseFrom(SeededSet& s, SeededRandom& random, double times_noise) {
  const auto step = drawnStep(s, random, times_noise);
  if (!step) return std::nullopt;
  Eigen::Vector3d by;
  for (double& b : by) b = drawnBetween(-1, 1, random);
  by *= step->motion / by.norm();
  const Eigen::AngleAxisd turn(step->motion / deflection::reachOf(s.cell.arm), s.cell.arm.gravity_W.normalized());
  const std::string setup = s.table.measurements[step->first].setup;
  for (std::size_t k = 0; k < s.table.measurements.size(); ++k) {
    auto& m = s.table.measurements[k];
    m.conditions[Condition::kTime] = std::numeric_limits<double>::quiet_NaN();
    if (k >= step->first && m.setup == setup) *m.p_W = turn * *m.p_W + by;
  }
  return "base=unknown@" + step->from;
}
inline Made zeroFromBarely(SeededSet& s, SeededRandom& random) { return zeroFrom(s, random, 10); }
inline Made zeroFromByFar(SeededSet& s, SeededRandom& random) { return zeroFrom(s, random, drawnTimes(random)); }
inline Made tipFromBarely(SeededSet& s, SeededRandom& random) { return tipFrom(s, random, 10); }
inline Made tipFromByFar(SeededSet& s, SeededRandom& random) { return tipFrom(s, random, drawnTimes(random)); }
inline Made baseFromBarely(SeededSet& s, SeededRandom& random) { return baseFrom(s, random, 10); }
inline Made baseFromByFar(SeededSet& s, SeededRandom& random) { return baseFrom(s, random, drawnTimes(random)); }

/// Draws a run of up to a fifth of the measurements, during which a device is to be frozen.
inline std::optional<std::pair<std::size_t, std::size_t>> drawnRun(const SeededSet& s, SeededRandom& random) {
  const auto& measurements = s.table.measurements;
  const int count = static_cast<int>(measurements.size());
  const auto step = drawnStep(s, random, 0);
  if (!step) return std::nullopt;
  const auto last = std::min(step->first + static_cast<std::size_t>(1 + drawnBelow(count / 5, random)),
                             static_cast<std::size_t>(count - 1));
  for (std::size_t k = step->first; k <= last; ++k)
    if (measurements[k].setup != measurements[step->first].setup ||
        (measurements[k].q - measurements[step->first - 1].q).norm() < 0.3)
      return std::nullopt;
  return std::pair(step->first, last);
}
inline Made staleRun(SeededSet& s, SeededRandom& random) {
  const auto run = drawnRun(s, random);
  if (!run) return std::nullopt;
  auto& measurements = s.table.measurements;
  for (std::size_t k = run->first; k <= run->second; ++k)
    measurements[k].q = measurements[run->first - 1].q, measurements[k].load = measurements[run->first - 1].load;
  return "without=" + measurements[run->first].id + ".." + measurements[run->second].id;
}
inline Made frozenTracker(SeededSet& s, SeededRandom& random) {
  const auto run = drawnRun(s, random);
  if (!run) return std::nullopt;
  auto& measurements = s.table.measurements;
  for (std::size_t k = run->first; k <= run->second; ++k) measurements[k].p_W = measurements[run->first - 1].p_W;
  return "without=" + measurements[run->first].id + ".." + measurements[run->second].id;
}

}  // namespace seeded

inline const std::vector<SeededMistake>& seededMistakes() {
  static const std::vector<SeededMistake> kMistakes{
      {"coordinates", "coordinates in mm", seeded::millimetres},
      {"coordinates", "coordinates in cm", seeded::centimetres},
      {"coordinates", "coordinates in m", seeded::metres},
      {"coordinates", "coordinates in ft", seeded::feet},
      {"coordinates", "coordinates and sigma in mm", seeded::millimetresWithSigma},
      {"coordinates", "coordinates and sigma in ft", seeded::feetWithSigma},
      {"coordinate-unit", "one coordinate and its sigma in mm", seeded::coordinateInMillimetresWithSigma},
      {"coordinates-of", "the last coordinates and sigmas in mm", seeded::lastInMillimetresWithSigma},
      {"loads", "loads in N", seeded::newtons},
      {"loads", "loads in kg", seeded::kilograms},
      {"angles", "radians under deg", seeded::radians},
      {"angles", "degrees under rad", seeded::degrees},
      {"joint-unit", "one joint in radians under deg", seeded::jointInRadians},
      {"coordinate-unit", "one coordinate in mm", seeded::coordinateInMillimetres},
      {"coordinate-scale", "one coordinate times a factor", seeded::coordinateTimesFactor},
      {"coordinates-of", "the last coordinates in mm", seeded::lastInMillimetres},
      {"angles-of", "the last joint readings in radians under deg", seeded::lastInRadians},
      {"sigma", "sigma x 1000", seeded::sigmaThousandfold},
      {"sigma", "sigma x 25.4", seeded::sigmaInMillimetres},
      {"sigma", "sigma / 1000", seeded::sigmaThousandth},
      {"mirror", "one axis mirrored", seeded::mirrored},
      {"axes", "two axes exchanged", seeded::exchangedAxes},
      {"joint-sign", "a joint's sign", seeded::jointSign},
      {"joint-sign", "the signs of several joints", seeded::severalSigns},
      {"joint-coupling", "a joint shown with another's", seeded::jointCoupling},
      {"joint-pair", "a differential's motors for two joints", seeded::jointPair},
      {"joint-scale", "a joint in pulses", seeded::jointInPulses},
      {"joint-zero", "a zero 90 deg off", seeded::quarterTurn},
      {"joint-zero", "a zero 10-60 deg off", seeded::partOfATurn},
      {"joint-order", "two joints exchanged", seeded::jointOrder},
      {"joint-order", "three joints in a ring", seeded::jointRing},
      {"shift", "rows shifted by one", seeded::shiftedRows},
      {"shift", "rows shifted from a point on", seeded::shiftedFromAPoint},
      {"joint-zero", "counts lost midway, 10 sigma", seeded::zeroFromBarely},
      {"joint-zero", "counts lost midway", seeded::zeroFromByFar},
      {"tip", "another target midway, 10 sigma", seeded::tipFromBarely},
      {"tip", "another target midway", seeded::tipFromByFar},
      {"base", "tracker bumped midway, 10 sigma", seeded::baseFromBarely},
      {"base", "tracker bumped midway", seeded::baseFromByFar},
      {"holes", "holes one off", seeded::holesOff},
      {"sheet-mirrored", "sheet mirrored", seeded::sheetMirrored},
      {"hole", "one hole mistaken", seeded::oneHole},
      {"base", "base elsewhere", seeded::baseElsewhere},
      {"setup", "tip mounted anew", seeded::tipAnew},
      {"out-of-reach", "a place out of reach", seeded::outOfReach},
      {"duplicates", "a row twice", seeded::duplicate},
      {"stale-joints", "the joints of the row before", seeded::staleJoints},
      {"stale-joints", "a run of stale joints", seeded::staleRun},
      {"stale-places", "a tracker that stood still", seeded::frozenTracker},
  };
  return kMistakes;
}

/// Returns true if two corrections name a step of the same kind and joint, with values within 30 % and first
/// measurements at most two rows apart. The first measurement cannot be determined exactly if the step hardly changes
/// the measurements next to it.
inline bool isSameStep(const std::string& a, const std::string& b) {
  constexpr double kRows = 2, kShare = 0.3;
  const auto at = [](const std::string& text) { return std::min(text.find('@'), text.size()); };
  const auto numberOf = [](const std::string& id) {
    return std::atof(id.substr(std::min(id.find_first_of("0123456789"), id.size())).c_str());
  };
  if (at(a) == a.size() || at(b) == b.size()) return false;
  if (std::abs(numberOf(a.substr(at(a))) - numberOf(b.substr(at(b)))) > kRows) return false;
  const auto partsOf = [&](const std::string& text) {
    std::vector<std::string> parts(1);
    for (const char c : text.substr(0, at(text)))
      if (c == ':' || c == '=')
        parts.emplace_back();
      else
        parts.back() += c;
    return parts;
  };
  const auto of_a = partsOf(a), of_b = partsOf(b);
  if (of_a.size() != of_b.size()) return false;
  double squared_difference = 0, size = 0;
  for (std::size_t k = 0; k < of_a.size(); ++k) {
    const bool is_number = of_a[k].find_first_not_of("+-.0123456789e") == std::string::npos;
    if (!is_number && of_a[k] != of_b[k]) return false;
    if (!is_number) continue;
    squared_difference += std::pow(std::atof(of_a[k].c_str()) - std::atof(of_b[k].c_str()), 2);
    size += std::pow(std::atof(of_b[k].c_str()), 2);
  }
  return squared_difference <= kShare * kShare * size;
}

enum class Naming { kRight, kEqually, kWrong, kMissed };

/// Returns how the checks name the mistake: first, among equally good explanations, wrongly, or not at all. For a zero
/// or a scale, whose value is estimated, only the joint must agree; for sigmas, only the kind of mistake.
inline Naming judgeNaming(const SeededMistake& mistake, const std::string& correction,
                          const MeasurementChecks& checks) {
  const auto fits = [&](const std::string& assume) {
    if (correction.find('@') != std::string::npos && !correction.starts_with("shift="))
      return isSameStep(assume, correction);
    if (mistake.name == std::string("sigma")) return assume.starts_with("sigma=");
    if (mistake.name == std::string("joint-zero") || std::string(mistake.name).ends_with("-scale"))
      return assume.starts_with(correction + ":");
    if (mistake.name == std::string("setup")) return assume.starts_with("setup=");
    return assume == correction || assume.starts_with(correction + ",sigma=");
  };
  bool is_wrong = false;
  for (const auto& check : checks.checks) {
    if (check.assume.empty()) continue;
    if (fits(check.assume)) return Naming::kRight;
    if (std::any_of(check.equally.begin(), check.equally.end(), fits)) return Naming::kEqually;
    is_wrong = true;
  }
  return is_wrong ? Naming::kWrong : Naming::kMissed;
}

}  // namespace tubeplan::calibration
