#include "calibration/design/touch_choice.hpp"

#include <tbb/parallel_for.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "calibration/design/next_measurements.hpp"

namespace tubeplan::calibration {

namespace {

using Eigen::Index, Eigen::Matrix3d, Eigen::MatrixXd;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

constexpr double kNowhere = std::numeric_limits<double>::infinity();

/// Precomputed matrices with three rows per candidate. Their blocks give the tip's variance after any set of touches
/// (notation of touch_choice.hpp). W is the mean of J^T J over the tip coordinates at all work postures, with J = [T
/// U].
struct TouchBlocks {
  explicit TouchBlocks(const DesignProblem& problem) : prior(problem.information.topLeftCorner<6, 6>()) {
    const Index rows = 3 * static_cast<Index>(problem.candidates.size()), all = 6 + problem.nuisance_count;
    MatrixXd slopes(rows, all), work = MatrixXd::Zero(all, all);
    for (std::size_t k = 0; k < problem.candidates.size(); ++k)
      slopes.middleRows(3 * static_cast<Index>(k), 3) = problem.candidates[k];
    for (const auto& J : problem.work) work += J.transpose() * J / (3. * static_cast<double>(problem.work.size()));
    const MatrixXd Z = slopes.rightCols(problem.nuisance_count);
    B = slopes.leftCols(6);
    ZZ = Z * Z.transpose();
    ZWZ = Z * work.bottomRightCorner(problem.nuisance_count, problem.nuisance_count) * Z.transpose();
    ZW = Z * work.bottomLeftCorner(problem.nuisance_count, 6);
    base_work = work.topLeftCorner<6, 6>();
    numbers_variance = work.diagonal().tail(problem.nuisance_count).sum();
  }

  [[nodiscard]] int count() const { return static_cast<int>(B.rows() / 3); }

  Matrix6 prior, base_work;
  double numbers_variance = 0;  ///< variance of the tip due to the uncertain parameters before any touch
  MatrixXd B, ZZ, ZWZ, ZW;
};

/// A set of touches to which one candidate with an index of at least `first` may be added. Stores the blocks of all
/// these candidates, conditioned on the set.
class GrownSet {
 public:
  GrownSet(const TouchBlocks& blocks, const std::vector<int>& touches, int first) : blocks_(blocks), first_(first) {
    std::vector<Index> set;
    for (const int touch : touches)
      for (int row = 0; row < 3; ++row) set.push_back(3 * touch + row);
    const auto more = Eigen::seq(3 * first, Eigen::last);
    const MatrixXd B = blocks.B(set, Eigen::all), ZW = blocks.ZW(set, Eigen::all), ZWZ = blocks.ZWZ(set, set);
    const Eigen::LLT<MatrixXd> V(MatrixXd::Identity(B.rows(), B.rows()) + blocks.ZZ(set, set));
    const MatrixXd A = V.solve(B);
    shared_ = blocks.ZZ(more, set);
    gain_ = V.solve(shared_.transpose()).transpose();
    ZWZ_shared_ = blocks.ZWZ(more, set);
    ZWZ_left_ = ZWZ_shared_ - gain_ * ZWZ;
    B_left_ = blocks.B(more, Eigen::all) - shared_ * A;
    off_ = ZWZ_left_ * A - blocks.ZW(more, Eigen::all) + gain_ * ZW;
    F_ = blocks.prior + B.transpose() * A;
    by_base_ = blocks.base_work - ZW.transpose() * A - A.transpose() * ZW + A.transpose() * ZWZ * A;
    by_numbers_ = blocks.numbers_variance - V.solve(ZWZ).trace();
  }

  /// Returns the mean variance of a tip coordinate over the work postures [m^2] after `touch` is added to the set;
  /// infinite if the touches do not determine the base.
  [[nodiscard]] double varianceWith(int touch) const {
    using Block = Eigen::Matrix<double, 3, 6>;
    const Index row = 3 * touch, local_row = row - 3 * first_;
    const auto gain = gain_.middleRows<3>(local_row);
    const Matrix3d S = Matrix3d::Identity() + blocks_.ZZ.block<3, 3>(row, row) -
                       gain.lazyProduct(shared_.middleRows<3>(local_row).transpose());
    const Matrix3d ZWZ = blocks_.ZWZ.block<3, 3>(row, row) -
                         gain.lazyProduct(ZWZ_shared_.middleRows<3>(local_row).transpose()) -
                         ZWZ_left_.middleRows<3>(local_row).lazyProduct(gain.transpose());
    const Matrix3d S_inverse = S.inverse();
    const Block B = B_left_.middleRows<3>(local_row), A = S_inverse * B, off = off_.middleRows<3>(local_row);
    const Eigen::LDLT<Matrix6> F(F_ + B.transpose() * A);
    if (F.vectorD().minCoeff() <= 1e-12 * F.vectorD().maxCoeff()) return kNowhere;
    const Block half = off + 0.5 * ZWZ * A;
    const Matrix6 crossed = half.transpose() * A;
    return F.solve(by_base_ + crossed + crossed.transpose()).trace() + by_numbers_ - (S_inverse * ZWZ).trace();
  }

