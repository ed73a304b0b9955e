#include "calibration/watch/change_judgement.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

#include "calibration/diagnosis/evidence/linear_evidence.hpp"
#include "calibration/statistics.hpp"
#include "calibration/watch/candidate_trials.hpp"

namespace tubeplan::calibration {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

namespace {

constexpr double kOutdone = 0.05;  // probability that the true change is left out because another fits better by chance
constexpr double kNoMoreThanNoise = 0.001;  // probability by chance at which a candidate leaves more than noise
constexpr double kCountsExcess = 3.1;       // limit of ChangeFit::counts_excess, in standard deviations
constexpr double kUnlearned = 0.5;  // posterior-to-prior sigma ratio above which a number counts as undetermined
constexpr int kEarlier = 40;        // measurements before the first start up to which better starts are sought

/// Returns a number that was fitted as `fitted` [typical]. An effect of a condition that is not stated has its number
/// times the assumed change of the condition, because only this product is known.
AnsweredNumber numberOf(const CandidateChange& of, const ChangeNumber& number, double fitted, double sigma) {
  AnsweredNumber answered{number.name, number.quantity, fitted * number.typical, number.typical, fitted, sigma};
  if (number.unknown) {
    answered.value = valueAt(*number.unknown, answered.value) - valueAt(*number.unknown, 0);
    answered.sigma *= std::abs(slopeAt(*number.unknown, fitted * number.typical));
  }
  answered.sigma *= sigma < kUnlearned ? sigma : std::numeric_limits<double>::infinity();
  if (!of.assumed) return answered;
  answered.name += std::string("*") + deflection::kindOf(*of.assumed).name;
  answered.quantity = deflection::Quantity::kNone;
  answered.value *= of.assumed_change;
  answered.sigma *= of.assumed_change;
  return answered;
}

/// Turns the trials of all candidates into the answers.
class Judge {
 public:
  Judge(const RowsAndCandidates& watched, const std::vector<TriedChange>& tried, int last)
      : watched_(watched), tried_(tried), last_(last) {}

  [[nodiscard]] ChangeJudgement judgement() const {
    ChangeJudgement result;
    result.tried = static_cast<int>(tried_.size());
    if (tried_.front().best().gain > 0) result.base = numbersOf(0, tried_.front().best());
    const auto top = std::ranges::max_element(tried_, {}, [](const TriedChange& t) { return t.best().gain; });
    const ChangeTrial& best = top->best();
    if (!(best.gain > 0)) return result;
    const int freedom = best.fit.measured_rows - static_cast<int>(best.fit.numbers.size());
    if (freedom > 0) result.p_value = chiSquareTail(best.fit.measured_chi2, freedom);
    result.is_explained = result.p_value > kNoMoreThanNoise && best.fit.counts_excess < kCountsExcess;
    if (!result.is_explained) return result;
    for (std::size_t c = 0; c < tried_.size(); ++c) addAnswer(static_cast<int>(c), best, result.answers);
    std::ranges::stable_sort(result.answers, std::greater{}, &ChangeAnswer::probability);
    return result;
  }

 private:
  void addAnswer(int candidate, const ChangeTrial& best, std::vector<ChangeAnswer>& answers) const {
    const TriedChange& tried = tried_[static_cast<std::size_t>(candidate)];
    const CandidateChange& of = watched_.candidates.list[static_cast<std::size_t>(candidate)];
    const auto mayBe = [&](const ChangeTrial& trial) {
      const auto more = std::max<Index>(1, best.fit.numbers.size() - static_cast<Index>(of.numbers.size()));
      const double tail = kOutdone / static_cast<double>(tried_.size());
      return trial.gain > 0 && best.gain - trial.gain <= chiSquareQuantile(tail, static_cast<double>(more));
    };
    ChangeAnswer answer;
    answer.candidate = candidate;
    answer.effect = of.effect;
    answer.at = of.at;
    answer.remedy = of.remedy;
    answer.may_be_step = mayBe(tried.of_course[0]);
    answer.may_be_ramp = mayBe(tried.of_course[1]);
    if (!answer.may_be_step && !answer.may_be_ramp) return;
    const ChangeTrial& trial = tried.best();
    answer.since = trial.start;
    answer.gain = trial.gain;
    answer.probability = probabilityOf(candidate);
    answer.numbers = numbersOf(candidate, trial);
    answer.most_shift = mostShift(of, trial);
    if (of.assumed) answer.assumed = deflection::kindOf(*of.assumed).name;
    answers.push_back(std::move(answer));
  }

  [[nodiscard]] double probabilityOf(int candidate) const {
    double total = -std::numeric_limits<double>::infinity(), own = total;
    for (std::size_t c = 0; c < tried_.size(); ++c)
      for (const auto& [at, log_evidence] : tried_[c].log_evidence) {
        const double log = log_evidence + std::log(watched_.candidates.list[c].prior);
        total = logSum(total, log);
        if (static_cast<int>(c) == candidate) own = logSum(own, log);
      }
    return std::exp(own - total);
  }

  [[nodiscard]] std::vector<AnsweredNumber> numbersOf(int candidate, const ChangeTrial& trial) const {
    const CandidateChange& of = watched_.candidates.list[static_cast<std::size_t>(candidate)];
    const MatrixXd covariance =
        trial.fit.information.llt().solve(MatrixXd::Identity(trial.fit.numbers.size(), trial.fit.numbers.size()));
    std::vector<AnsweredNumber> numbers;
    for (std::size_t k = 0; k < of.numbers.size(); ++k) {
      const auto i = static_cast<Index>(k);
      numbers.push_back(numberOf(of, of.numbers[k], trial.fit.numbers[i], std::sqrt(covariance(i, i))));
    }
    return numbers;
  }

  /// Returns the largest shift of the measured point since the start: of the rows of a measurement, without whitening.
  [[nodiscard]] double mostShift(const CandidateChange& of, const ChangeTrial& trial) const {
    const WatchedRows& rows = watched_.rows;
    double most = 0;
    for (int k = trial.start; k <= last_; ++k) {
      const VectorXd whitened = rows.changes(Eigen::seqN(rows.first(k), rows.rowsOf(k)), of.columns) *
                                trial.fit.numbers * courseAt(trial.course, k, trial.start, last_);
      const MatrixXd& whitener = rows.whitener[static_cast<std::size_t>(k)];
      most = std::max(most, whitener.triangularView<Eigen::Lower>().solve(whitened).norm());
    }
    return most;
  }

  const RowsAndCandidates& watched_;
  const std::vector<TriedChange>& tried_;
  int last_;
};

}  // namespace

ChangeJudgement judgeChange(const RowsAndCandidates& watched, const std::vector<ErrorState>& states,
                            const std::vector<int>& starts, int last, const StopQuestion& stop) {
  CandidateTrials trials(watched, states, last);
  for (const int start : starts) {
    trials.tryStart(start, stop);
    if (watched.rows.hasCounts() && start == starts.front()) trials.dropFarOnes();
  }
  if (watched.rows.hasCounts())
    trials.refineStarts(std::max(0, starts.front() - kEarlier), static_cast<int>(states.size()) - 1, stop);
  return Judge(watched, trials.tried(), last).judgement();
}

}  // namespace tubeplan::calibration
