// Unknown model error outside the catalogue: a smooth function of the joints, the direction of motion, the load and the
// stated conditions, as a Gaussian process (Kennedy and O'Hagan 2001, "Bayesian calibration of computer models").
//
// The process is a sum of functions with independent normal weights. Each is an error of one joint's reading, a shift
// of the tip in the tool's frame, or a shift or rotation of the base, times a smooth function of what the readings
// state: waves and local bumps of a joint's angle, products of two, load, direction, conditions. The process competes
// with named causes and never names one. A displacement, from another reading or from the unloaded tip, has the
// difference of the functions at both postures.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

#include "calibration/estimation/whitened_residual.hpp"

namespace tubeplan::calibration {

/// One function of the process.
struct DiscrepancyTerm {
  std::string follows;  ///< variable that the term follows: "theta3", "direction of theta3", "load", "time"
  /// Index of a joint's reading, then of the tip along the tool's axes, the base's shift, the base's rotation.
  int channel = 0;
  int source = 0;  ///< index of the term's source, shared by all terms of that source
  std::function<double(const Measurement&)> function;
  double scale = 1;  ///< factor of the function, for which the whole process has a root-mean-square error of 1 m
  double share = 0;  ///< share of the process's variance
};

/// Discrepancy process at the readings of a campaign.
class Discrepancy {
 public:
  /// Builds functions over the ranges of the quantities that these readings state. `placed` is the model with the
  /// errors.
  Discrepancy(const PlacedArm& placed, const std::vector<Measurement>& readings);

  [[nodiscard]] const std::vector<DiscrepancyTerm>& terms() const { return terms_; }

  /// Returns the indices of each source's terms.
  [[nodiscard]] std::vector<std::vector<int>> sources() const;

  /// Returns the whitened columns at these readings (rows of `weights` x terms), without the part that unknown points
  /// absorb. Empty if the model cannot be evaluated.
  [[nodiscard]] Eigen::MatrixXd columnsAt(const std::vector<Measurement>& readings,
                                          const ReadingWeights& weights) const;

 private:
  PlacedArm placed_;
  std::vector<DiscrepancyTerm> terms_;
};

}  // namespace tubeplan::calibration