 private:
  const TouchBlocks& blocks_;
  int first_ = 0;
  MatrixXd shared_, gain_, ZWZ_shared_, ZWZ_left_, B_left_, off_;
  Matrix6 F_, by_base_;
  double by_numbers_ = 0;
};

struct BestSet {
  std::vector<int> touches;
  double variance = kNowhere;
};

/// Returns `touches` and the candidate, with an index of at least `first`, that reduces the tip's variance most.
BestSet withNext(const TouchBlocks& blocks, const std::vector<int>& touches, int first) {
  const GrownSet grown(blocks, touches, first);
  BestSet best{touches, kNowhere};
  best.touches.push_back(-1);
  for (int k = first; k < blocks.count(); ++k) {
    if (std::ranges::find(touches, k) != touches.end()) continue;
    if (const double v = grown.varianceWith(k); v < best.variance) best.touches.back() = k, best.variance = v;
  }
  return best;
}

/// Returns the three touches with the smallest variance of the tip; empty if no three touches determine the base.
BestSet bestTriple(const TouchBlocks& blocks) {
  std::vector<BestSet> best(static_cast<std::size_t>(blocks.count()));
  tbb::parallel_for(0, blocks.count(), [&](int i) {
    BestSet& best_from = best[static_cast<std::size_t>(i)];
    for (int j = i + 1; j + 1 < blocks.count(); ++j)
      if (BestSet triple = withNext(blocks, {i, j}, j + 1); triple.variance < best_from.variance)
        best_from = std::move(triple);
  });
  return *std::ranges::min_element(best, {}, &BestSet::variance);
}

ProposedMeasurement proposedTouch(const TouchPlan& plan, double sigma) {
  ProposedMeasurement touch;
  touch.kind = MeasurementKind::kTouch;
  touch.point = plan.hole;
  touch.known_W = plan.p_WH;
  touch.q = plan.q_start;
  touch.sigma = sigma;
  return touch;
}

}  // namespace

TouchChoice chooseTouches(const DesignProblem& problem, int count) {
  TouchChoice result;
  const int n = static_cast<int>(problem.candidates.size());
  if (n < count || count < 3) {
    result.status = TouchChoiceStatus::kTooFewCandidates;
    result.reason =
        std::to_string(n) + " holes can be touched, but " + std::to_string(count) + " (at least 3) are asked for";
    return result;
  }
  const TouchBlocks blocks(problem);
  BestSet best = bestTriple(blocks);
  while (std::isfinite(best.variance) && static_cast<int>(best.touches.size()) < count) {
    BestSet next = withNext(blocks, best.touches, 0);
    if (!std::isfinite(next.variance)) break;
    best = std::move(next);
  }
  constexpr double kUseless = 0.01;  // variance of the tip above which the base is undetermined [m^2]
  if (static_cast<int>(best.touches.size()) < count || !(best.variance < kUseless)) {
    result.status = TouchChoiceStatus::kNotDetermined;
    result.reason = "no " + std::to_string(count) + " of the " + std::to_string(n) +
                    " holes determine the base: all of them lie nearly on a line";
    return result;
  }
  result.chosen = best.touches;
  result.mean_sigma = std::sqrt(best.variance);
  result.status = TouchChoiceStatus::kDone;
  return result;
}

TouchChoice chooseTouches(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB,
                          const std::vector<TouchPlan>& candidates, const std::vector<Eigen::VectorXd>& work,
                          const TouchChoiceOptions& options) {
  if (candidates.empty()) return chooseTouches(DesignProblem{}, options.count);
  std::vector<MeasurementCandidate> touches;
  for (const auto& plan : candidates) touches.push_back({{proposedTouch(plan, options.sigma)}});
  const Estimate untouched = estimateFrom(arm, X_WB, false, {}, {{}, true}, options.additional);
  const PosedDesign posed = poseDesign(untouched, touches, {work, 0});
  TouchChoice choice = chooseTouches(posed.problem, options.count);
  for (int& k : choice.chosen) k = posed.candidates[static_cast<std::size_t>(k)];
  return choice;
}

}  // namespace tubeplan::calibration
