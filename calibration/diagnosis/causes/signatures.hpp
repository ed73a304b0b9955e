// Signatures of causes: first-order changes of the measurements when a parameter of the cause takes the largest value
// found on real machines.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "calibration/diagnosis/causes/cause.hpp"
#include "calibration/estimation/whitened_residual.hpp"

namespace tubeplan::calibration {

/// Properties of the signature's column for one parameter of a cause, at one level of its scanned parameter. The column
/// is the change of the measurements when the parameter changes by Unknown::typical.
struct SignatureColumn {
  double lower = 0, upper = 0;  ///< bounds of the parameter, relative to its neutral value [Unknown::typical]
  double prior_sigma = 1;       ///< prior standard deviation [Unknown::typical]; 1 for a parameter of an effect
  bool is_of_effect = true;
};

class Signatures {
 public:
  /// Prepares the columns of the causes, linearised about the model `fitted`. A step has a separate block of columns
  /// for each time at which it is tried.
  Signatures(const PlacedArm& fitted, const std::vector<Cause>& causes);

  [[nodiscard]] const std::vector<SignatureColumn>& columns() const { return columns_; }

  /// Returns the column indices of a cause at a level of its scanned parameter, in the order of the cause's parameters.
  [[nodiscard]] const std::vector<int>& columnsOf(int cause, int level) const {
    return of_cause_[static_cast<std::size_t>(cause)][static_cast<std::size_t>(level)];
  }

  /// Returns the whitened columns at these measurements (rows of `weights` x columns()), without the component that
  /// unknown points absorb. Empty if the model cannot be evaluated. Throws WorkStopped on a request to stop.
  [[nodiscard]] Eigen::MatrixXd columnsAt(const std::vector<Measurement>& measurements,
                                          const MeasurementWeights& weights, const StopQuestion& stop = {}) const;

 private:
  /// Causes that are evaluated together in one arm, each at one level. The levels of a cause are in different layers,
  /// because the effects of two levels would add up in one arm.
  struct Layer {
    PlacedArm placed;
    std::vector<Unknown> unknowns;
    std::vector<int> columns;  ///< index of the column of each unknown
    /// Times at which a step is tried [s], each with a block of columns; empty if there is no step.
    std::vector<double> times;
  };

  int addColumn(const Unknown& unknown);
  /// Distributes the causes over layers with few causes each: those that only shift joints, whose shapes are solved
  /// side by side (predictAll()), or all others. All causes of a layer are in the arm at once, and the cost of a
  /// derivative grows with their number.
  void addLayers(const PlacedArm& fitted, const std::vector<Cause>& causes, bool of_joints);
  void addStep(const PlacedArm& fitted, const Cause& cause, std::size_t index);
  void shareColumns(const std::vector<Cause>& causes);

  std::vector<SignatureColumn> columns_;
  std::vector<std::vector<std::vector<int>>> of_cause_;  ///< column indices by cause, level and parameter
  std::vector<Layer> layers_;
};

/// Causes that consist of one effect at one place, with their whitened columns at given measurements.
struct SingleCauses {
  std::vector<Cause> causes;
  Signatures signatures;
  Eigen::MatrixXd columns;

  [[nodiscard]] Eigen::MatrixXd columnsOf(std::size_t cause, int level) const {
    return columns(Eigen::all, signatures.columnsOf(static_cast<int>(cause), level));
  }
};

/// Returns the causes of one effect at one place that the measurements could reveal in addition to the fitted
/// parameters; nullopt if the model cannot be evaluated.
[[nodiscard]] std::optional<SingleCauses> singleCauses(const PlacedArm& placed,
                                                       const std::vector<Measurement>& measurements,
                                                       const std::vector<Unknown>& fitted,
                                                       const MeasurementWeights& weights);

}  // namespace tubeplan::calibration
