// Signatures of causes: changes of the readings, to first order, per largest size in real machines.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "calibration/diagnosis/causes/cause.hpp"
#include "calibration/estimation/whitened_residual.hpp"

namespace tubeplan::calibration {

/// Column for one number of a cause at one level of its shape, in units of Unknown::typical.
struct SignatureColumn {
  double lower = 0, upper = 0;  ///< bounds of the number, relative to its neutral value, in units
  double prior_sigma = 1;       ///< prior standard deviation in units; 1 for the size of an effect
  bool is_of_effect = true;
};

class Signatures {
 public:
  /// Lists the columns of the causes at the model `fitted`. Steps are placed by its readings' times.
  Signatures(const PlacedArm& fitted, const std::vector<Cause>& causes);

  [[nodiscard]] const std::vector<SignatureColumn>& columns() const { return columns_; }

  /// Returns the columns of a cause at a level, in the order of its numbers.
  [[nodiscard]] const std::vector<int>& columnsOf(int cause, int level) const {
    return of_cause_[static_cast<std::size_t>(cause)][static_cast<std::size_t>(level)];
  }

  /// Returns the whitened columns at these readings (rows of `weights` x columns()), without the part that unknown
  /// points absorb. Empty if the model cannot be evaluated. Throws WorkStopped on a request to stop.
  [[nodiscard]] Eigen::MatrixXd columnsAt(const std::vector<Measurement>& readings, const ReadingWeights& weights,
                                          const StopQuestion& stop = {}) const;

 private:
  /// Causes that are evaluated in one arm, each at one level. Two shapes at one place would add up, so they are in
  /// different layers.
  struct Layer {
    PlacedArm placed;
    std::vector<Unknown> unknowns;
    std::vector<int> columns;   ///< column of each unknown
    std::vector<double> times;  ///< times of a step [s], with one block of columns each
  };

  int addColumn(const Unknown& unknown);
  void addLayers(const PlacedArm& fitted, const std::vector<Cause>& causes);
  void addStep(const PlacedArm& fitted, const Cause& cause, std::size_t index);
  void shareColumns(const std::vector<Cause>& causes);

  std::vector<SignatureColumn> columns_;
  std::vector<std::vector<std::vector<int>>> of_cause_;  ///< columns by cause, level and number
  std::vector<Layer> layers_;
};

/// Causes that consist of one effect at one place, with their columns at some readings.
struct SingleCauses {
  std::vector<Cause> causes;
  Signatures signatures;
  Eigen::MatrixXd columns;

  [[nodiscard]] Eigen::MatrixXd columnsOf(std::size_t cause, int level) const {
    return columns(Eigen::all, signatures.columnsOf(static_cast<int>(cause), level));
  }
};

/// Returns the single causes that the readings could show beside the fitted numbers; nothing if the model cannot be
/// evaluated.
[[nodiscard]] std::optional<SingleCauses> singleCauses(const PlacedArm& placed,
                                                       const std::vector<Measurement>& readings,
                                                       const std::vector<Unknown>& fitted,
                                                       const ReadingWeights& weights);

}  // namespace tubeplan::calibration
