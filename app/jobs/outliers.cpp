#include "app/jobs/outliers.hpp"

#include "app/studies/model/cell_fit.hpp"
#include "calibration/estimation/set_aside.hpp"

namespace tubeplan::app {

std::vector<int> outliersOf(const CellMeasurements& input, const calibration::Identification& fit,
                            const calibration::IdentificationOptions& options) {
  if (input.checks.is_overruled || calibration::firstMistake(input.checks)) return {};
  const auto start = startOf(input.cell, input.measurements);
  calibration::IdentificationOptions quiet = options;
  quiet.hooks = calibration::withoutProgress(options.hooks);
  quiet.folds = 0;
  quiet.may_hold_all = true;
  const bool is_fitted = fit.status != calibration::IdentificationStatus::kNotRun;
  return calibration::measurementsToSetAside(
      start, input.measurements, is_fitted ? fit : calibration::identify(start, input.measurements, quiet), quiet);
}

std::vector<std::string> idsAt(const std::vector<int>& places,
                               const std::vector<calibration::Measurement>& measurements) {
  std::vector<std::string> ids;
  for (const int k : places) ids.push_back(measurements.at(static_cast<std::size_t>(k)).id);
  return ids;
}

RefitOfMeasurements fitWithoutOutliers(
    const std::vector<calibration::Measurement>& measurements,
    const std::function<calibration::Identification(const std::vector<calibration::Measurement>&)>& fitted,
    const std::function<std::vector<int>(const calibration::Identification&)>& outliers) {
  RefitOfMeasurements refit{measurements, {}, fitted(measurements)};
  if (refit.fit.status == calibration::IdentificationStatus::kRefused) return refit;
  const std::vector<int> aside = outliers(refit.fit);
  if (aside.empty()) return refit;
  refit.set_aside = idsAt(aside, measurements);
  refit.measurements = calibration::withoutMeasurements(measurements, aside);
  refit.fit = fitted(refit.measurements);
  return refit;
}

}  // namespace tubeplan::app
