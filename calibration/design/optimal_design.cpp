#include "calibration/design/optimal_design.hpp"

#include <tbb/parallel_for.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <numeric>

#include "calibration/random_stream.hpp"

namespace tubeplan::calibration {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

namespace {

constexpr double kWorthSwapping = 1e-9;  // a swap is made only if it improves the score by more than this fraction

MatrixXd inverseOf(const MatrixXd& information) {
  return information.selfadjointView<Eigen::Lower>().ldlt().solve(
      MatrixXd::Identity(information.rows(), information.cols()));
}

/// Returns, for each work posture, the sum of the variances of the three tip coordinates [m^2].
VectorXd tipVariances(const std::vector<MatrixXd>& work, const MatrixXd& covariance) {
  VectorXd variances(static_cast<Index>(work.size()));
  for (std::size_t w = 0; w < work.size(); ++w)
    variances[static_cast<Index>(w)] = (work[w] * covariance).cwiseProduct(work[w]).sum();
  return variances;
}

TipSigma sigmaOf(const VectorXd& variances) {
  if (variances.size() == 0) return {};
  return {std::sqrt(variances.mean() / 3), std::sqrt(variances.maxCoeff() / 3)};
}

/// Returns ln det(I + H C H^T). I + H C H^T is the covariance of a whitened measurement with Jacobian H: the sum of its
/// noise and of the effect of the variables' covariance C.
double logDetOf(const MatrixXd& H, const MatrixXd& covariance) {
  const Eigen::LLT<MatrixXd> S(MatrixXd::Identity(H.rows(), H.rows()) + H * covariance * H.transpose());
  const MatrixXd L = S.matrixL();
  return 2 * L.diagonal().array().log().sum();
}

/// Returns the mean of J^T J over the work postures; the trace of its product with the covariance is the mean variance
/// of the tip.
MatrixXd meanOfSquares(const std::vector<MatrixXd>& work, Index variables) {
  MatrixXd mean = MatrixXd::Zero(variables, variables);
  for (const auto& J : work) mean += J.transpose() * J / static_cast<double>(work.size());
  return mean;
}

/// Incrementally built set of chosen measurements. Adding a measurement with Jacobian H to the information matrix M
/// requires only the inverse of a small matrix S, with one row for each row of H: (M + H^T H)^-1 = C - C H^T S^-1 H C,
/// with C = M^-1 and S = I + H C H^T. The determinant of C is thereby divided by det S. The determinant of C without
/// the rows and columns of the nuisance variables b is divided by det S / det S_b. S_b = I + H_b M_bb^-1 H_b^T is the
/// matrix S if all variables other than b are known.
class Choice {
 public:
  static constexpr int kVacant = -1;

  Choice(const DesignProblem& problem, Optimality optimality)
      : problem_(problem), optimality_(optimality), is_chosen_(problem.candidates.size(), false) {
    mean_work_ = meanOfSquares(problem.work, problem.information.cols());
    update();
  }

  [[nodiscard]] const std::vector<int>& chosen() const { return chosen_; }
  [[nodiscard]] const MatrixXd& covariance() const { return covariance_; }

  void add(int candidate) {
    chosen_.push_back(kVacant);
    put(chosen_.size() - 1, candidate);
  }

  /// Replaces the chosen measurement at index `place` by `candidate`; kVacant removes it without replacement.
  void put(std::size_t place, int candidate) {
    if (chosen_[place] != kVacant) is_chosen_[static_cast<std::size_t>(chosen_[place])] = false;
    chosen_[place] = candidate;
    if (candidate != kVacant) is_chosen_[static_cast<std::size_t>(candidate)] = true;
    update();
  }

  /// Returns the increase in the log determinant of the information matrix due to the candidate, with the nuisance
  /// variables eliminated.
  [[nodiscard]] double gainOf(int candidate) const {
    const MatrixXd& H = problem_.candidates[static_cast<std::size_t>(candidate)];
    const double all = logDetOf(H, covariance_);
    return problem_.nuisance_count == 0 ? all
                                        : all - logDetOf(H.rightCols(problem_.nuisance_count), nuisance_covariance_);
  }

