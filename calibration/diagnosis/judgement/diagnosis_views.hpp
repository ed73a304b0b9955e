// Data for plots of a diagnosis: the error at every measurement before and after adding an explanation, and each
// effect's signature against the unexplained errors (added-variable plots: Cook and Weisberg 1982, section 2.3).
#pragma once

#include <Eigen/Core>
#include <vector>

#include "calibration/measurement.hpp"

namespace tubeplan::calibration {

struct Diagnosis;
struct FittedBasis;
struct Explanation;

/// Tip position at a measurement, and the error of the measurement for each model: measured minus predicted, in the
/// world frame; for a distance, along its line.
struct MeasurementView {
  int measurement = -1;    ///< index into the given measurements
  Eigen::Vector3d p_WT;    ///< tip position predicted by the model without added effects, in the world frame [m]
  Eigen::Vector3d before;  ///< error of the model without added effects [m]
  std::vector<Eigen::Vector3d> after;  ///< errors of the models in `explanationsShown` [m]
  /// Magnitude of the error [rad] in the measured components of the tool's rotation; NaN if none is measured.
  double turn_before = kNotKnown;
  std::vector<double> turn_after;
};

/// Point of an added-variable plot: one whitened coordinate, without the component that the free parameters can absorb
/// [noise sigmas].
struct AddedVariablePoint {
  int measurement = -1;
  double signature = 0;  ///< change due to the effect at its fitted size
  double residual = 0;   ///< residual of the model without the effect
};

/// Signature of one effect of an explanation, against the residuals that remain with the explanation's other effects
/// free.
struct AddedVariable {
  int explanation = -1, effect = -1;  ///< index into `explanationsShown`; index into the effects of this explanation
  double slope = kNotKnown;           ///< slope of `residual` against `signature`; near 1 if the size is correct
  double length = 0;                  ///< length of the signature [noise sigmas]
  double kept_fraction = 0;           ///< fraction of the signature's length that the free parameters do not absorb
  /// Points of whole measurements; if there are too many points, evenly spaced measurements are kept.
  std::vector<AddedVariablePoint> points;
};

struct DiagnosisViews {
  std::vector<MeasurementView> measurements;  ///< one entry for each fitted measurement
  std::vector<AddedVariable> added;
};

/// Returns at most four explanations to show, best first: the explanations that the verdict names, or the closest
/// models if it names none.
[[nodiscard]] std::vector<Explanation> explanationsShown(const Diagnosis& result);

/// Computes the plot data of a diagnosis with a verdict. `measurements` are all given measurements; `basis` holds the
/// fitted ones.
[[nodiscard]] DiagnosisViews viewsOf(const FittedBasis& basis, const Diagnosis& result,
                                     const std::vector<Measurement>& measurements, int most_points = 2000);

}  // namespace tubeplan::calibration
