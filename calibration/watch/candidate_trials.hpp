// Fits of every candidate change, as a step and as a ramp, from several starts.
//
// Candidates whose columns are equal up to scale share one fit, that of their leader. With counts, the start is moved
// to where the fit explains the measurements best.
#pragma once

#include <map>
#include <utility>

#include "calibration/watch/change_fit.hpp"

namespace tubeplan::calibration {

inline constexpr ChangeCourse kChangeCourses[] = {ChangeCourse::kStep, ChangeCourse::kRamp};

/// The fit of one candidate at one start with one course.
struct ChangeTrial {
  double gain = 0;  ///< decrease of the deviance against no change
  double log_evidence = 0;
  ChangeFit fit;
  int start = 0;
  ChangeCourse course = ChangeCourse::kStep;
};

/// Best trial of each course of a candidate, and the log of its evidence at each start and course.
struct TriedChange {
  ChangeTrial of_course[std::size(kChangeCourses)];
  std::map<std::pair<int, ChangeCourse>, double> log_evidence;
  [[nodiscard]] const ChangeTrial& best() const {
    return of_course[0].gain >= of_course[1].gain ? of_course[0] : of_course[1];
  }
};

class CandidateTrials {
 public:
  /// Prepares trials judged by the measurements up to `last`; `states` are the filter's states before each measurement.
  CandidateTrials(const RowsAndCandidates& watched, const std::vector<ErrorState>& states, int last);

  /// Fits the candidates that were not dropped to a change that begins at `start`.
  void tryStart(int start, const StopQuestion& stop);

  /// Drops the candidates whose gain is far below the largest gain so far.
  void dropFarOnes();

  /// Moves the start of each course of each candidate, from `first` up to `last`, to where its fit at the best start so
  /// far lowers the deviance most, as long as the fit there is better. A count contradicts a start that is off by one.
  void refineStarts(int first, int last, const StopQuestion& stop);

  /// Returns one result for each candidate, in the order of CandidateChanges::list.
  [[nodiscard]] const std::vector<TriedChange>& tried() const { return tried_; }

 private:
  /// Fits, keyed by leader and by one-sided bounds of its numbers: a play, for instance, is never negative.
  using Fits = std::map<std::pair<std::size_t, int>, std::optional<ChangeFit>>;

  /// Finds the leader of each candidate: the longest of the columns that are equal up to scale, for which one fit
  /// suffices.
  void findLeaders();
  /// Returns the fits of changes that begin at `start` and follow `course`.
  [[nodiscard]] const ChangeFitter& fitsAt(int start, ChangeCourse course);
  /// Returns the fit of a candidate, derived from its leader's by the ratio of their columns; nullopt if no change
  /// within its bounds fits.
  [[nodiscard]] std::optional<ChangeFit> fitAs(std::size_t c, const ChangeFitter& fitter, Fits& fits) const;
  /// Returns the start values of a candidate's fit, which are the leader's numbers in its best trial; empty if there is
  /// none.
  [[nodiscard]] Eigen::VectorXd hintFor(std::size_t c) const;
  /// Keeps the fit as the best trial of its course if its gain is the largest so far.
  void take(std::size_t c, ChangeFit fit, int start, ChangeCourse course);
  void refineCourse(std::size_t c, const ChangeTrial& best, int first, int last, const StopQuestion& stop);
  /// Fits the candidate at a better start than that of its best trial. Returns false if there is none.
  bool refineStart(std::size_t c, const ChangeTrial& best, int first, int last);
  /// Fits the candidate at a start, from `near` or from all start values. Returns true if the fit is better than
  /// `best`.
  bool fitAgain(std::size_t c, int start, const ChangeTrial& best, const Eigen::VectorXd& near);

  const RowsAndCandidates& watched_;
  const std::vector<ErrorState>& states_;
  int last_;
  std::vector<TriedChange> tried_;
  std::vector<std::size_t> leader_;  // index of each candidate's leader, whose fit it shares
  std::vector<double> scale_;        // factor from the leader's number to the candidate's number
  std::vector<bool> is_dropped_;
  std::map<std::pair<int, ChangeCourse>, ChangeFitter> at_start_;
  std::optional<double> unchanged_;  // deviance without a change, by the first fits
};

}  // namespace tubeplan::calibration