  /// Returns the score of the choice with the candidate added; a lower score is better. For kDeterminant, it is
  /// -gainOf(candidate).
  [[nodiscard]] double scoreWith(int candidate) const {
    if (optimality_ == Optimality::kDeterminant) return -gainOf(candidate);
    const MatrixXd& H = problem_.candidates[static_cast<std::size_t>(candidate)];
    const MatrixXd CHt = covariance_ * H.transpose();
    const Eigen::LLT<MatrixXd> S(MatrixXd::Identity(H.rows(), H.rows()) + H * CHt);
    if (optimality_ == Optimality::kMeanTip)
      return variances_.mean() - S.solve(CHt.transpose() * (mean_work_ * CHt)).trace();
    // The squared length of each column is the decrease in variance of one tip coordinate at one work posture.
    const MatrixXd fall = S.matrixL().solve((stacked_work_ * CHt).transpose());
    VectorXd variances = variances_;
    for (Index w = 0; w < variances.size(); ++w) variances[w] -= fall.middleCols(3 * w, 3).squaredNorm();
    return variances.maxCoeff();
  }

  /// Returns the score of the current choice for a tip criterion (kWorstTip or kMeanTip).
  [[nodiscard]] double score() const {
    return optimality_ == Optimality::kWorstTip ? variances_.maxCoeff() : variances_.mean();
  }

  /// The unchosen candidate with the best score, and its score; kVacant if there is none. If `among` is given, only
  /// those candidates are considered.
  struct Best {
    int candidate = kVacant;
    double score = std::numeric_limits<double>::infinity();
  };
  [[nodiscard]] Best best(const std::vector<int>* among = nullptr) const {
    std::vector<double> scores(problem_.candidates.size(), std::numeric_limits<double>::infinity());
    tbb::parallel_for(std::size_t{0}, among ? among->size() : scores.size(), [&](std::size_t i) {
      const std::size_t k = among ? static_cast<std::size_t>((*among)[i]) : i;
      if (!is_chosen_[k]) scores[k] = scoreWith(static_cast<int>(k));
    });
    const auto least = std::min_element(scores.begin(), scores.end());
    if (least == scores.end() || !std::isfinite(*least)) return {};
    return {static_cast<int>(least - scores.begin()), *least};
  }

 private:
  void update() {
    MatrixXd information = problem_.information;
    for (const int k : chosen_) {
      if (k == kVacant) continue;
      const MatrixXd& H = problem_.candidates[static_cast<std::size_t>(k)];
      information += H.transpose() * H;
    }
    covariance_ = inverseOf(information);
    if (problem_.nuisance_count > 0)
      nuisance_covariance_ = inverseOf(information.bottomRightCorner(problem_.nuisance_count, problem_.nuisance_count));
    variances_ = tipVariances(problem_.work, covariance_);
    if (stacked_work_.size()) return;
    stacked_work_.resize(3 * static_cast<Index>(problem_.work.size()), information.cols());
    for (std::size_t w = 0; w < problem_.work.size(); ++w)
      stacked_work_.middleRows(3 * static_cast<Index>(w), 3) = problem_.work[w];
  }

