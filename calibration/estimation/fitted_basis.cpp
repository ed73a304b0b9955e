#include "calibration/estimation/fitted_basis.hpp"

#include "calibration/measurements/surfaces.hpp"

namespace tubeplan::calibration {

FittedBasis basisOf(const Identification& baseline, const std::vector<Measurement>& readings,
                    const StopQuestion& stop) {
  FittedBasis basis{readings, baseline.fitted, fittedUnknowns(baseline), {}, {}, stop};
  settleSurfaces(basis.fitted, basis.readings);
  if (auto weights = weighReadings(basis.fitted, readings, {}, 0, stop)) basis.weights = std::move(*weights);
  if (basis.weights.rows > 0)
    basis.residual =
        whitenedResidual(basis.fitted, basis.unknowns, readings, basis.weights, zerosOf(basis.unknowns), true, stop);
  return basis;
}

}  // namespace tubeplan::calibration
