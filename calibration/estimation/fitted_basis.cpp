#include "calibration/estimation/fitted_basis.hpp"

#include "calibration/measurements/surfaces.hpp"

namespace tubeplan::calibration {

FittedBasis basisOf(const Identification& baseline, const std::vector<Measurement>& measurements,
                    const StopQuestion& stop) {
  FittedBasis basis{measurements, baseline.fitted, fittedUnknowns(baseline), {}, {}, stop};
  settleSurfaces(basis.fitted, basis.measurements);
  if (auto weights = weighMeasurements(basis.fitted, measurements, {}, 0, stop)) basis.weights = std::move(*weights);
  if (basis.weights.rows > 0)
    basis.residual = whitenedResidual(basis.fitted, basis.unknowns, measurements, basis.weights,
                                      zerosOf(basis.unknowns), true, stop);
  return basis;
}

}  // namespace tubeplan::calibration
