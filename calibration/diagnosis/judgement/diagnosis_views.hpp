// Figures of a diagnosis: the error at every reading before and after, and each effect's signature against the
// unexplained errors (added-variable plots: Cook and Weisberg 1982, section 2.3).
#pragma once

#include <Eigen/Core>
#include <vector>

#include "calibration/measurement.hpp"

namespace tubeplan::calibration {

struct Diagnosis;
struct FittedBasis;
struct Explanation;

/// Place of a reading and its error by each model: measured minus predicted, in the world frame; for a distance, along
/// its line.
struct ReadingView {
  int reading = -1;                    ///< index into the given readings
  Eigen::Vector3d p_WT;                ///< tip by the model without an effect [m]
  Eigen::Vector3d before;              ///< error by that model [m]
  std::vector<Eigen::Vector3d> after;  ///< errors by each of `explanationsShown` [m]
  /// Length of the error [rad] in the measured part of the tool's rotation; NaN if none is measured.
  double turn_before = kNotKnown;
  std::vector<double> turn_after;
};

/// One whitened coordinate, without the part that the free numbers can absorb [noise sigmas].
struct AddedVariablePoint {
  int reading = -1;
  double signature = 0;  ///< change by the effect at the found size
  double left = 0;       ///< error of the model without the effect
};

/// Effect of an explanation against the errors that remain with the explanation's other effects free.
struct AddedVariable {
  int explanation = -1, effect = -1;       ///< indices into `explanationsShown` and into its effects
  double slope = kNotKnown;                ///< slope of `left` by `signature`; near 1 for a correct size
  double length = 0;                       ///< length of the signature [noise sigmas]
  double kept_fraction = 0;                ///< share of the signature that the free numbers do not absorb
  std::vector<AddedVariablePoint> points;  ///< points of whole readings, evenly thinned out above a limit
};

struct DiagnosisViews {
  std::vector<ReadingView> readings;  ///< fitted readings
  std::vector<AddedVariable> added;
};

/// Returns the explanations to show, best first, at most four: those that the verdict names, otherwise the closest.
[[nodiscard]] std::vector<Explanation> explanationsShown(const Diagnosis& result);

/// Computes the views of a diagnosis with a verdict. `readings` are all given ones; `basis` holds the fitted ones among
/// them.
[[nodiscard]] DiagnosisViews viewsOf(const FittedBasis& basis, const Diagnosis& result,
                                     const std::vector<Measurement>& readings, int most_points = 2000);

}  // namespace tubeplan::calibration
