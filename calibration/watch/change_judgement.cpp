#include "calibration/watch/change_judgement.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "calibration/diagnosis/evidence/linear_evidence.hpp"
#include "calibration/statistics.hpp"

namespace tubeplan::calibration {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

namespace {

constexpr double kOutdone = 0.05;  // probability that the true change is left out because another fits better by chance
constexpr double kNoMoreThanNoise = 0.001;  // probability by chance at which a candidate leaves more than noise
constexpr double kCountsExcess = 3.1;       // limit of ChangeFit::counts_excess, in standard deviations
constexpr double kUnlearned = 0.5;        // posterior-to-prior sigma ratio above which a number counts as undetermined
constexpr double kSameColumn = 1 - 1e-8;  // cosine above which two columns count as parallel
// A candidate is tried at further starts if its gain at the first is at least this share of the largest, less
// kNearGain.
constexpr double kNearShare = 0.5, kNearGain = 10;
constexpr int kEarlier = 40;    // measurements before the first start up to which better starts are sought
constexpr int kStartSteps = 4;  // largest number of better starts for a trial
constexpr ChangeCourse kCourses[] = {ChangeCourse::kStep, ChangeCourse::kRamp};

struct Trial {
  double gain = 0, log_evidence = 0;
  ChangeFit fit;
  int start = 0;
  ChangeCourse course = ChangeCourse::kStep;
};

/// Best trial of each course of a candidate, and the log of its evidence at each start and course.
struct Tried {
  Trial of_course[std::size(kCourses)];
  std::map<std::pair<int, ChangeCourse>, double> log_evidence;
  [[nodiscard]] const Trial& best() const {
    return of_course[0].gain >= of_course[1].gain ? of_course[0] : of_course[1];
  }
};

NumberBounds boundsOf(const CandidateChange& candidate) {
  const auto count = static_cast<Index>(candidate.numbers.size());
  NumberBounds bounds{VectorXd(count), VectorXd(count)};
  for (Index k = 0; k < count; ++k) {
    bounds.lower[k] = candidate.numbers[static_cast<std::size_t>(k)].lower;
    bounds.upper[k] = candidate.numbers[static_cast<std::size_t>(k)].upper;
  }
  return bounds;
}

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

class Judge {
 public:
  Judge(const RowsAndCandidates& watched, const std::vector<ErrorState>& states, int last)
      : watched_(watched), states_(states), last_(last), tried_(watched.candidates.list.size()) {
    findLeaders();
  }

  void tryStart(int start, const StopQuestion& stop) {
    for (const ChangeCourse course : kCourses) {
      if (course == ChangeCourse::kRamp && start == last_) continue;  // a ramp of one measurement is a step
      throwIfStopped(stop);
      const StartFits& at = fitsAt(start, course);
      Fits fits;
      for (std::size_t c = 0; c < tried_.size(); ++c) {
        if (is_dropped_[leader_[c]]) continue;
        if (auto fit = fitAs(c, at.fitter, fits)) take(c, std::move(*fit), at.unchanged, start, course);
      }
    }
  }

  /// Moves the start of each course of each candidate, from `first` up to `last`, to where its fit at the best start so
  /// far lowers the deviance most, as long as the fit there is better. A count contradicts a start that is off by one.
  void refineStarts(int first, int last, const StopQuestion& stop) {
    for (std::size_t c = 0; c < tried_.size(); ++c) {
      if (is_dropped_[leader_[c]]) continue;
      for (const Trial& best : tried_[c].of_course) refineCourse(c, best, first, last, stop);
    }
  }

  /// Removes the candidates whose gain is far below the best gain so far.
  void dropFarOnes() {
    double most = 0;
    for (const Tried& tried : tried_) most = std::max(most, tried.best().gain);
    std::vector<bool> is_near(tried_.size(), false);
    for (std::size_t c = 0; c < tried_.size(); ++c)
      if (tried_[c].best().gain >= kNearShare * most - kNearGain) is_near[leader_[c]] = true;
    for (std::size_t c = 0; c < tried_.size(); ++c) is_dropped_[c] = !is_near[leader_[c]];
  }

