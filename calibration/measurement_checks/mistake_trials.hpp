// Readings as they are, or as one mistake would have them, fitted three ways: by the drawing with the tip as drawn,
// with the tip free, and with all that the drawing leaves open.
#pragma once

#include <limits>
#include <set>
#include <string>
#include <vector>

#include "calibration/measurement_checks/measurement_checks.hpp"
#include "calibration/measurement_checks/robust_fit.hpp"

namespace tubeplan::calibration {

inline constexpr double kFarTurn = 0.35;   ///< rad, of the base from its nominal place
inline constexpr double kFarShift = 0.25;  ///< of the arm's reach, the same

/// Of the readings as they are or as one mistake would have them.
/// `error` is by the drawing, base and tip free; the lack of fit counts the base's prior.
struct Trial : RobustFit {
  double held_error = std::numeric_limits<double>::infinity();  // m, the same with the tip as drawn
  double open_error = std::numeric_limits<double>::infinity();  // m, with all that the drawing leaves open
  double base_shift = 0, base_turn = 0;                         // of the base from its nominal place; the largest
  double extent = 0;                                            // m, of predicted tips that touched unknown points
};

enum class TrialDepth {
  kHeld,   ///< the base where it is not known
  kDrawn,  ///< and the tip
  kOpen,   ///< and all that the drawing leaves open
};

/// The drawn readings with their neighbours, for mistakes of the order; ids say which are counted.
struct ReadingPool {
  std::vector<Measurement> readings;
  std::set<std::string> counted, counted_quickly;
};

/// Both `checked` and `options` must outlive the trials.
class MistakeTrials {
 public:
  MistakeTrials(const CheckedReadings& checked, const CheckOptions& options);

  /// The readings as they are; its errors are those of all three depths.
  [[nodiscard]] const Trial& asIs() const { return as_is_; }
  [[nodiscard]] Trial tried(const Mend& mend, TrialDepth depth) const;
  /// By the drawing, some joints' zeros free besides.
  [[nodiscard]] RobustFit fitZeros(const Mend& mend, PlacedArm start, const std::vector<std::string>& zeros) const;
  /// The cell's, its base as far known as the mistake leaves it.
  [[nodiscard]] PlacedArm startOf(const Mend& mend) const;
  /// The readings that count, as a mistake would have them; fewer of them but for the deepest trial.
  [[nodiscard]] std::vector<Measurement> mended(const Mend& mend, TrialDepth depth) const;
  /// The readings that count as they are, by an arm of another drawing, base and tip free.
  [[nodiscard]] Trial triedBy(PlacedArm drawing) const;
  /// All that the drawing leaves open.
  [[nodiscard]] const FreeChoice& open() const { return open_; }

  /// How many numbers the readings hold beyond those that a fit of that depth finds; none where it may fit anything.
  [[nodiscard]] int freedom(const Mend& mend, TrialDepth depth) const;
  /// Length of the errors that noise alone leaves, as the readings state it [m].
  [[nodiscard]] double noise(const Mend& mend) const;

  /// How much smaller a mistake makes what is touched: above 1 where it draws the tips together.
  [[nodiscard]] double shrinkage(const Trial& trial) const;
  /// By how much less a mistake leaves than the readings as they are; where those cannot be fitted, by a lot.
  [[nodiscard]] double gain(const Trial& trial) const;
  /// Returns true if a trial has the base far from its nominal place. Touches of unknown points alone say nothing of
  /// it.
  [[nodiscard]] bool isBaseFar(const Trial& trial) const;

  [[nodiscard]] const CheckedReadings& checked() const { return checked_; }
  [[nodiscard]] const CheckOptions& options() const { return options_; }
  [[nodiscard]] const ReadingPool& pool() const { return pool_; }
  [[nodiscard]] double reach() const { return reach_; }
  /// Whether any reading states where its point is.
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
