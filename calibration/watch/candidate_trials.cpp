#include "calibration/watch/candidate_trials.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

namespace tubeplan::calibration {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

namespace {

constexpr double kSameColumn = 1 - 1e-8;  // cosine above which two columns count as parallel
// A candidate is tried at further starts if its gain at the first is at least this share of the largest, less
// kNearGain.
constexpr double kNearShare = 0.5, kNearGain = 10;
constexpr int kStartSteps = 4;  // largest number of better starts for a trial

NumberBounds boundsOf(const CandidateChange& candidate) {
  const auto count = static_cast<Index>(candidate.numbers.size());
  NumberBounds bounds{VectorXd(count), VectorXd(count)};
  for (Index k = 0; k < count; ++k) {
    bounds.lower[k] = candidate.numbers[static_cast<std::size_t>(k)].lower;
    bounds.upper[k] = candidate.numbers[static_cast<std::size_t>(k)].upper;
  }
  return bounds;
}

}  // namespace

CandidateTrials::CandidateTrials(const RowsAndCandidates& watched, const std::vector<ErrorState>& states, int last)
    : watched_(watched), states_(states), last_(last), tried_(watched.candidates.list.size()) {
  findLeaders();
}

void CandidateTrials::findLeaders() {
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

void CandidateTrials::tryStart(int start, const StopQuestion& stop) {
  for (const ChangeCourse course : kChangeCourses) {
    if (course == ChangeCourse::kRamp && start == last_) continue;  // a ramp of one measurement is a step
    throwIfStopped(stop);
    const ChangeFitter& fitter = fitsAt(start, course);
    Fits fits;
    for (std::size_t c = 0; c < tried_.size(); ++c) {
      if (is_dropped_[leader_[c]]) continue;
      if (auto fit = fitAs(c, fitter, fits)) take(c, std::move(*fit), start, course);
    }
  }
}

void CandidateTrials::dropFarOnes() {
  double most = 0;
  for (const TriedChange& tried : tried_) most = std::max(most, tried.best().gain);
  std::vector<bool> is_near(tried_.size(), false);
  for (std::size_t c = 0; c < tried_.size(); ++c)
    if (tried_[c].best().gain >= kNearShare * most - kNearGain) is_near[leader_[c]] = true;
  for (std::size_t c = 0; c < tried_.size(); ++c) is_dropped_[c] = !is_near[leader_[c]];
}

void CandidateTrials::refineStarts(int first, int last, const StopQuestion& stop) {
  for (std::size_t c = 0; c < tried_.size(); ++c) {
    if (is_dropped_[leader_[c]]) continue;
    for (const ChangeTrial& best : tried_[c].of_course) refineCourse(c, best, first, last, stop);
  }
}

const ChangeFitter& CandidateTrials::fitsAt(int start, ChangeCourse course) {
  const std::pair key{start, course};
  if (const auto known = at_start_.find(key); known != at_start_.end()) return known->second;
  const ErrorState& before = states_[static_cast<std::size_t>(start)];
  const ChangeFitter& fitter =
      at_start_.emplace(key, ChangeFitter(watched_.rows, before, start, last_, course)).first->second;
  if (!unchanged_) unchanged_ = fitter.fit({})->deviance;
  return fitter;
}

std::optional<ChangeFit> CandidateTrials::fitAs(std::size_t c, const ChangeFitter& fitter, Fits& fits) const {
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

VectorXd CandidateTrials::hintFor(std::size_t c) const {
  const ChangeTrial& best = tried_[c].best();
  return best.gain > 0 ? VectorXd(best.fit.numbers / scale_[c]) : VectorXd();
}

void CandidateTrials::take(std::size_t c, ChangeFit fit, int start, ChangeCourse course) {
  ChangeTrial trial;
  trial.gain = *unchanged_ - fit.deviance;
  trial.start = start;
  trial.course = course;
  const MatrixXd L = fit.information.llt().matrixL();
  trial.fit = std::move(fit);
  trial.log_evidence = trial.gain / 2 - L.diagonal().array().log().sum();
  const auto known = tried_[c].log_evidence.try_emplace({start, course}, trial.log_evidence).first;
  known->second = std::max(known->second, trial.log_evidence);
  ChangeTrial& best = tried_[c].of_course[static_cast<std::size_t>(course)];
  if (trial.gain > best.gain) best = std::move(trial);
}

void CandidateTrials::refineCourse(std::size_t c, const ChangeTrial& best, int first, int last,
                                   const StopQuestion& stop) {
  bool is_better = best.gain > 0;
  for (int step = 0; step < kStartSteps && is_better; ++step) {
    throwIfStopped(stop);
    is_better = refineStart(c, best, first, last) || fitAgain(c, best.start, best, {});
  }
}

bool CandidateTrials::refineStart(std::size_t c, const ChangeTrial& best, int first, int last) {
  const auto& columns = watched_.candidates.list[c].columns;
  const int start = fitsAt(best.start, best.course).bestStart(columns, best.fit, first, last);
  if (start == best.start || (best.course == ChangeCourse::kRamp && start == last_)) return false;
  return fitAgain(c, start, best, best.fit.numbers);
}

bool CandidateTrials::fitAgain(std::size_t c, int start, const ChangeTrial& best, const VectorXd& near) {
  const double before = best.gain;
  const ChangeFitter& fitter = fitsAt(start, best.course);
  auto fit = fitter.fit(watched_.candidates.list[c].columns, boundsOf(watched_.candidates.list[c]), near);
  if (fit) take(c, std::move(*fit), start, best.course);
  return best.gain > before;
}

}  // namespace tubeplan::calibration