  [[nodiscard]] ChangeJudgement judgement() const {
    ChangeJudgement result;
    result.tried = static_cast<int>(tried_.size());
    if (tried_.front().best().gain > 0) result.base = numbersOf(0, tried_.front().best());
    const auto top = std::ranges::max_element(tried_, {}, [](const Tried& t) { return t.best().gain; });
    const Trial& best = top->best();
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
  /// The fits of changes that begin at one measurement and follow one course, with the deviance without a change.
  struct StartFits {
    ChangeFitter fitter;
    double unchanged;
  };
  const StartFits& fitsAt(int start, ChangeCourse course) {
    const std::pair key{start, course};
    if (const auto known = at_start_.find(key); known != at_start_.end()) return known->second;
    ChangeFitter fitter(watched_.rows, states_[static_cast<std::size_t>(start)], start, last_, course);
    const double unchanged = fitter.fit({})->deviance;
    return at_start_.emplace(key, StartFits{std::move(fitter), unchanged}).first->second;
  }

  void refineCourse(std::size_t c, const Trial& best, int first, int last, const StopQuestion& stop) {
    bool is_better = best.gain > 0;
    for (int step = 0; step < kStartSteps && is_better; ++step) {
      throwIfStopped(stop);
      is_better = refineStart(c, best, first, last) || fitAgain(c, best.start, best, {});
    }
  }

  /// Fits the candidate at a better start than that of its best trial. Returns false if there is none.
  bool refineStart(std::size_t c, const Trial& best, int first, int last) {
    const auto& columns = watched_.candidates.list[c].columns;
    const int start = fitsAt(best.start, best.course).fitter.bestStart(columns, best.fit, first, last);
    if (start == best.start || (best.course == ChangeCourse::kRamp && start == last_)) return false;
    return fitAgain(c, start, best, best.fit.numbers);
  }

  /// Fits the candidate at a start, from `near` or from all start values. Returns true if the fit is better than
  /// `best`.
  bool fitAgain(std::size_t c, int start, const Trial& best, const VectorXd& near) {
    const double before = best.gain;
    const StartFits& at = fitsAt(start, best.course);
    auto fit = at.fitter.fit(watched_.candidates.list[c].columns, boundsOf(watched_.candidates.list[c]), near);
    if (fit) take(c, std::move(*fit), at.unchanged, start, best.course);
    return best.gain > before;
  }

  /// Finds the leader of each candidate: the longest of the columns that are equal up to scale, for which one fit
  /// suffices.
  void findLeaders() {
    const auto& list = watched_.candidates.list;
    const WatchedRows& rows = watched_.rows;
    const MatrixXd columns = rows.changes.topRows(rows.first(last_) + rows.rowsOf(last_));
    is_dropped_.assign(list.size(), false);
    scale_.assign(list.size(), 1);
    for (std::size_t c = 0; c < list.size(); ++c) {
      leader_.push_back(c);
      if (list[c].columns.size() > 1) continue;
      const auto own = columns.col(list[c].columns.front());
      for (std::size_t other = 0; other < list.size(); ++other) {
        if (list[other].columns.size() > 1) continue;
        const auto theirs = columns.col(list[other].columns.front());
        if (std::abs(own.dot(theirs)) < kSameColumn * own.norm() * theirs.norm()) continue;
        if (theirs.norm() <= columns.col(list[leader_[c]].columns.front()).norm()) continue;
        leader_[c] = other;
        scale_[c] = own.dot(theirs) / own.squaredNorm();
      }
    }
  }

  /// Fits, keyed by leader and by one-sided bounds of its numbers: a play, for instance, is never negative.
  using Fits = std::map<std::pair<std::size_t, int>, std::optional<ChangeFit>>;

  /// Returns the fit of a candidate, derived from its leader's by the ratio of their columns; nullopt if no change
  /// within its bounds fits.
  std::optional<ChangeFit> fitAs(std::size_t c, const ChangeFitter& fitter, Fits& fits) const {
    const CandidateChange& candidate = watched_.candidates.list[c];
    NumberBounds bounds = boundsOf(candidate);
    const std::size_t leader = leader_[c];
    int side = 0;
    if (candidate.columns.size() == 1) {
      if (bounds.lower[0] == 0) side = scale_[c] > 0 ? 1 : -1;
      if (bounds.upper[0] == 0) side = scale_[c] > 0 ? -1 : 1;
      bounds.lower[0] = side > 0 ? 0 : -std::numeric_limits<double>::infinity();
      bounds.upper[0] = side < 0 ? 0 : std::numeric_limits<double>::infinity();
    }
    const std::pair key{leader, side};
    if (!fits.contains(key)) fits[key] = fitter.fit(watched_.candidates.list[leader].columns, bounds, hintFor(c));
    std::optional<ChangeFit> fit = fits[key];
    if (fit && leader != c) {
      fit->deviance -= fit->numbers.squaredNorm();
      fit->numbers *= scale_[c];
      fit->deviance += fit->numbers.squaredNorm();
      fit->information.array() = (fit->information.array() - 1) / (scale_[c] * scale_[c]) + 1;
    }
    if (fit && !boundsOf(candidate).contain(fit->numbers)) return std::nullopt;
    return fit;
  }

  /// Returns the start values of a candidate's fit, which are the leader's numbers in its best trial; empty if there is
  /// none.
  [[nodiscard]] VectorXd hintFor(std::size_t c) const {
    const Trial& best = tried_[c].best();
    return best.gain > 0 ? VectorXd(best.fit.numbers / scale_[c]) : VectorXd();
  }

  void take(std::size_t c, ChangeFit fit, double unchanged, int start, ChangeCourse course) {
    Trial trial;
    trial.gain = unchanged - fit.deviance;
    trial.start = start;
    trial.course = course;
    const MatrixXd L = fit.information.llt().matrixL();
    trial.fit = std::move(fit);
    trial.log_evidence = trial.gain / 2 - L.diagonal().array().log().sum();
    const auto known = tried_[c].log_evidence.try_emplace({start, course}, trial.log_evidence).first;
    known->second = std::max(known->second, trial.log_evidence);
    Trial& best = tried_[c].of_course[static_cast<std::size_t>(course)];
    if (trial.gain > best.gain) best = std::move(trial);
  }

  void addAnswer(int candidate, const Trial& best, std::vector<ChangeAnswer>& answers) const {
    const Tried& tried = tried_[static_cast<std::size_t>(candidate)];
    const CandidateChange& of = watched_.candidates.list[static_cast<std::size_t>(candidate)];
    const auto mayBe = [&](const Trial& trial) {
      const auto more = std::max<Index>(1, best.fit.numbers.size() - static_cast<Index>(of.numbers.size()));
      const double tail = kOutdone / static_cast<double>(tried_.size());
      return trial.gain > 0 && best.gain - trial.gain <= chiSquareQuantile(tail, static_cast<double>(more));
    };
    ChangeAnswer answer;
    answer.candidate = candidate;
    answer.effect = of.effect;
    answer.at = of.at;
    answer.remedy = of.remedy;
    // Counts do not tell the courses apart, because what they say of the errors before the start is only approximate.
    const bool tells_course = !watched_.rows.hasCounts();
    answer.may_be_step = mayBe(tells_course ? tried.of_course[0] : tried.best());
    answer.may_be_ramp = mayBe(tells_course ? tried.of_course[1] : tried.best());
    if (!answer.may_be_step && !answer.may_be_ramp) return;
    const Trial& trial = tried.best();
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

  [[nodiscard]] std::vector<AnsweredNumber> numbersOf(int candidate, const Trial& trial) const {
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
  [[nodiscard]] double mostShift(const CandidateChange& of, const Trial& trial) const {
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
  const std::vector<ErrorState>& states_;
  int last_;
  std::vector<Tried> tried_;
  std::vector<std::size_t> leader_;  // index of each candidate's leader, whose fit it shares
  std::vector<double> scale_;        // factor from the leader's number to the candidate's number
  std::vector<bool> is_dropped_;
  std::map<std::pair<int, ChangeCourse>, StartFits> at_start_;
};

}  // namespace

ChangeJudgement judgeChange(const RowsAndCandidates& watched, const std::vector<ErrorState>& states,
                            const std::vector<int>& starts, int last, const StopQuestion& stop) {
  Judge judge(watched, states, last);
  for (const int start : starts) {
    judge.tryStart(start, stop);
    if (watched.rows.hasCounts() && start == starts.front()) judge.dropFarOnes();
  }
  if (watched.rows.hasCounts())
    judge.refineStarts(std::max(0, starts.front() - kEarlier), static_cast<int>(states.size()) - 1, stop);
  return judge.judgement();
}

}  // namespace tubeplan::calibration
