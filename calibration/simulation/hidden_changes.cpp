#include "calibration/simulation/hidden_changes.hpp"

#include <array>
#include <cassert>
#include <cmath>

#include "deflection/effects/effect.hpp"

namespace tubeplan::calibration {

namespace {

using deflection::Arm;

constexpr double kHundredthInch = 2.54e-4;                        // [m]
constexpr double kTenthDegree = 0.1 * EIGEN_PI / 180;             // [rad]
constexpr double kTurnedBy = 0.03 * EIGEN_PI / 180;               // [rad]
constexpr int kRampVisits = 25;                                   // visits in which a growing change reaches its size
constexpr double kAluminium = 2.3e-5, kTenFahrenheit = 10 / 1.8;  // [1/K], [K]
constexpr double kSofterBy = 0.3;

std::string nowhere(const Arm&) { return ""; }
std::string atBase(const Arm&) { return "base"; }  // the watch's name for a displacement of the base
std::string atArm(const Arm&) { return "arm"; }

const deflection::Row<double>& rowAt(const Arm& arm, int row) { return arm.rows[static_cast<std::size_t>(row)]; }

std::string atSlippingJoint(const Arm& arm) {
  const int row = slippingRow(arm);
  return row < 0 ? "" : rowAt(arm, row).joint.name;
}

std::string atSlippingAxis(const Arm& arm) {
  const int row = slippingRow(arm);
  return row < 0 ? "" : rowAt(arm, row).name + ".z";
}

/// Returns the last row with a flexible joint about z; -1 if there is none.
int softeningRow(const Arm& arm) {
  for (int row = static_cast<int>(arm.rows.size()) - 1; row >= 0; --row)
    if (std::isfinite(rowAt(arm, row).joint_stiffness.z())) return row;
  return -1;
}

std::string atSofteningJoint(const Arm& arm) {
  const int row = softeningRow(arm);
  return row < 0 ? "" : rowAt(arm, row).name + ".joint_stiffness.z";
}

TrueState shifted(TrueState state, const Eigen::Vector3d& by) {
  state.X_WB.translation() += by;
  return state;
}

/// Returns the state with backlash of `gap` [rad] about z in the slipping joint.
TrueState withPlay(TrueState state, double gap) {
  auto made = deflection::makeEffect(state.arm, "backlash", atSlippingAxis(state.arm));
  assert(made.status == deflection::EffectStatus::kMade);
  made.effect.values.front() = gap;
  state.arm.effects.push_back(made.effect);
  return state;
}

void grow(deflection::DenavitHartenberg<double>& placement, double strain) {
  placement.a *= 1 + strain;
  placement.d *= 1 + strain;
}
void grow(deflection::Origin<double>& placement, double strain) { placement.position *= 1 + strain; }

/// Returns the state with the arm's lengths beyond the first joint grown by `strain`, as by warmth.
TrueState grown(TrueState state, double strain) {
  bool moves = false;
  for (auto& row : state.arm.rows) {
    if (moves) std::visit([&](auto& placement) { grow(placement, strain); }, row.placement);
    moves = moves || row.joint.type != deflection::JointType::kPassive;
  }
  state.arm.p_LT *= 1 + strain;
  return state;
}

ChangedState unchanged(const TrueState& state, const DrawDirection&) { return constantState(state); }

ChangedState baseShift(const TrueState& state, const DrawDirection& draw) {
  return constantState(shifted(state, 2 * kHundredthInch * draw()));
}

ChangedState baseTurn(const TrueState& state, const DrawDirection&) {
  TrueState turned = state;
  turned.X_WB.linear() = Eigen::AngleAxisd(kTurnedBy, Eigen::Vector3d::UnitZ()) * state.X_WB.linear();
  return constantState(turned);
}

ChangedState baseCreep(const TrueState& state, const DrawDirection& draw) {
  const Eigen::Vector3d step = 2 * kHundredthInch / kRampVisits * draw();
  return [state, step](int n) { return shifted(state, n * step); };
}

ChangedState jointSlip(const TrueState& state, const DrawDirection&) {
  return constantState(withOffset(state, slippingRow(state.arm), kTenthDegree));
}

ChangedState softerJoint(const TrueState& state, const DrawDirection&) {
  TrueState softer = state;
  softer.arm.rows[static_cast<std::size_t>(softeningRow(state.arm))].joint_stiffness.z() *= 1 - kSofterBy;
  return constantState(softer);
}

ChangedState jointPlay(const TrueState& state, const DrawDirection&) {
  return constantState(withPlay(state, 2 * kTenthDegree));
}

ChangedState growingPlay(const TrueState& state, const DrawDirection&) {
  return [state](int n) { return withPlay(state, kTenthDegree / kRampVisits * n); };
}

ChangedState warmth(const TrueState& state, const DrawDirection&) {
  return constantState(grown(state, kAluminium * kTenFahrenheit));
}

constexpr std::array kHiddenChanges{
    HiddenChange{"none", "no change", "", nowhere, false, unchanged},
    HiddenChange{"base-shift", "base shifted by 0.02 in", "base-step", atBase, false, baseShift},
    HiddenChange{"base-turn", "base turned by 0.03 deg about z", "base-step", atBase, false, baseTurn},
    HiddenChange{"joint-slip", "joint slipped by 0.1 deg", "joint-offset", atSlippingJoint, false, jointSlip},
    HiddenChange{"softer-joint", "last joint softer by 30 %", "free", atSofteningJoint, false, softerJoint},
    HiddenChange{"joint-play", "joint with 0.2 deg of play", "backlash", atSlippingAxis, false, jointPlay},
    HiddenChange{"growing-play", "play growing by 0.1 deg in 25 visits", "backlash", atSlippingAxis, true, growingPlay},
    HiddenChange{"base-creep", "base creeping by 0.02 in over 25 visits", "base-step", atBase, true, baseCreep},
    HiddenChange{"warmth", "warmer by 10 degF", "thermal-growth", atArm, false, warmth}};

}  // namespace

std::span<const HiddenChange> hiddenChanges() { return kHiddenChanges; }

ChangedState constantState(TrueState state) {
  return [state = std::move(state)](int) { return state; };
}

TrueState withOffset(TrueState state, int row, double angle) {
  state.arm.rows[static_cast<std::size_t>(row)].joint.offset += angle;
  return state;
}

int slippingRow(const Arm& arm) {
  std::vector<int> rows;
  for (const int row : deflection::activeRows(arm))
    if (rowAt(arm, row).joint.type == deflection::JointType::kRevolute) rows.push_back(row);
  if (rows.empty()) return -1;
  return rows.size() == 1 ? rows.front() : rows[rows.size() - 2];
}

}  // namespace tubeplan::calibration
