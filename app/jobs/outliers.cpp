#include "app/jobs/outliers.hpp"

#include "app/studies/model/cell_fit.hpp"
#include "calibration/estimation/set_aside.hpp"

namespace tubeplan::app {

std::vector<int> outliersOf(const CellReadings& input, const calibration::Identification& fit,
                            const calibration::IdentificationOptions& options) {
  if (input.checks.is_overruled || calibration::grossMistake(input.checks)) return {};
  const auto start = startOf(input.cell, input.readings);
  calibration::IdentificationOptions quiet = options;
  quiet.hooks = calibration::withoutProgress(options.hooks);
  quiet.folds = 0;
  quiet.may_hold_all = true;
  const bool is_fitted = fit.status != calibration::IdentificationStatus::kNotRun;
  return calibration::readingsToSetAside(start, input.readings,
                                         is_fitted ? fit : calibration::identify(start, input.readings, quiet), quiet);
}

std::vector<std::string> idsAt(const std::vector<int>& places, const std::vector<calibration::Measurement>& readings) {
  std::vector<std::string> ids;
  for (const int k : places) ids.push_back(readings.at(static_cast<std::size_t>(k)).id);
  return ids;
}

RefitOfReadings fitWithoutOutliers(
    const std::vector<calibration::Measurement>& readings,
    const std::function<calibration::Identification(const std::vector<calibration::Measurement>&)>& fitted,
    const std::function<std::vector<int>(const calibration::Identification&)>& outliers) {
  RefitOfReadings refit{readings, {}, fitted(readings)};
  if (refit.fit.status == calibration::IdentificationStatus::kRefused) return refit;
  const std::vector<int> aside = outliers(refit.fit);
  if (aside.empty()) return refit;
  refit.set_aside = idsAt(aside, readings);
  refit.readings = calibration::withoutReadings(readings, aside);
  refit.fit = fitted(refit.readings);
  return refit;
}

}  // namespace tubeplan::app
