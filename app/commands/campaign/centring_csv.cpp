#include <fmt/format.h>

#include "app/commands/campaign/centring_figures.hpp"

namespace tubeplan::app {

namespace {

class HolesTable {
 public:
  explicit HolesTable(const CentringResults& results) : results_(results) {
    const auto unit = results.task.cell.units.length().name;
    text_ = fmt::format(
        "touches,choice,touch_sigma_{0},way,hole,x_{0},y_{0},visits,missed,mean_{0},mean_sigma_{0},rms_{0},"
        "q50_{0},q90_{0},q95_{0},q99_{0},max_{0}",
        unit);
    for (std::size_t k = 1; k <= results.task.model.tool.steps.size(); ++k)
      text_ += fmt::format(",p{0},p{0}_low,p{0}_high", k);
    text_ += '\n';
  }

  void add(const CentringSetting& setting, std::string_view way, const calibration::TouchPlan& plan,
           const HoleTally& hole) {
    const auto& errors = hole.errors;
    if (errors.count() == 0 && hole.missed == 0) return;
    text_ += fmt::format("{},{},{},{},{},{},{},{},{}", setting.touches,
                         touchRules()[static_cast<std::size_t>(setting.rule)].name, length(setting.touch_sigma), way,
                         plan.hole, length(plan.p_WH.x()), length(plan.p_WH.y()), errors.count(), hole.missed);
    const auto n = static_cast<double>(errors.count());
    for (const double value : {errors.mean(), errors.sigma() / std::sqrt(n), errors.rms(), errors.quantile(0.5),
                               errors.quantile(0.9), errors.quantile(0.95), errors.quantile(0.99), errors.max()})
      text_ += "," + length(value);
    for (std::size_t k = 0; k < results_.task.model.tool.steps.size(); ++k) {
      const auto count = k < hole.at_least.size() ? static_cast<double>(hole.at_least[k]) : 0.;
      const Probability p = wilsonInterval(count, n);
      for (const double value : {p.value, p.low, p.high}) text_ += "," + number(value, 6);
    }
    text_ += '\n';
  }

  [[nodiscard]] std::string text() const { return text_; }

 private:
  /// Returns a number as text with `digits` significant digits; empty if the number is not finite.
  static std::string number(double value, int digits) {
    return std::isfinite(value) ? fmt::format("{:.{}g}", value, digits) : "";
  }
  [[nodiscard]] std::string length(double metres) const {
    return number(metres / results_.task.cell.units.factor(dimension::kLength), 8);
  }

  const CentringResults& results_;
  std::string text_;
};

}  // namespace

std::string holesCsv(const CentringResults& results) {
  HolesTable table(results);
  for (std::size_t s = 0; s < results.task.options.settings.size(); ++s)
    for (std::size_t w = 0; w < kWays.size(); ++w) {
      const auto& holes = results.tally.settings()[s].ways[w].holes;
      for (std::size_t k = 0; k < holes.size(); ++k)
        table.add(results.task.options.settings[s], kWays[w], results.task.holes.visited[k], holes[k]);
    }
  return table.text();
}

}  // namespace tubeplan::app
