#include "app/documents/sensitivity_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/documents/figures.hpp"
#include "app/documents/figures_text.hpp"
#include "app/formats/units_json.hpp"

namespace tubeplan::app {

namespace {

using calibration::NumberKind, calibration::NumberSensitivity;

struct KindWords {
  NumberKind kind;
  const char *name, *more, *less;  ///< `more` and `less` are comparatives, such as "stiffer" and "softer"
};
constexpr KindWords kKindWords[] = {{NumberKind::kStiffness, "stiffness", "stiffer", "softer"},
                                    {NumberKind::kWeight, "weight", "heavier", "lighter"},
                                    {NumberKind::kLength, "length", "longer", "shorter"}};

const KindWords* wordsOf(NumberKind kind) {
  for (const auto& words : kKindWords)
    if (words.kind == kind) return &words;
  return nullptr;
}

/// Returns true if a designer can change the parameter by one per cent.
bool isDesignable(const NumberSensitivity& number) {
  return wordsOf(number.kind) != nullptr && number.parameter.value != 0;
}

double perCent(const NumberSensitivity& number, double slope) { return slope * std::abs(number.parameter.value) / 100; }

double sigmaOf(const SensitivityReport& report, std::size_t index) {
  return report.sigmas.empty() ? std::numeric_limits<double>::quiet_NaN() : report.sigmas[index];
}

/// Returns a sentence such as "1 % stiffer latch-link.beam.Iz: 0.0123 in less deflection on average", for the direction
/// of change that reduces the deflection.
std::string designSentence(const NumberSensitivity& number, const Units& units) {
  const double sag = perCent(number, number.deflection) / units.factor(dimension::kLength);
  const auto& words = *wordsOf(number.kind);
  // A negative coordinate becomes longer as its value decreases, which reverses the direction of change.
  const bool is_more = (sag < 0) == (number.parameter.value > 0);
  return fmt::format("1 % {} {}: {:.3g} {} less deflection on average", is_more ? words.more : words.less,
                     number.parameter.name, std::abs(sag), units.length().name);
}

std::vector<std::size_t> ranked(const SensitivityReport& report,
                                double (*figure)(const SensitivityReport&, std::size_t)) {
  std::vector<std::size_t> order;
  for (std::size_t n = 0; n < report.figures.numbers.size(); ++n)
    if (std::isfinite(figure(report, n))) order.push_back(n);
  std::stable_sort(order.begin(), order.end(),
                   [&](auto a, auto b) { return std::abs(figure(report, a)) > std::abs(figure(report, b)); });
  return order;
}

constexpr double kNotDesignable = std::numeric_limits<double>::quiet_NaN();

double designFigure(const SensitivityReport& report, std::size_t n) {
  const auto& number = report.figures.numbers[n];
  return isDesignable(number) ? perCent(number, number.deflection) : kNotDesignable;
}

/// Returns the tip error caused by one standard deviation of the parameter if measurements determine it, otherwise by
/// one per cent of its value [m].
double estimateFigure(const SensitivityReport& report, std::size_t n) {
  const auto& number = report.figures.numbers[n];
  const double sigma = sigmaOf(report, n);
  if (std::isfinite(sigma)) return sigma * number.error;
  return isDesignable(number) ? perCent(number, number.error) : kNotDesignable;
}

nlohmann::json designJson(const SensitivityReport& report, const Cell& cell) {
  nlohmann::json list = nlohmann::json::array();
  const double unit = cell.units.factor(dimension::kLength);
  for (const std::size_t n : ranked(report, designFigure)) {
    const auto& number = report.figures.numbers[n];
    list.push_back({{"name", number.parameter.name},
                    {"kind", wordsOf(number.kind)->name},
                    {"value", cell.units.toFile(number.parameter.value, dimensionOf(number.parameter.quantity))},
                    {"unit", cell.units.nameOf(dimensionOf(number.parameter.quantity))},
                    {"deflection_per_percent", finiteJson(perCent(number, number.deflection) / unit)},
                    {"uncompensated_per_percent", finiteJson(perCent(number, number.centring) / unit)},
                    {"sentence", designSentence(number, cell.units)}});
  }
  return list;
}

nlohmann::json estimateJson(const SensitivityReport& report, const Cell& cell) {
  nlohmann::json list = nlohmann::json::array();
  const double unit = cell.units.factor(dimension::kLength);
  for (const std::size_t n : ranked(report, estimateFigure)) {
    const auto& number = report.figures.numbers[n];
    const double factor = cell.units.factor(dimensionOf(number.parameter.quantity)), sigma = sigmaOf(report, n);
    nlohmann::json json = {{"name", number.parameter.name},
                           {"value", finiteJson(number.parameter.value / factor)},
                           {"unit", cell.units.nameOf(dimensionOf(number.parameter.quantity))},
                           {"sigma", finiteJson(sigma / factor)},
                           {"error_per_sigma", finiteJson(sigma * number.error / unit)}};
    if (isDesignable(number)) {
      json["error_per_percent"] = finiteJson(perCent(number, number.error) / unit);
      json["error_per_percent_base_known"] = finiteJson(perCent(number, number.error_base_known) / unit);
    }
    list.push_back(json);
  }
  return list;
}

constexpr TextLine kKnowledgeWords[] = {{"error_per_percent", " {:>10.3r} {error_per_percent_base_known:>12.3r}"},
                                        {"!error_per_percent", "                        "},
                                        {"error_per_sigma", " {:>12.3r}"},
                                        {"", "\n"}};

constexpr TextLine kRankingWords[] = {
    {"",
     "mean deflection {mean_deflection:.4r units/length}, mean error ({error}) without compensation "
     "{mean_uncompensated_error:.4r units/length}\nwhat to change, by decreasing influence\n"},
    {"design", "  {sentence:<80} {helps_by:>+10.3r}\n"},
    {"",
     "  (last column: change of the mean error without compensation, {units/length})\n"
     "what must be known, by decreasing influence: mean positioning error, {units/length}, after compensation and "
     "calibration\n                                          of 1 %   base known of one sigma\n"},
    {"knowledge", "  {name:<36}", kKnowledgeWords}};

constexpr TextLine kSensitivityWords[] = {
    {"", "{work/postures} posture(|s) at work"},
    {"work/out_of_reach", ", {} tube(|s) out of reach"},
    {"touches", "; base calibrated by touching {touches}\n", {}, {}, 1},
    {"!touches", "; base known\n"},
    {"mean_deflection", "", kRankingWords},
    {"!mean_deflection",
     "no figures: the deflected shape does not converge at some of these postures; check loads and stiffnesses\n"}};

}  // namespace

nlohmann::json sensitivityJson(const SensitivityReport& report, const Cell& cell) {
  const double unit = cell.units.factor(dimension::kLength);
  return {{"work", {{"postures", report.work}, {"out_of_reach", report.work_lost}}},
          {"touches", report.touches},
          {"mean_deflection", finiteJson(report.figures.mean_deflection / unit)},
          {"mean_uncompensated_error", finiteJson(report.figures.mean_uncompensated / unit)},
          {"error", report.has_sheet ? "across the holes" : "whole"},
          {"design", designJson(report, cell)},
          {"knowledge", estimateJson(report, cell)},
          {"units", unitsJson(cell.units)}};
}

std::string sensitivityText(nlohmann::json figures) {
  for (auto& number : figures["design"]) {  // `helps_by`: for the change that reduces the deflection
    const nlohmann::json &sag = number["deflection_per_percent"], &centring = number["uncompensated_per_percent"];
    number["helps_by"] = centring.is_null() || sag <= 0 ? centring : nlohmann::json(-centring.get<double>());
  }
  return textOf(figures, kSensitivityWords);
}

}  // namespace tubeplan::app
