// Fits of the readings, as stated or corrected for one mistake, at three depths: by the drawing with the tip as drawn,
// with the tip free, and with all that the drawing leaves open.
#pragma once

#include <limits>
#include <set>
#include <string>
#include <vector>

#include "calibration/measurement_checks/measurement_checks.hpp"
#include "calibration/measurement_checks/robust_fit.hpp"

namespace tubeplan::calibration {

/// Least rotation of the base from its nominal place that counts as far [rad].
inline constexpr double kFarTurn = 0.35;
/// Least shift of the base that counts as far, as a share of the arm's reach.
inline constexpr double kFarShift = 0.25;

/// Fit of the readings, as stated or corrected for one mistake. `error` is by the drawing with base and tip free; the
/// lack of fit includes the base's prior.
struct Trial : RobustFit {
  double held_error = std::numeric_limits<double>::infinity();  // error with the tip as drawn [m]
  double open_error = std::numeric_limits<double>::infinity();  // error with all that the drawing leaves open [m]
  double base_shift = 0, base_turn = 0;  // largest displacement of the base from its nominal place [m, rad]
  double extent = 0;                     // spread of the predicted tips that touched unknown points [m]
};

enum class TrialDepth {
  kHeld,   ///< base free if it is unknown
  kDrawn,  ///< tip free as well
  kOpen,   ///< all that the drawing leaves open free as well
};

/// Drawn readings with their neighbours, for mistakes of the order; the ids name those that are counted.
struct ReadingPool {
  std::vector<Measurement> readings;
  std::set<std::string> counted, counted_quickly;
};

/// Fits of corrected readings. Both `checked` and `options` must outlive the object.
class MistakeTrials {
 public:
  MistakeTrials(const CheckedReadings& checked, const CheckOptions& options);

  /// Returns the fit of the readings as stated, with the errors at all three depths.
  [[nodiscard]] const Trial& asIs() const { return as_is_; }
  [[nodiscard]] Trial tried(const Mend& mend, TrialDepth depth) const;
  /// Returns the fit by the drawing with some joints' zeros free as well.
  [[nodiscard]] RobustFit fitZeros(const Mend& mend, PlacedArm start, const std::vector<std::string>& zeros) const;
  /// Returns the cell's arm, with its base as known as the mistake leaves it.
  [[nodiscard]] PlacedArm startOf(const Mend& mend) const;
  /// Returns the counted readings, corrected for a mistake; fewer of them except at the greatest depth.
  [[nodiscard]] std::vector<Measurement> mended(const Mend& mend, TrialDepth depth) const;
  /// Returns the fit of the readings as stated by an arm of another drawing, with base and tip free.
  [[nodiscard]] Trial triedBy(PlacedArm drawing) const;
  /// Returns the names of all that the drawing leaves open.
  [[nodiscard]] const FreeChoice& open() const { return open_; }

  /// Returns the excess of numbers in the readings over those that a fit of this depth determines; not positive if it
  /// may fit anything.
  [[nodiscard]] int freedom(const Mend& mend, TrialDepth depth) const;
  /// Returns the length of the errors by the stated noise alone [m].
  [[nodiscard]] double noise(const Mend& mend) const;

  /// Returns the ratio by which a mistake contracts the touched tips; above 1 if they are closer together.
  [[nodiscard]] double shrinkage(const Trial& trial) const;
  /// Returns the fall of the lack of fit by a mistake, without the part due to contracted tips; large if the readings
  /// as stated cannot be fitted.
  [[nodiscard]] double gain(const Trial& trial) const;
  /// Returns true if a trial has the base far from its nominal place. Touches of unknown points alone give no
  /// information on it.
  [[nodiscard]] bool isBaseFar(const Trial& trial) const;

  [[nodiscard]] const CheckedReadings& checked() const { return checked_; }
  [[nodiscard]] const CheckOptions& options() const { return options_; }
  [[nodiscard]] const ReadingPool& pool() const { return pool_; }
  [[nodiscard]] double reach() const { return reach_; }
  /// Returns true if any reading states the position of its point.
  [[nodiscard]] bool hasPlaces() const { return has_places_; }

 private:
  [[nodiscard]] RobustFit fit(PlacedArm start, const std::vector<Measurement>& readings, TrialDepth depth,
                              const std::vector<std::string>& zeros = {}) const;
  [[nodiscard]] const FreeChoice& freeAt(TrialDepth depth) const;
  [[nodiscard]] Trial judged(const RobustFit& fit, const PlacedArm& nominal,
                             const std::vector<Measurement>& readings) const;
  [[nodiscard]] Trial triedApart(TrialDepth depth) const;

  const CheckedReadings& checked_;
  const CheckOptions& options_;
  ReadingPool pool_;
  FreeChoice open_, drawn_, held_;
  double reach_;
  bool has_places_;
  Trial as_is_;
};

}  // namespace tubeplan::calibration
