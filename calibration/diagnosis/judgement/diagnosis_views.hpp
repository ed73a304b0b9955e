// What a diagnosis can show for itself: the error at every reading before and after, and each effect's signature beside
// what is left to explain (added-variable plots: Cook and Weisberg 1982, section 2.3).
#pragma once

#include <Eigen/Core>
#include <vector>

#include "calibration/measurement.hpp"

namespace tubeplan::calibration {

struct Diagnosis;
struct FittedBasis;
struct Explanation;

/// Where a reading was taken, and by how much each model misses it: measured less predicted, in the world frame. Of a
/// distance: along its line.
struct ReadingView {
  int reading = -1;                    ///< index into the readings that were given
  Eigen::Vector3d p_WT;                ///< m, the tip by the model without an effect
  Eigen::Vector3d before;              ///< m, by the same
  std::vector<Eigen::Vector3d> after;  ///< m, by each of `explanationsShown`
  /// Length of the error [rad] in what the reading measures of the tool's turn; not numbers where it measures none.
  double turn_before = kNotKnown;
  std::vector<double> turn_after;
};

/// One whitened coordinate, both with what the free numbers can absorb taken off, in noise sigmas.
struct AddedVariablePoint {
  int reading = -1;
  double signature = 0;  ///< what the effect would do to it at the size that was found
  double left = 0;       ///< what the model without it misses there
};

/// An effect of an explanation against what is left to explain once the other effects of that explanation may act too.
struct AddedVariable {
  int explanation = -1, effect = -1;       ///< indices into `explanationsShown` and into its effects
  double slope = kNotKnown;                ///< of `left` by `signature`: near 1 where the size fits
  double length = 0;                       ///< of the signature, in noise sigmas
  double kept_fraction = 0;                ///< of the signature that the free numbers do not absorb
  std::vector<AddedVariablePoint> points;  ///< of whole readings, thinned out evenly above a limit
};

struct DiagnosisViews {
  std::vector<ReadingView> readings;  ///< those that were fitted
  std::vector<AddedVariable> added;
};

/// The explanations that are shown, best first: those that the verdict names, else the closest; at most four.
[[nodiscard]] std::vector<Explanation> explanationsShown(const Diagnosis& result);

/// Views of a diagnosis whose verdict stands. `readings` are those it was given; `basis` holds those of them that were
/// fitted.
[[nodiscard]] DiagnosisViews viewsOf(const FittedBasis& basis, const Diagnosis& result,
                                     const std::vector<Measurement>& readings, int most_points = 2000);

}  // namespace tubeplan::calibration
