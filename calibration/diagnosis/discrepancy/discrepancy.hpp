// What a model may miss that no catalogue names: a smooth function of the joints, the direction of motion, the load
// and the conditions that readings state, as a Gaussian process (Kennedy and O'Hagan 2001, "Bayesian calibration of
// computer models").
//
// The process is a sum of a few functions with independent normal weights. Each is an error of one joint's reading, a
// shift of the tip in the tool's frame, a shift or a turn of the base, times a smooth function of what the readings
// state: waves and local bumps of a joint's angle, products of two, load, direction, conditions. It weighs the
// unknown against causes that have names; it never names one. Of a displacement, from another reading or from where the
// tip rests unloaded, it is the difference of the functions at both postures.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

#include "calibration/estimation/whitened_residual.hpp"

namespace tubeplan::calibration {

/// One function of the process.
struct DiscrepancyTerm {
  std::string follows;  ///< "theta3", "direction of theta3", "load", "time": what a remainder follows
  int channel = 0;      ///< a joint's reading by its number, then the tip along the tool's axes, the base, its turn
  int source = 0;       ///< terms that one source makes have the same
  std::function<double(const Measurement&)> function;
  double scale = 1;  ///< of the function, so that the whole process has an error of 1 m root mean square
  double share = 0;  ///< of the process's variance
};

/// The process at the readings of a campaign.
class Discrepancy {
 public:
  /// Functions over the ranges of these readings, of what they state. `placed` is the model that they are errors of.
  Discrepancy(const PlacedArm& placed, const std::vector<Measurement>& readings);

  [[nodiscard]] const std::vector<DiscrepancyTerm>& terms() const { return terms_; }

  /// Indices of the terms that each single source makes.
  [[nodiscard]] std::vector<std::vector<int>> sources() const;

  /// Whitened columns, one for each term, at some readings (rows of `weights`); what unknown points absorb is taken
  /// off. Empty where the model cannot be evaluated.
  [[nodiscard]] Eigen::MatrixXd columnsAt(const std::vector<Measurement>& readings,
                                          const ReadingWeights& weights) const;

 private:
  PlacedArm placed_;
  std::vector<DiscrepancyTerm> terms_;
};

}  // namespace tubeplan::calibration
