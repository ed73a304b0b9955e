#include "deflection/row_conventions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "deflection/anchored_rows.hpp"
#include "deflection/chain.hpp"
#include "deflection/rotation.hpp"

namespace tubeplan::deflection {

using Eigen::Matrix3d, Eigen::Vector3d;

namespace {

constexpr double kNothing = 1e-12;  ///< values below this are rounding errors [rad or m]
using CraigNumbers = DenavitHartenberg<double>;

/// Motion of a frame along and about its z axis.
struct OnAxis {
  double turn = 0, slide = 0;  ///< [rad], [m]
  [[nodiscard]] bool isNothing() const { return turn == 0 && slide == 0; }
};

/// Step from a row to the next: first a motion of the row's frame along and about its own axis, then the parameters
/// that lead to the next axis. Their theta and d then lead to the next frame.
struct RowStep {
  OnAxis first;
  CraigNumbers numbers;
};

void settle(double& number) {
  if (std::abs(number) < kNothing) number = 0;
}

/// Sets the angles that rotate the z axis to the direction `z`: alpha about x, then beta about y.
void tiltTo(const Vector3d& z, CraigNumbers& numbers) {
  numbers.alpha = std::atan2(-z.y(), z.z());
  numbers.beta = std::atan2(z.x(), z.tail<2>().norm());
  settle(numbers.alpha);
  settle(numbers.beta);
}

/// Returns the step between nearly parallel axes, perpendicular to the current axis. Also returns where it ends on the
/// next axis, relative to the next row's origin [m].
std::pair<RowStep, double> stepAcross(const Vector3d& o, const Vector3d& z) {
  const double along = -o.z() / z.z();
  const Vector3d p = o + along * z;
  RowStep step;
  step.numbers.a = p.head<2>().norm();
  settle(step.numbers.a);
  if (step.numbers.a > 0) step.first.turn = std::atan2(p.y(), p.x());
  // A negative `a` is preferred to rotating the frame by more than a quarter turn.
  if (std::abs(step.first.turn) > std::numbers::pi / 2) {
    step.numbers.a *= -1;
    step.first.turn = std::remainder(step.first.turn + std::numbers::pi, kFullTurn);
  }
  settle(step.first.turn);
  tiltTo(rotationZ<double>(-step.first.turn) * z, step.numbers);
  return {step, along};
}

/// Returns the step along the common normal. Also returns where it ends on the next axis, relative to the next row's
/// origin [m].
std::pair<RowStep, double> stepAlongNormal(const Vector3d& o, const Vector3d& z) {
  const double sine = z.head<2>().norm();
  const double along = (o.z() * z.z() - o.dot(z)) / (sine * sine);
  Vector3d normal(-z.y() / sine, z.x() / sine, 0);
  const bool is_behind = normal.x() < 0 && normal.x() < -kNothing;
  if (is_behind) normal *= -1;
  RowStep step;
  step.first = {std::atan2(normal.y(), normal.x()), o.z() + along * z.z()};
  settle(step.first.turn);
  settle(step.first.slide);
  step.numbers.a = normal.dot(o);
  step.numbers.alpha = std::atan2(is_behind ? -sine : sine, z.z());
  settle(step.numbers.a);
  return {step, along};
}

/// Returns the step to the next row's frame, given its rotation R and origin o in the frame of the row before, with the
/// joint at zero.
RowStep stepTo(const Matrix3d& R, const Vector3d& o, double nearly_parallel) {
  const Vector3d z = R.col(2);
  const double least = std::max(std::sin(nearly_parallel), kNothing);
  auto [step, along] = z.head<2>().norm() < least ? stepAcross(o, z) : stepAlongNormal(o, z);
  Row<double> arrived;
  arrived.placement = step.numbers;
  const Matrix3d R_turn = (rotationZ<double>(step.first.turn) * rotationFromPrevious<double>(arrived)).transpose() * R;
  step.numbers.theta = std::atan2(R_turn(1, 0), R_turn(0, 0));
  step.numbers.d = -along;
  settle(step.numbers.theta);
  settle(step.numbers.d);
  return step;
}

/// Returns the reason why a row's frame must not be rotated about z; empty if it may be.
std::string heldAgainstTurn(const Arm& arm, std::size_t k) {
  const Row<double>& row = arm.rows[k];
  if (row.beam) return "its beam's axes would turn";
  if (row.joint_stiffness.head<2>().array().isFinite().any()) return "the axes of its joint_stiffness would turn";
  const bool carries = std::any_of(arm.side_chains.begin(), arm.side_chains.end(),
                                   [&](const auto& chain) { return chain.row == static_cast<int>(k); });
  return carries ? "the side chain on it would turn" : "";
}

std::string heldAgainst(const Arm& arm, std::size_t k, const OnAxis& move) {
  std::string reason = move.turn == 0 ? "" : heldAgainstTurn(arm, k);
  return reason.empty() && move.slide != 0 ? heldAgainstSlide(arm, k) : reason;
}

void moveFrame(const OnAxis& move, Row<double>& row) {
  CraigNumbers& dh = std::get<CraigNumbers>(row.placement);
  dh.theta = std::remainder(dh.theta + move.turn, kFullTurn);
  dh.d += move.slide;
  settle(dh.theta);
  settle(dh.d);
  const Matrix3d R = rotationZ<double>(-move.turn);
  for (auto& lump : row.weight.lumps) lump.at = R * (lump.at - move.slide * Vector3d::UnitZ());
}

std::string freeName(const Arm& arm, std::string name) {
  while (findRow(arm, name)) name += "-base";
  return name;
}

/// Inserts a row without a joint before all others.
void putFirst(const CraigNumbers& numbers, Arm& arm) {
  Row<double> row;
  row.name = freeName(arm, "foot");
  row.placement = numbers;
  arm.rows.insert(arm.rows.begin(), row);
  for (auto& other : arm.rows)
    for (auto& followed : other.joint.follows) ++followed.row;
  for (auto& chain : arm.side_chains) ++chain.row;
  for (auto& mounting : arm.mountings)
    for (int& index : mounting.rows) ++index;
}

void placeByOrigin(std::vector<Row<double>>& rows) {
  for (auto& row : rows)
    row.placement = Origin<double>{offsetInPreviousAxes<double>(row), fixedAnglesOf(rotationFromPrevious<double>(row))};
}

/// Converts the rows to Craig's parameters; the frame of the last row does not move.
ConvertedArm modifiedRows(const Arm& arm, const ConversionOptions& options) {
  ConvertedArm converted{true, "", "", arm};
  std::vector<OnAxis> moves(arm.rows.size() + 1);  // moves of the base and of each row
  for (std::size_t k = 0; k < arm.rows.size(); ++k) {
    const RowStep step = stepTo(rotationFromPrevious<double>(arm.rows[k]), offsetInPreviousAxes<double>(arm.rows[k]),
                                options.nearly_parallel);
    moves[k] = step.first;
    converted.arm.rows[k].placement = step.numbers;
    if (k == 0) continue;
    if (const std::string reason = heldAgainst(arm, k - 1, step.first); !reason.empty())
      return {false, arm.rows[k - 1].name, reason, {}};
  }
  for (std::size_t k = 0; k < arm.rows.size(); ++k) moveFrame(moves[k + 1], converted.arm.rows[k]);
  if (!moves[0].isNothing()) {
    CraigNumbers base;
    base.theta = moves[0].turn;
    base.d = moves[0].slide;
    putFirst(base, converted.arm);
  }
  return converted;
}

bool leadsAnywhere(const CraigNumbers& dh) { return dh.alpha != 0 || dh.a != 0 || dh.beta != 0 || dh.b != 0; }

/// Names the parameters of Craig's rows as in a file of the standard convention.
void nameAsStandard(Arm& arm) {
  if (leadsAnywhere(std::get<CraigNumbers>(arm.rows.front().placement))) putFirst({}, arm);
  arm.rows.front().placed_by = arm.rows.front().name + ".axis";
  for (std::size_t k = 1; k < arm.rows.size(); ++k) arm.rows[k].placed_by = arm.rows[k - 1].name + ".dh";
}

void nameAsOwn(std::vector<Row<double>>& rows) {
  for (auto& row : rows) {
    row.placed_by.reset();
    row.is_written = true;
  }
}

}  // namespace

void readAsStandard(std::vector<Row<double>>& rows) {
  CraigNumbers before;
  std::string last, of;
  for (auto& row : rows) {
    if (&row == &rows.front()) of = row.name + ".axis";
    auto* dh = std::get_if<CraigNumbers>(&row.placement);
    if (!dh) {
      of.clear();
      continue;
    }
    std::swap(*dh, before);
    std::swap(dh->theta, before.theta);
    std::swap(dh->d, before.d);
    row.placed_by = of;
    last = row.name;
    of = last + ".dh";
  }
  if (!leadsAnywhere(before)) return;
  before.theta = before.d = 0;
  Row<double>& end = rows.emplace_back();
  end.name = last + "-end";
  end.placement = before;
  end.placed_by = of;
  end.is_written = false;
}

bool isStandard(const std::vector<Row<double>>& rows) {
  return std::any_of(rows.begin(), rows.end(), [](const auto& row) { return row.placed_by.has_value(); });
}

CraigNumbers standardNumbers(const std::vector<Row<double>>& rows, std::size_t k) {
  CraigNumbers numbers = k + 1 < rows.size() ? std::get<CraigNumbers>(rows[k + 1].placement) : CraigNumbers{};
  const auto& own = std::get<CraigNumbers>(rows[k].placement);
  numbers.theta = own.theta;
  numbers.d = own.d;
  return numbers;
}

std::span<const std::string_view> rowConventionNames() {
  static constexpr std::array<std::string_view, 3> kNames{"modified", "standard", "origin"};
  return kNames;
}

ConvertedArm convertRows(const Arm& arm, RowConvention convention, const ConversionOptions& options) {
  Arm anchored = anchoredRows(arm).arm;
  anchored.effects.clear();
  nameAsOwn(anchored.rows);
  for (auto& chain : anchored.side_chains) {
    nameAsOwn(chain.rows);
    placeByOrigin(chain.rows);
  }
  if (convention == RowConvention::kOrigin) {
    placeByOrigin(anchored.rows);
    return {true, "", "", std::move(anchored)};
  }
  ConvertedArm converted = modifiedRows(anchored, options);
  if (converted.is_converted && convention == RowConvention::kStandard) nameAsStandard(converted.arm);
  return converted;
}

}  // namespace tubeplan::deflection
