// A fit of what the readings can tell: the rest is found out and held.
#pragma once

#include "calibration/fit.hpp"
#include "calibration/identification.hpp"

namespace tubeplan::calibration {

/// One identification under way: what is free, and which of it the readings tell.
struct ToldFit {
  const std::vector<Measurement>& fitted;
  const IdentificationOptions& options;
  PlacedArm start;
  std::vector<Unknown> unknowns;
  Identifiability told;  ///< indices into `unknowns`
  Fit fit;               ///< of the kept ones

  [[nodiscard]] std::vector<Unknown> kept() const;
};

/// Places unknown bases with nothing else free, so that the rest starts from a sensible place. Counts the work done.
void fitBases(ToldFit& work, Identification& result);

/// Fits; what the optimum shows to be untold after all is held at its start, unless that would show, and the rest
/// fitted again. The start holds only what hardly shows at all there, since it may be off by a factor: a twin held
/// there may leave the other no room. False where the model cannot be evaluated.
[[nodiscard]] bool fitTold(ToldFit& work, Identification& result);

/// Indices of the variables that stand at a bound.
[[nodiscard]] std::vector<int> atBound(const std::vector<Unknown>& unknowns, const Eigen::VectorXd& x);

/// Factor on every sigma where a misfit is larger than the stated noise allows; 1 otherwise.
[[nodiscard]] double wideningOf(double chi2, int degrees_of_freedom);

}  // namespace tubeplan::calibration
