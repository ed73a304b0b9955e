// One run of a campaign of outages: a true arm is drawn and calibrated by touches, and visits holes in the order of
// nearest postures. In a share of the runs a hidden change begins at one of the visits. The watch reads all visits.
#pragma once

#include <optional>
#include <vector>

#include "app/studies/monte_carlo/centring_trial.hpp"
#include "calibration/hooks.hpp"
#include "calibration/simulation/hidden_changes.hpp"
#include "calibration/watch/change_watch.hpp"

namespace tubeplan::app {

struct OutageOptions {
  CentringOptions centring;    ///< drawn truth, visits and touches of a run; it has one setting
  int touch_every = 50;        ///< every so many visits, the hole is touched instead; 0: never
  double nothing = 0.5;        ///< fraction of the runs without a change
  std::vector<int> changes;    ///< changes that may be hidden, as indices in hiddenChanges(), each alike
  double false_alarms = 0.05;  ///< largest probability of a false alarm that the watch allows
};

/// Numbers of visits of which the steps were counted, and of those in which all steps entered.
struct CountedVisits {
  std::uint64_t visits = 0, all_steps = 0;
};

struct OutageTrial {
  TrialFailure failure = TrialFailure::kNone;  ///< reason why the arm could not be calibrated
  bool is_watched = false;                     ///< true if the watch has judged the visits
  int change = 0;                              ///< hidden change, as an index in hiddenChanges(); 0: none
  bool is_alarm = false;
  bool is_early = false;        ///< the alarm was raised before the change
  std::size_t delay = 0;        ///< number of visits from the change to the alarm, both counted
  bool is_named = false;        ///< the answers contain the true cause with its course
  bool is_only_answer = false;  ///< the true cause is the only answer
  CountedVisits before;         ///< visits before the change
  CountedVisits after;          ///< visits since the change, up to the alarm or to the end
};

class OutageTrials {
 public:
  /// `holes` must have at least as many holes to visit as a run visits.
  OutageTrials(const planner::Workcell& model, const planner::Workcell& truth, const CentringHoles& holes,
               const OutageOptions& options);

  /// Returns the reason if no holes could be chosen to touch, otherwise empty.
  [[nodiscard]] const std::string& problem() const { return trials_.problem(); }

  /// Performs the run with this index, and returns its result; std::nullopt if `stop` has returned true. Thread-safe.
  [[nodiscard]] std::optional<OutageTrial> run(std::uint64_t index, const calibration::StopQuestion& stop) const;

 private:
  /// A visit that the calibrated model steers to, and the hole's unmodelled error.
  struct Visit {
    TrialHole hole;
    Eigen::VectorXd q;
  };
  /// A change that begins at the visit `since`; beyond the last visit if there is none.
  struct Hidden {
    int change = 0;
    std::size_t since = 0;
    calibration::ChangedState changed;
  };
  /// Readings of the visits that succeeded; `since` is the first one after the change.
  struct Readings {
    std::vector<calibration::Measurement> list;
    std::size_t since = 0;
  };

  [[nodiscard]] static std::vector<Visit> visitsInOrder(const CalibratedRun& run);
  [[nodiscard]] Hidden hiddenIn(const CalibratedRun& run, std::uint64_t index, std::size_t visits) const;
  [[nodiscard]] std::optional<calibration::Measurement> read(const Visit& visit, bool is_touch,
                                                             const CalibratedRun& run,
                                                             const calibration::TrueState& now,
                                                             std::uint64_t key) const;
  [[nodiscard]] Readings readings(const std::vector<Visit>& visits, const CalibratedRun& run, std::uint64_t index,
                                  const Hidden& hidden) const;
  [[nodiscard]] CountedVisits counted(const Readings& readings, std::size_t first, std::size_t end) const;
  void judge(const calibration::Watch& watch, const Readings& readings, const deflection::Arm& arm,
             OutageTrial& trial) const;

  OutageOptions options_;
  tubesheets::SteppedTool tool_;
  CentringTrials trials_;
};

}  // namespace tubeplan::app
