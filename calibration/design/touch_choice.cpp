#include "calibration/design/touch_choice.hpp"

#include <tbb/parallel_for.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>

#include "calibration/measurements/reading_prediction.hpp"

namespace tubeplan::calibration {

namespace {

using Eigen::Index, Eigen::MatrixXd;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

constexpr double kNowhere = std::numeric_limits<double>::infinity();

/// What the tip's variance after some touches is made of.
class TouchSets {
 public:
  explicit TouchSets(const DesignProblem& problem) : prior_(problem.information.topLeftCorner<6, 6>()) {
    const Index rows = 3 * static_cast<Index>(problem.candidates.size()), all = 6 + problem.beside;
    MatrixXd slopes(rows, all), work = MatrixXd::Zero(all, all);
    for (std::size_t k = 0; k < problem.candidates.size(); ++k)
      slopes.middleRows(3 * static_cast<Index>(k), 3) = problem.candidates[k];
    for (const auto& J : problem.work) work += J.transpose() * J / (3. * static_cast<double>(problem.work.size()));
    const MatrixXd Z = slopes.rightCols(problem.beside);
    const MatrixXd Z_work = Z * work.bottomRightCorner(problem.beside, problem.beside);
    by_base_ = slopes.leftCols(6);
    by_numbers_ = Z * Z.transpose();
    of_numbers_ = Z_work * Z.transpose();
    of_both_ = Z * work.bottomLeftCorner(problem.beside, 6);
    base_work_ = work.topLeftCorner<6, 6>();
    numbers_variance_ = work.diagonal().tail(problem.beside).sum();
  }

  [[nodiscard]] int count() const { return static_cast<int>(by_base_.rows() / 3); }

  /// Mean variance of a coordinate of the tip over the work [m^2]; infinite where the touches do not place the base.
  /// `Rows`: three times as many as touches, or Eigen::Dynamic.
  template <int Rows, class Touches>
  [[nodiscard]] double variance(const Touches& touches) const {
    using Square = Eigen::Matrix<double, Rows, Rows>;
    using Columns = Eigen::Matrix<double, Rows, 6>;
    Eigen::Matrix<Index, Rows, 1> rows(3 * static_cast<Index>(touches.size()));
    for (Index r = 0; r < rows.size(); ++r) rows[r] = 3 * touches[static_cast<std::size_t>(r / 3)] + r % 3;
    const Columns B = by_base_(rows, Eigen::all), both = of_both_(rows, Eigen::all);
    const Square numbers = of_numbers_(rows, rows);
    const Eigen::LLT<Square> V(by_numbers_(rows, rows) + Square::Identity(rows.size(), rows.size()));
    const Columns A = V.solve(B);
    const Eigen::LDLT<Matrix6> F(prior_ + B.transpose() * A);
    if (F.vectorD().minCoeff() <= 1e-12 * F.vectorD().maxCoeff()) return kNowhere;
    const Matrix6 crossed = both.transpose() * A;
    const Matrix6 by_base = base_work_ - crossed - crossed.transpose() + A.transpose() * numbers * A;
    return F.solve(by_base).trace() + numbers_variance_ - V.solve(numbers).trace();
  }

 private:
  Matrix6 prior_, base_work_;
  double numbers_variance_ = 0;  ///< of the tip, by numbers of which nothing is told
  MatrixXd by_base_;             ///< B of all candidates
  MatrixXd by_numbers_;          ///< Z Z^T
  MatrixXd of_numbers_;          ///< Z W Z^T, W the mean of U^T U over the work
  MatrixXd of_both_;             ///< Z times the mean of U^T T
};

struct BestSet {
  std::vector<int> touches;
  double variance = kNowhere;
};

/// The best triple whose first is `i`.
BestSet bestTripleFrom(int i, const TouchSets& sets) {
  BestSet best;
  for (int j = i + 1; j < sets.count(); ++j)
    for (int k = j + 1; k < sets.count(); ++k)
      if (const double v = sets.variance<9>(std::array{i, j, k}); v < best.variance) best = {{i, j, k}, v};
  return best;
}

BestSet bestTriple(const TouchSets& sets) {
  std::vector<BestSet> best(static_cast<std::size_t>(sets.count()));
  tbb::parallel_for(0, sets.count(), [&](int i) { best[static_cast<std::size_t>(i)] = bestTripleFrom(i, sets); });
  return *std::ranges::min_element(best, {}, &BestSet::variance);
}

/// The set with the one more touch that helps most.
BestSet withNext(const BestSet& before, const TouchSets& sets) {
  BestSet best = before;
  best.variance = kNowhere;
  std::vector<int> touches = before.touches;
  touches.push_back(0);
  for (int& i = touches.back(); i < sets.count(); ++i) {
    if (std::ranges::count(touches, i) > 1) continue;
    if (const double v = sets.variance<Eigen::Dynamic>(touches); v < best.variance) best = {touches, v};
  }
  return best;
}

/// Whitened slopes by the base of a touch of no load, and what the tip's are in the postures of the work.
DesignProblem exactProblem(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB,
                           const std::vector<TouchPlan>& candidates, const std::vector<Eigen::VectorXd>& work,
                           double sigma) {
  DesignProblem problem;
  problem.information = Matrix6::Zero();
  for (const auto& candidate : candidates) {
    const Prediction tip = predictTip(arm, X_WB, candidate.q_start, 0);
    const Eigen::Matrix3d noise = sigma * sigma * Eigen::Matrix3d::Identity() + encoderCovariance(arm, tip.by_joints);
    problem.candidates.emplace_back(noise.llt().matrixL().solve(tip.by_base));
  }
  for (const auto& q : work) problem.work.emplace_back(predictTip(arm, X_WB, q, 0).by_base);
  return problem;
}

}  // namespace

TouchChoice chooseTouches(const DesignProblem& problem, int count) {
  TouchChoice result;
  const int n = static_cast<int>(problem.candidates.size());
  if (n < count || count < 3) {
    result.status = TouchChoiceStatus::kTooFewCandidates;
    result.reason =
        std::to_string(n) + " holes can be touched, " + std::to_string(count) + " (at least 3) are asked for";
    return result;
  }
  const TouchSets sets(problem);
  BestSet best = bestTriple(sets);
  while (std::isfinite(best.variance) && static_cast<int>(best.touches.size()) < count) best = withNext(best, sets);
  result.chosen = best.touches;
  result.mean_sigma = std::sqrt(best.variance);
  result.status = TouchChoiceStatus::kDone;
  return result;
}

TouchChoice chooseTouches(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB,
                          const std::vector<TouchPlan>& candidates, const std::vector<Eigen::VectorXd>& work,
                          const TouchChoiceOptions& options) {
  return chooseTouches(exactProblem(arm, X_WB, candidates, work, options.sigma), options.count);
}

}  // namespace tubeplan::calibration
