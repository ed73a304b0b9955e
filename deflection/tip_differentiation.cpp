#include "deflection/tip_differentiation.hpp"

#include <algorithm>

#include "deflection/effects/effect.hpp"
#include "deflection/resized.hpp"
#include "deflection/row_numbers.hpp"

namespace tubeplan::deflection {

namespace {

/// Returns the row whose links change with a variable of an arm without effects; `rows` if the variable belongs to no
/// row, which is so for tool, load and gravity.
int rowOf(const Variable& variable, const std::vector<int>& active, int rows) {
  if (variable.type == Variable::Type::kJoint) return active[static_cast<std::size_t>(variable.index)];
  if (variable.type == Variable::Type::kParameter) return variable.parameter.row < 0 ? rows : variable.parameter.row;
  return rows;
}

/// Flags for the parts of a row that change with the seeded variables.
struct RowChanges {
  bool placement = false, flexibility = false, others = false;
};

RowChanges changesOf(Row<Dual>& row) {
  RowChanges found;
  visitNumbers(
      [&found](const RowNumber& about, const Dual& x) {
        bool& any = about.part == RowPart::kPlacement     ? found.placement
                    : about.part == RowPart::kFlexibility ? found.flexibility
                                                          : found.others;
        any = any || changes(x);
      },
      row);
  return found;
}

void setValue(Dual& x, double value) {
  const Dual::Derivatives derivatives = x.derivatives();
  x = Dual(value);
  x.derivatives() = derivatives;
}

/// Sets the values of a row to the effective values, and keeps the row's derivatives.
void setValues(Row<Dual>& row, const Row<double>& values) {
  if (values.effect_terms) {
    if (!row.effect_terms) row.effect_terms.emplace();
    row.effect_terms->joint_is_compliant = values.effect_terms->joint_is_compliant;
    row.effect_terms->member_is_compliant = values.effect_terms->member_is_compliant;
    row.effect_terms->bends = values.effect_terms->bends;
    row.effect_terms->has_gap = values.effect_terms->has_gap;
  }
  visitNumbers([](const RowNumber&, Dual& x, double value) { setValue(x, value); }, row, values);
}

}  // namespace

TipDifferentiation::TipDifferentiation(const Arm& arm) : given_(arm), arm_(arm), direct_(arm_, sensitivity_) {
  int joint = 0;
  for (const auto& row : arm.rows) joints_.push_back(row.joint.type == JointType::kPassive ? -1 : joint++);
  active_ = activeRows(arm);
}

Dual TipDifferentiation::readingOf(std::size_t row, const Eigen::Matrix<Dual, Eigen::Dynamic, 1>& q) const {
  if (joints_[row] >= 0) return q[joints_[row]];
  const Joint<Dual>& joint = dual_arm_.rows[row].joint;
  return joint.follows.empty() ? Dual(0) : followedAngle<Dual>(dual_arm_, joint, q);
}

void TipDifferentiation::seed(const Variable& variable, int slot, double size) {
  switch (variable.type) {
    case Variable::Type::kJoint:
      dual_posture_.q[variable.index].derivatives()[slot] = size;
      return;
    case Variable::Type::kLoad:
      dual_posture_.load.derivatives()[slot] = size;
      return;
    case Variable::Type::kGravityTurn:
      gravity_turn_[variable.index].derivatives()[slot] = size;
      return;
    case Variable::Type::kParameter:
      locate(dual_arm_, variable.parameter).derivatives()[slot] = size;
      return;
  }
}

void TipDifferentiation::store(const Block& block, int count, const TipColumns& tip) {
  for (int slot = 0; slot < count; ++slot) columns_.col(static_cast<Eigen::Index>(block[slot])) = tip.col(slot);
}

/// Adds the motion of the tip caused by changes of a row, of its reading `q` and, if `leads_elsewhere`, of the vector
/// to the next row. Only the changed links and elements are built. Returns true if the vector from the row before to
/// this row may change.
bool TipDifferentiation::differentiateRow(std::size_t index, ArmOf<Dual>& arm, const Dual& q, bool leads_elsewhere,
                                          TipColumns& tip) {
  Row<Dual>& row = arm.rows[index];
  const RowChanges changed = changesOf(row);
  const bool slides = row.joint.type == JointType::kPrismatic;
  if (changed.placement || changed.others || leads_elsewhere || (slides && changes(q))) {
    direct_.addRow(index, row, q + row.joint.offset, offsetToNext<Dual>(arm, index), tip);
  } else {
    if (changed.flexibility) direct_.addElements(index, row, tip);
    if (changes(q)) direct_.addTurn(index, q, tip);
  }
  return changed.placement;
}

/// Adds the motion of the tip caused by joints that follow others, in all rows except `but`.
void TipDifferentiation::differentiateFollowers(std::size_t but, TipColumns& tip) {
  for (std::size_t i = 0; i < dual_arm_.rows.size(); ++i) {
    if (i == but || dual_arm_.rows[i].joint.follows.empty()) continue;
    const Dual angle = readingOf(i, dual_posture_.q);
    if (changes(angle)) direct_.addTurn(i, angle, tip);
  }
}

void TipDifferentiation::differentiateWithoutEffects(const std::vector<Variable>& variables) {
  const int rows = static_cast<int>(given_.rows.size());
  order_.clear();
  for (std::size_t k = 0; k < variables.size(); ++k) order_.emplace_back(rowOf(variables[k], active_, rows), k);
  std::sort(order_.begin(), order_.end());
  Block block{};
  for (std::size_t first = 0; first < order_.size();) {
    const int row = order_[first].first;
    int count = 0;
    for (; count < kDualSize && first + count < order_.size() && order_[first + count].first == row; ++count) {
      block[count] = order_[first + count].second;
      seed(variables[block[count]], count, 1);
    }
    TipColumns tip = TipColumns::Zero();
    const auto index = static_cast<std::size_t>(row);
    bool leads_elsewhere = row == rows && changes(dual_arm_.p_LT);
    if (row < rows) leads_elsewhere = differentiateRow(index, dual_arm_, readingOf(index, dual_posture_.q), false, tip);
    if (leads_elsewhere && row > 0)
      differentiateRow(index - 1, dual_arm_, readingOf(index - 1, dual_posture_.q), true, tip);
    differentiateFollowers(index, tip);
    direct_.addTipLoad(dual_posture_.load, {}, tip);
    direct_.addGravity(gravity_turn_.cross(dual_posture_.gravity_B), tip);
    if (sensitivity_.isOfTool()) addToolTurn(dual_arm_.tool_turn_L, sensitivity_.frame().R, tip);
    for (int slot = 0; slot < count; ++slot) seed(variables[block[slot]], slot, 0);
    store(block, count, tip);
    first += static_cast<std::size_t>(count);
  }
}

/// Adds the motion of the tip that the seeded variables cause in an arm with effects applied.
void TipDifferentiation::differentiateInContext(TipColumns& tip) {
  const Arm& values = arm_.effective();
  const Posture& posture = arm_.effectivePosture();
  applyEffects(*context_);
  ArmOf<Dual>& arm = context_->arm;
  for (std::size_t i = 0; i < arm.rows.size(); ++i) setValues(arm.rows[i], values.rows[i]);
  for (int axis = 0; axis < 3; ++axis) {
    setValue(arm.p_LT[axis], values.p_LT[axis]);
    setValue(arm.tool_turn_L[axis], values.tool_turn_L[axis]);
  }
  for (Eigen::Index j = 0; j < posture.q.size(); ++j) setValue(context_->posture.q[j], posture.q[j]);
  bool leads_elsewhere = changes(arm.p_LT);
  for (std::size_t i = arm.rows.size(); i-- > 0;)
    leads_elsewhere = differentiateRow(i, arm, readingOf(i, context_->posture.q), leads_elsewhere, tip);
  direct_.addTipLoad(context_->posture.load, arm.tip_load, tip);
  direct_.addGravity(context_->posture.gravity_B, tip);
  if (sensitivity_.isOfTool()) addToolTurn(arm.tool_turn_L, sensitivity_.frame().R, tip);
}

/// Rotates gravity and the wrench, which are both fixed in the world, by the seeded rotation of gravity in the base.
void TipDifferentiation::turnWorld() {
  dual_posture_.gravity_B += gravity_turn_.cross(dual_posture_.gravity_B);
  if (!dual_posture_.wrench) return;
  auto& [force_B, moment_B] = *dual_posture_.wrench;
  force_B += gravity_turn_.cross(force_B);
  moment_B += gravity_turn_.cross(moment_B);
}

void TipDifferentiation::differentiateWithEffects(const std::vector<Variable>& variables) {
  if (!context_) context_.emplace(dual_arm_, dual_posture_);
  Block block{};
  for (std::size_t first = 0; first < variables.size(); first += kDualSize) {
    const int count = static_cast<int>(std::min<std::size_t>(kDualSize, variables.size() - first));
    for (int slot = 0; slot < count; ++slot) {
      block[slot] = first + static_cast<std::size_t>(slot);
      seed(variables[block[slot]], slot, 1);
    }
    const Vector3<Dual> gravity_B = dual_posture_.gravity_B;
    const std::optional<WrenchOf<Dual>> wrench = dual_posture_.wrench;
    turnWorld();
    TipColumns tip = TipColumns::Zero();
    differentiateInContext(tip);
    moveBase(tip);
    dual_posture_.gravity_B = gravity_B;
    dual_posture_.wrench = wrench;
    for (int slot = 0; slot < count; ++slot) seed(variables[block[slot]], slot, 0);
    store(block, count, tip);
  }
}

/// Converts the columns from axes of the moved base to axes of the nominal base, and adds the motion of the base
/// itself.
void TipDifferentiation::moveBase(TipColumns& tip) const {
  const PoseOf<double>& X_BM = *arm_.movedBase();
  const Eigen::Vector3d p_MF_B = X_BM.R * sensitivity_.frame().p;
  tip.topRows<3>() = (X_BM.R * tip.topRows<3>()).eval();
  tip.bottomRows<3>() = (X_BM.R * tip.bottomRows<3>()).eval();
  addMotion(context_->X_BM, p_MF_B, tip);
}

KinematicsStatus TipDifferentiation::solveByKernel(const Posture& posture, const simd::RevoluteVariables& kernel,
                                                   const FlexibleKinematicsOptions& options) {
  kernel_columns_.resize(6 * static_cast<std::size_t>(kernel.columns()));
  arm_.solveWithDerivatives(posture, options, kernel, kernel_columns_.data());
  for (Eigen::Index k = 0; k < columns_.cols(); ++k)
    kernel.gather(static_cast<std::size_t>(k), kernel_columns_.data(), 1, 1, columns_.col(k).data(), 1);
  return arm_.status();
}

void TipDifferentiation::castPosture(const Posture& posture) {
  dual_posture_.q = posture.q.cast<Dual>();
  dual_posture_.load = posture.load;
  dual_posture_.side_q = posture.side_q.cast<Dual>();
  dual_posture_.gravity_B = posture.gravity_B.cast<Dual>();
  dual_posture_.wrench.reset();
  if (posture.wrench)
    dual_posture_.wrench = WrenchOf<Dual>{posture.wrench->force_B.cast<Dual>(), posture.wrench->moment_B.cast<Dual>()};
  dual_posture_.approach_directions = posture.approach_directions;
  dual_posture_.setup = posture.setup;
  dual_posture_.conditions = posture.conditions;
}

/// Resizes columns() after a solution, and fills it with NaN if the shape does not converge. Returns the status.
KinematicsStatus TipDifferentiation::settle(std::size_t variables) {
  resizeOrEmpty(columns_, 6, static_cast<Eigen::Index>(variables));
  if (arm_.status() != KinematicsStatus::kConverged) columns_.setConstant(std::numeric_limits<double>::quiet_NaN());
  return arm_.status();
}

void TipDifferentiation::differentiate(int row, const Posture& posture, const std::vector<Variable>& variables) {
  sensitivity_.linearize(arm_, row);
  direct_.begin();
  if (dual_arm_.rows.empty()) dual_arm_ = castArm<Dual>(given_);
  castPosture(posture);
  if (!dependsOnPosture(given_, posture))
    differentiateWithoutEffects(variables);
  else
    differentiateWithEffects(variables);
}

KinematicsStatus TipDifferentiation::solve(const Posture& posture, const std::vector<Variable>& variables,
                                           const FlexibleKinematicsOptions& options) {
  const simd::RevoluteVariables* kernel = variables.empty() || posture.wrench ? nullptr : arm_.kernelFor(variables);
  if (kernel) {
    resizeOrEmpty(columns_, 6, static_cast<Eigen::Index>(variables.size()));
    solveByKernel(posture, *kernel, options);
    return settle(variables.size());
  }
  return solveRow(kTool, posture, variables, options);
}

KinematicsStatus TipDifferentiation::solveRow(int row, const Posture& posture, const std::vector<Variable>& variables,
                                              const FlexibleKinematicsOptions& options) {
  arm_.solve(posture, options);
  if (settle(variables.size()) == KinematicsStatus::kConverged && !variables.empty())
    differentiate(row, posture, variables);
  return arm_.status();
}

}  // namespace tubeplan::deflection