  const DesignProblem& problem_;
  Optimality optimality_;
  std::vector<int> chosen_;
  std::vector<bool> is_chosen_;
  MatrixXd covariance_, stacked_work_, mean_work_;
  MatrixXd nuisance_covariance_;  ///< covariance of the nuisance variables if all other variables are known
  VectorXd variances_;
};

/// Replaces chosen measurements one at a time by better ones, until a pass over all of them changes nothing or
/// `most_passes` are done. Returns the number of replacements.
int exchange(Choice& choice, int most_passes) {
  int swaps = 0;
  for (int pass = 0; pass < most_passes; ++pass) {
    const int before = swaps;
    for (std::size_t place = 0; place < choice.chosen().size(); ++place) {
      const int old = choice.chosen()[place];
      choice.put(place, Choice::kVacant);
      const double score = choice.scoreWith(old);
      const auto best = choice.best();
      const bool helps = best.score < score - kWorthSwapping * std::abs(score);
      choice.put(place, helps ? best.candidate : old);
      swaps += helps ? 1 : 0;
    }
    if (swaps == before) break;
  }
  return swaps;
}

/// Returns the best choice found by greedy selection and exchange. For the tip criteria, a greedy choice may be a poor
/// start. The exchange is therefore repeated from the best choice by determinant, and the better result is returned.
std::vector<int> bestChoice(const DesignProblem& problem, const DesignOptions& options, int& swaps) {
  Choice greedy(problem, options.optimality);
  for (int k = 0; k < options.count; ++k) greedy.add(greedy.best().candidate);
  swaps = exchange(greedy, options.most_passes);
  if (options.optimality == Optimality::kDeterminant) return greedy.chosen();
  DesignOptions in_all = options;
  in_all.optimality = Optimality::kDeterminant;
  int other_swaps = 0;
  Choice other(problem, options.optimality);
  for (const int k : bestChoice(problem, in_all, other_swaps)) other.add(k);
  other_swaps = exchange(other, options.most_passes);
  if (other.score() >= greedy.score()) return greedy.chosen();
  swaps = other_swaps;
  return other.chosen();
}

/// Adds a candidate to the choice, and a step that describes its effect to the design.
void take(Choice& choice, int candidate, const DesignProblem& problem, Design& design) {
  DesignStep& step = design.steps.emplace_back();
  step.candidate = candidate;
  step.bits = choice.gainOf(candidate) / (2 * std::numbers::ln2);
  const VectorXd before = choice.covariance().diagonal();
  choice.add(candidate);
  step.tip = tipSigma(problem.work, choice.covariance());
  const VectorXd ratio = (choice.covariance().diagonal().array() / before.array()).sqrt();
  Index most = 0;
  step.helped_by = ratio.head(ratio.size() - problem.nuisance_count).minCoeff(&most);
  step.most_helped = static_cast<int>(most);
}

}  // namespace

TipSigma tipSigma(const std::vector<MatrixXd>& work, const MatrixXd& covariance) {
  return sigmaOf(tipVariances(work, covariance));
}

Design chooseMeasurements(const DesignProblem& problem, const DesignOptions& options) {
  assert(!problem.work.empty() || options.optimality == Optimality::kDeterminant);
  Design design;
  const int n = static_cast<int>(problem.candidates.size());
  if (n < options.count || options.count < 1) {
    design.status = DesignStatus::kTooFewCandidates;
    design.reason =
        std::to_string(n) + " readings can be made, but " + std::to_string(options.count) + " are asked for";
    return design;
  }
  const std::vector<int> chosen = bestChoice(problem, options, design.swaps);
  Choice ordered(problem, options.optimality);
  for (int k = 0; k < options.count; ++k) take(ordered, ordered.best(&chosen).candidate, problem, design);
  design.covariance = ordered.covariance();
  design.status = DesignStatus::kDone;
  return design;
}

Design judgeMeasurements(const DesignProblem& problem, const std::vector<int>& chosen) {
  Design design;
  Choice choice(problem, Optimality::kDeterminant);
  for (const int candidate : chosen) take(choice, candidate, problem, design);
  design.covariance = choice.covariance();
  design.status = DesignStatus::kDone;
  return design;
}

std::vector<std::vector<int>> drawChoices(int candidates, int count, int draws, std::uint64_t seed) {
  assert(count <= candidates);
  RandomStream random(seed);
  std::vector<std::vector<int>> choices;
  for (int d = 0; d < draws; ++d) {
    std::vector<int> all(static_cast<std::size_t>(candidates));
    std::iota(all.begin(), all.end(), 0);
    random.choose(all, static_cast<std::size_t>(count));
    all.resize(static_cast<std::size_t>(count));
    choices.push_back(std::move(all));
  }
  return choices;
}

}  // namespace tubeplan::calibration
