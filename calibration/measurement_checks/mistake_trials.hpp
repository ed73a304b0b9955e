// Fits of the measurements, as stated or as corrected for one mistake, at three depths: with arm and tip as drawn, with
// the arm as drawn and the tip free, and with all parameters free that the drawing leaves open.
#pragma once

#include <limits>
#include <set>
#include <string>
#include <vector>

#include "calibration/measurement_checks/measurement_checks.hpp"
#include "calibration/measurement_checks/robust_fit.hpp"

namespace tubeplan::calibration {

/// A base rotated by more than this from its nominal pose is considered far from nominal [rad].
inline constexpr double kFarTurn = 0.35;
/// A base shifted by more than this fraction of the arm's reach is considered far from nominal.
inline constexpr double kFarShift = 0.25;
/// Chi-square per degree of freedom below which the measurements agree more than five times better than their stated
/// noise allows, so that the stated noise is wrong.
inline constexpr double kFarBelowNoise = 1. / 30;

/// Fit of the measurements, as stated or as corrected for one mistake. The lack of fit includes the base's prior. For
/// the measurements as stated, `error` is computed with the arm as drawn, and base and tip free.
struct Trial : RobustFit {
  double held_error = std::numeric_limits<double>::infinity();  // error with the base free and the nominal tip [m]
  double open_error = std::numeric_limits<double>::infinity();  // error with all open parameters free [m]
  double base_shift = 0, base_turn = 0;  // largest displacement of the base from its nominal place [m, rad]
  double extent = 0;  // root-mean-square spread of the predicted tips that touched unknown points [m]
};

enum class TrialDepth {
  kHeld,   ///< only the base free, if it is unknown
  kDrawn,  ///< base and tip free
  kOpen,   ///< all parameters free that the drawing leaves open
};

/// Randomly drawn measurements together with their neighbours, which are needed to correct mistakes in the order of
/// rows. `counted` and `counted_quickly` are the ids of the drawn measurements that are used in full fits and in quick
/// fits.
struct MeasurementPool {
  std::vector<Measurement> measurements;
  std::set<std::string> counted, counted_quickly;
};

/// Fits the measurements, as stated and as corrected, at several depths. Both `checked` and `options` must outlive the
/// object.
class MistakeTrials {
 public:
  MistakeTrials(const CheckedMeasurements& checked, const CheckOptions& options);

  /// Returns the fit of the measurements as stated, with the errors at all three depths.
  [[nodiscard]] const Trial& asIs() const { return as_is_; }
  [[nodiscard]] Trial tried(const Correction& correction, TrialDepth depth) const;
  /// Fits the corrected measurements to the arm as drawn, with the joint offsets named in `zeros` free as well.
  [[nodiscard]] RobustFit fitZeros(const Correction& correction, PlacedArm start,
                                   const std::vector<std::string>& zeros) const;
  /// Returns the cell's arm; its base poses are treated as unknown if the mistake frees the base, and a new set-up is
  /// added if the mistake begins one.
  [[nodiscard]] PlacedArm startOf(const Correction& correction) const;
  /// Returns the measurements that are included in the fit, with the given mistake corrected. At depths other than
  /// kOpen, only the subset for quick fits is returned.
  [[nodiscard]] std::vector<Measurement> corrected(const Correction& correction, TrialDepth depth) const;
  /// Fits the measurements as stated to the arm of another drawing, with base and tip free.
  [[nodiscard]] Trial triedBy(PlacedArm drawing) const;
  /// Fits the measurements as stated to the arm with one more effect, whose magnitudes are free within their priors.
  [[nodiscard]] Trial triedWith(const deflection::Effect& effect, TrialDepth depth) const;
  /// Returns the names of all parameters that the drawing leaves open.
  [[nodiscard]] const FreeChoice& open() const { return open_; }

  /// Returns the number of measured values minus the number of parameters that a fit of this depth determines. If the
  /// difference is not positive, the fit can reproduce any measurements.
  [[nodiscard]] int freedom(const Correction& correction, TrialDepth depth) const;
  /// Returns the root-mean-square length of the errors that the stated noise alone causes [m].
  [[nodiscard]] double noise(const Correction& correction) const;

  /// Returns the factor by which a mistake's correction contracts the spread of the tips that touched unknown points;
  /// at least 1.
  [[nodiscard]] double shrinkage(const Trial& trial) const;
  /// Returns the factor by which a mistake's correction contracts the measured positions; at least 1.
  [[nodiscard]] double contraction(const Correction& correction) const;
  /// Returns by how much the correction of a mistake decreases the lack of fit, without the part that is due to
  /// contracted tips; very large if the measurements as stated cannot be fitted.
  [[nodiscard]] double gain(const Trial& trial) const;
  /// Returns true if the base of a trial is far from its nominal place. Returns false if there are only touches of
  /// unknown points, which give no information on the base.
  [[nodiscard]] bool isBaseFar(const Trial& trial) const;

  [[nodiscard]] const CheckedMeasurements& checked() const { return checked_; }
  [[nodiscard]] const CheckOptions& options() const { return options_; }
  [[nodiscard]] const MeasurementPool& pool() const { return pool_; }
  [[nodiscard]] double reach() const { return reach_; }
  /// Returns true if at least one measurement states the position of the tip.
  [[nodiscard]] bool hasPlaces() const { return has_places_; }

 private:
  [[nodiscard]] RobustFit fit(PlacedArm start, const std::vector<Measurement>& measurements, TrialDepth depth,
                              const FreeChoice& free) const;
  [[nodiscard]] const FreeChoice& freeAt(TrialDepth depth) const;
  [[nodiscard]] Trial judged(const RobustFit& fit, const PlacedArm& nominal,
                             const std::vector<Measurement>& measurements) const;
  [[nodiscard]] Trial triedPerSetup(TrialDepth depth) const;

  const CheckedMeasurements& checked_;
  const CheckOptions& options_;
  MeasurementPool pool_;
  FreeChoice open_, drawn_, held_;
  double reach_;
  bool has_places_;
  Trial as_is_;
};

}  // namespace tubeplan::calibration
