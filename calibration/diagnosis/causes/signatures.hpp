// The signature of every cause: what it would do to the readings, to first order, per largest size that a real machine
// has.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "calibration/diagnosis/causes/cause.hpp"
#include "calibration/estimation/whitened_residual.hpp"

namespace tubeplan::calibration {

/// One number of a cause at one level of its shape; its unit is Unknown::typical.
struct SignatureColumn {
  double lower = 0, upper = 0;  ///< of the number, in units from where it does nothing
  double prior_sigma = 1;       ///< in units: of a number of the drawing that of its prior; of an effect's size 1
  bool is_of_effect = true;
};

class Signatures {
 public:
  /// About the model `fitted`, by whose readings' times steps are placed.
  Signatures(const PlacedArm& fitted, const std::vector<Cause>& causes);

  [[nodiscard]] const std::vector<SignatureColumn>& columns() const { return columns_; }

  /// Columns of a cause at a level, in the order of its numbers.
  [[nodiscard]] const std::vector<int>& columnsOf(int cause, int level) const {
    return of_cause_[static_cast<std::size_t>(cause)][static_cast<std::size_t>(level)];
  }

  /// Whitened columns at some readings (rows of `weights`); what unknown points absorb is taken off. Empty where the
  /// model cannot be evaluated. Unwinds where it was stopped.
  [[nodiscard]] Eigen::MatrixXd columnsAt(const std::vector<Measurement>& readings, const ReadingWeights& weights,
                                          const StopQuestion& stop = {}) const;

 private:
  /// Causes that share an arm, each at one level: shapes at one place would add up.
  struct Layer {
    PlacedArm placed;
    std::vector<Unknown> unknowns;
    std::vector<int> columns;   ///< of each unknown
    std::vector<double> times;  ///< of a step: one block of columns for each
  };

  int addColumn(const Unknown& unknown);
  void addLayers(const PlacedArm& fitted, const std::vector<Cause>& causes);
  void addStep(const PlacedArm& fitted, const Cause& cause, std::size_t index);
  void shareColumns(const std::vector<Cause>& causes);

  std::vector<SignatureColumn> columns_;
  std::vector<std::vector<std::vector<int>>> of_cause_;  ///< cause, level, number
  std::vector<Layer> layers_;
};

/// The causes that are one effect at one place, with their columns at some readings.
struct SingleCauses {
  std::vector<Cause> causes;
  Signatures signatures;
  Eigen::MatrixXd columns;

  [[nodiscard]] Eigen::MatrixXd columnsOf(std::size_t cause, int level) const {
    return columns(Eigen::all, signatures.columnsOf(static_cast<int>(cause), level));
  }
};

/// Returns those that the readings could show beside the fitted numbers; nothing where the model cannot be evaluated.
[[nodiscard]] std::optional<SingleCauses> singleCauses(const PlacedArm& placed,
                                                       const std::vector<Measurement>& readings,
                                                       const std::vector<Unknown>& fitted,
                                                       const ReadingWeights& weights);

}  // namespace tubeplan::calibration
