#include "app/studies/model/model_comparison.hpp"

#include <algorithm>
#include <cmath>

#include "app/studies/model/cell_fit.hpp"
#include "calibration/estimation/fit.hpp"
#include "calibration/estimation/held_out.hpp"
#include "calibration/statistics.hpp"

namespace tubeplan::app {

namespace {

void stateChiSquare(double chi2, int degrees_of_freedom, ModelComparisonRow& compared) {
  compared.chi2_per_dof = chi2 / std::max(1, degrees_of_freedom);
  if (degrees_of_freedom > 0) compared.p_value = calibration::chiSquareTail(chi2, degrees_of_freedom);
}

/// Returns the comparison row of a model without free parameters.
ModelComparisonRow rowAsItStands(const std::string& name, const CellModel& cell,
                                 const std::vector<calibration::Measurement>& measurements) {
  ModelComparisonRow compared;
  compared.name = name;
  compared.model = startOf(cell, measurements);
  const auto& placed = compared.model;
  std::vector<calibration::Measurement> fitted, held_out;
  for (const auto& measurement : measurements) (measurement.is_held_out ? held_out : fitted).push_back(measurement);
  compared.as_it_stands = compared.fitted = calibration::judge(placed, fitted);
  compared.heldout = held_out.empty() ? compared.fitted : calibration::judge(placed, held_out);
  if (const auto weights = calibration::weighMeasurements(placed, fitted)) {
    compared.noise_floor = calibration::noiseFloor(fitted, *weights);
    const auto residual = calibration::whitenedResidual(placed, {}, fitted, *weights, {}, false);
    stateChiSquare(residual.r.squaredNorm(), weights->degrees_of_freedom, compared);
  }
  return compared;
}

}  // namespace

ModelComparisonRow comparisonRowOf(const std::string& name, const calibration::Identification& fit) {
  ModelComparisonRow compared;
  compared.name = name;
  compared.model = fit.fitted;
  compared.fitted_numbers = static_cast<int>(fit.numbers.size());
  compared.as_it_stands = fit.before;
  compared.fitted = fit.after;
  compared.heldout = fit.heldout;
  compared.noise_floor = fit.noise_floor;
  stateChiSquare(fit.chi2, fit.degrees_of_freedom, compared);
  return compared;
}

calibration::Identification fitForLadder(const CellModel& cell,
                                         const std::vector<calibration::Measurement>& measurements, std::uint64_t seed,
                                         const WorkHooks& hooks) {
  if (cell.identify.empty() && cell.base_known) return {};
  calibration::IdentificationOptions options;
  options.free = freeNumbersOf(cell);
  options.seed = seed;
  options.intervals_by_profile = false;
  options.hooks = hooks;
  auto fit = calibration::identify(startOf(cell, measurements), measurements, options);
  throwIfJobStopped(hooks);
  return fit;
}

ModelComparisonRow comparisonRowOf(const std::string& name, const CellModel& cell,
                                   const std::vector<calibration::Measurement>& measurements, std::uint64_t seed,
                                   const WorkHooks& hooks) {
  const auto fit = fitForLadder(cell, measurements, seed, hooks);
  if (fit.status == calibration::IdentificationStatus::kNotRun) return rowAsItStands(name, cell, measurements);
  return comparisonRowOf(name, fit);
}

}  // namespace tubeplan::app
