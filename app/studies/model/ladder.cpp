#include "app/studies/model/ladder.hpp"

#include <algorithm>
#include <cmath>

#include "app/studies/model/cell_fit.hpp"
#include "calibration/estimation/fit.hpp"
#include "calibration/estimation/held_out.hpp"

namespace tubeplan::app {

namespace {

/// A model that frees nothing: its error is what it is.
Rung rungAsItStands(const std::string& name, const CellModel& cell,
                    const std::vector<calibration::Measurement>& readings) {
  Rung rung;
  rung.name = name;
  rung.model = startOf(cell, readings);
  const auto& placed = rung.model;
  std::vector<calibration::Measurement> fitted, held_out;
  for (const auto& reading : readings) (reading.is_held_out ? held_out : fitted).push_back(reading);
  rung.as_it_stands = rung.fitted = calibration::judge(placed, fitted);
  rung.heldout = held_out.empty() ? rung.fitted : calibration::judge(placed, held_out);
  if (const auto weights = calibration::weighReadings(placed, fitted)) {
    rung.noise_floor = calibration::noiseFloor(fitted, *weights);
    const auto residual = calibration::whitenedResidual(placed, {}, fitted, *weights, {}, false);
    rung.chi2_per_dof = residual.r.squaredNorm() / std::max(1, weights->degrees_of_freedom);
  }
  return rung;
}

}  // namespace

Rung rungOf(const std::string& name, const calibration::Identification& fit) {
  Rung rung;
  rung.name = name;
  rung.model = fit.fitted;
  rung.fitted_numbers = static_cast<int>(fit.numbers.size());
  rung.as_it_stands = fit.before;
  rung.fitted = fit.after;
  rung.heldout = fit.heldout;
  rung.noise_floor = fit.noise_floor;
  rung.chi2_per_dof = fit.chi2 / std::max(1, fit.degrees_of_freedom);
  return rung;
}

Rung rungOf(const std::string& name, const CellModel& cell, const std::vector<calibration::Measurement>& readings,
            std::uint64_t seed, const WorkHooks& hooks) {
  if (cell.identify.empty() && cell.base_known) return rungAsItStands(name, cell, readings);
  calibration::IdentificationOptions options;
  options.free = freeNumbersOf(cell);
  options.seed = seed;
  options.intervals_by_profile = false;
  options.hooks = hooks;
  const auto fit = calibration::identify(startOf(cell, readings), readings, options);
  requireGoingOn(hooks);
  return rungOf(name, fit);
}

}  // namespace tubeplan::app
