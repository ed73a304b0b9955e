// Unknown model error outside the catalogue: a smooth function of the joints, the direction of motion, the load and the
// stated conditions, modelled as a Gaussian process (Kennedy and O'Hagan 2001, "Bayesian calibration of computer
// models").
//
// The process is a sum of functions with independent normal weights. Each function is an error of one joint's reading,
// a shift of the tip in the tool's frame, or a shift or rotation of the base, multiplied by a smooth function of
// quantities stated by the measurements. These smooth functions are waves and local bumps in a joint's position,
// products of waves for two joints, and functions of load, direction of motion and conditions. The process competes
// with the named causes, but does not identify a cause itself. A measurement that measures a displacement, from another
// measurement or from the unloaded tip, has the difference between the errors at the two postures.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

#include "calibration/estimation/whitened_residual.hpp"

namespace tubeplan::calibration {

/// One term of the Gaussian process: a function with its amplitude.
struct DiscrepancyTerm {
  std::string follows;  ///< variable that the term follows: "theta3", "direction of theta3", "load", "time"
  /// Index of the channel. The channels are, in order: the error of each joint's reading, the shift of the tip
  /// along the tool's axes, the shift of the base, the rotation of the base.
  int channel = 0;
  int source = 0;  ///< index of the source of error; terms with the same place and variable share a source
  std::function<double(const Measurement&)> function;
  double scale = 1;  ///< normalisation factor: the root-mean-square error of the whole process is 1 m
  double share = 0;  ///< fraction of the process's variance due to this term
};

/// Gaussian process that models the discrepancy in the measurements of a measurement campaign.
class Discrepancy {
 public:
  /// Builds the terms of the Gaussian process for the errors of the model `placed`. The terms cover the ranges of the
  /// quantities that these measurements state.
  Discrepancy(const PlacedArm& placed, const std::vector<Measurement>& measurements);

  [[nodiscard]] const std::vector<DiscrepancyTerm>& terms() const { return terms_; }

  /// Returns, for each source of error, the indices of its terms in terms().
  [[nodiscard]] std::vector<std::vector<int>> sources() const;

  /// Returns the whitened columns of the terms at these measurements (rows of `weights` x terms), without the component
  /// that unknown points absorb. Empty if the model cannot be evaluated.
  [[nodiscard]] Eigen::MatrixXd columnsAt(const std::vector<Measurement>& measurements,
                                          const MeasurementWeights& weights) const;

 private:
  PlacedArm placed_;
  std::vector<DiscrepancyTerm> terms_;
};

}  // namespace tubeplan::calibration
