#include "calibration/design/optimal_design.hpp"

#include <tbb/parallel_for.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

#include "calibration/random_stream.hpp"

namespace tubeplan::calibration {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

namespace {

constexpr double kWorthSwapping = 1e-9;  // of what is gained, relative to the score: less is rounding

MatrixXd inverseOf(const MatrixXd& information) {
  return information.selfadjointView<Eigen::Lower>().ldlt().solve(
      MatrixXd::Identity(information.rows(), information.cols()));
}

/// Variance of the tip, summed over its coordinates, at each work posture.
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

/// A choice under way, and what one more reading H would make of it, by the rank of its rows alone:
/// det(M + H^T H) = det M det S and (M + H^T H)^-1 = C - C H^T S^-1 H C, with C = M^-1 and S = I + H C H^T.
class Choice {
 public:
  static constexpr int kVacant = -1;

  Choice(const DesignProblem& problem, Optimality optimality)
      : problem_(problem), optimality_(optimality), is_chosen_(problem.candidates.size(), false) {
    update();
  }

  [[nodiscard]] const std::vector<int>& chosen() const { return chosen_; }
  [[nodiscard]] const MatrixXd& covariance() const { return covariance_; }

  void add(int candidate) {
    chosen_.push_back(kVacant);
    put(chosen_.size() - 1, candidate);
  }

  /// Takes the reading at a place out and puts another there, or none.
  void put(std::size_t place, int candidate) {
    if (chosen_[place] != kVacant) is_chosen_[static_cast<std::size_t>(chosen_[place])] = false;
    chosen_[place] = candidate;
    if (candidate != kVacant) is_chosen_[static_cast<std::size_t>(candidate)] = true;
    update();
  }

  /// The score with the candidate added: less is better; log det is negated.
  [[nodiscard]] double scoreWith(int candidate) const {
    const MatrixXd& H = problem_.candidates[static_cast<std::size_t>(candidate)];
    const MatrixXd CHt = covariance_ * H.transpose();
    const Eigen::LLT<MatrixXd> S(MatrixXd::Identity(H.rows(), H.rows()) + H * CHt);
    const MatrixXd L = S.matrixL();
    if (optimality_ == Optimality::kDeterminant) return -2 * L.diagonal().array().log().sum();
    // Each column of `fall` is one coordinate of one work posture.
    const MatrixXd fall = S.matrixL().solve((stacked_work_ * CHt).transpose());
    VectorXd variances = variances_;
    for (Index w = 0; w < variances.size(); ++w) variances[w] -= fall.middleCols(3 * w, 3).squaredNorm();
    return optimality_ == Optimality::kWorstTip ? variances.maxCoeff() : variances.mean();
  }

  /// The score as it is, of the tip's variance.
  [[nodiscard]] double score() const {
    return optimality_ == Optimality::kWorstTip ? variances_.maxCoeff() : variances_.mean();
  }

  /// The best of the candidates that are not chosen and that `among`, where given, names; none: vacant.
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
  MatrixXd covariance_, stacked_work_;
  VectorXd variances_;
};

/// Swaps chosen readings for better ones, one at a time, until a whole pass finds none. Returns the number of swaps.
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

/// Greedy choice and exchange. For the tip's variance both also start from the choice that is best in all: the worst
/// place alone leads a greedy choice astray.
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

/// What one more reading did to the covariance.
DesignStep designStep(int candidate, const DesignProblem& problem, const MatrixXd& before, const MatrixXd& after) {
  DesignStep step;
  step.candidate = candidate;
  const MatrixXd& H = problem.candidates[static_cast<std::size_t>(candidate)];
  const Eigen::LLT<MatrixXd> S(MatrixXd::Identity(H.rows(), H.rows()) + H * before * H.transpose());
  const MatrixXd L = S.matrixL();
  step.bits = L.diagonal().array().log2().sum();
  step.tip = tipSigma(problem.work, after);
  const VectorXd ratio = (after.diagonal().array() / before.diagonal().array()).sqrt();
  Index most = 0;
  step.helped_by = ratio.minCoeff(&most);
  step.most_helped = static_cast<int>(most);
  return step;
}

void take(Choice& choice, int candidate, const DesignProblem& problem, Design& design) {
  const MatrixXd before = choice.covariance();
  choice.add(candidate);
  design.steps.push_back(designStep(candidate, problem, before, choice.covariance()));
}

}  // namespace

TipSigma tipSigma(const std::vector<MatrixXd>& work, const MatrixXd& covariance) {
  return sigmaOf(tipVariances(work, covariance));
}

Design chooseReadings(const DesignProblem& problem, const DesignOptions& options) {
  assert(!problem.work.empty() || options.optimality == Optimality::kDeterminant);
  Design design;
  const int n = static_cast<int>(problem.candidates.size());
  if (n < options.count || options.count < 1) {
    design.status = DesignStatus::kTooFewCandidates;
    design.reason = std::to_string(n) + " readings can be made, " + std::to_string(options.count) + " are asked for";
    return design;
  }
  const std::vector<int> chosen = bestChoice(problem, options, design.swaps);
  Choice ordered(problem, options.optimality);
  for (int k = 0; k < options.count; ++k) take(ordered, ordered.best(&chosen).candidate, problem, design);
  design.covariance = ordered.covariance();
  design.status = DesignStatus::kDone;
  return design;
}

Design judgeReadings(const DesignProblem& problem, const std::vector<int>& chosen) {
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
