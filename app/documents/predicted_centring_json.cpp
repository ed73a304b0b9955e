#include "app/documents/predicted_centring_json.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace tubeplan::app {

namespace {

double inUnit(double metres, const Units& units) { return rounded(metres / units.factor(dimension::kLength)); }

nlohmann::json bandJson(const calibration::ForecastFigure& figure, const Units& units) {
  return {inUnit(figure.lower, units), inUnit(figure.upper, units)};
}

std::string figureText(const char* name, const calibration::ForecastFigure& figure, const Units& units) {
  const double unit = units.factor(dimension::kLength);
  return fmt::format("{} {:.3g} ({:.3g} to {:.3g})", name, figure.value / unit, figure.lower / unit,
                     figure.upper / unit);
}

}  // namespace

nlohmann::json predictedCentringJson(const PredictedCentring& predicted, const Units& units) {
  if (!predicted.reason.empty()) return {{"reason", predicted.reason}};
  const auto& forecast = predicted.forecast;
  return {{"median", inUnit(forecast.median.value, units)},
          {"p95", inUnit(forecast.p95.value, units)},
          {"worst", {{"value", inUnit(forecast.worst.value, units)}, {"hole", predicted.worst_hole}}},
          {"band",
           {{"level", 0.95},
            {"median", bandJson(forecast.median, units)},
            {"p95", bandJson(forecast.p95, units)},
            {"worst", bandJson(forecast.worst, units)}}},
          {"encoder_noise",
           {{"median", inUnit(forecast.encoders.median, units)},
            {"p95", inUnit(forecast.encoders.p95, units)},
            {"worst", inUnit(forecast.encoders.worst, units)}}},
          {"unit", std::string(units.length().name)},
          {"holes", predicted.holes},
          {"holes_out_of_reach", predicted.out_of_reach},
          {"holes_on_sheet", predicted.on_sheet},
          {"sampled", predicted.holes + predicted.out_of_reach < predicted.on_sheet},
          {"uncertain_numbers", forecast.numbers},
          {"earlier_stages_exact", predicted.later_stage}};
}

std::string predictedCentringText(const PredictedCentring& predicted, const Units& units) {
  if (predicted.on_sheet == 0) return "";
  if (!predicted.reason.empty()) return "predicted centring error: none, since " + predicted.reason + "\n";
  const auto& forecast = predicted.forecast;
  const double unit = units.factor(dimension::kLength);
  std::string text = fmt::format(
      "predicted centring error over {} of {} holes, from the parameters' uncertainty, {} (95 %):\n  {}, {}, {} near "
      "{}\n",
      predicted.holes, predicted.on_sheet, units.length().name,
      figureText("half of the holes within", forecast.median, units), figureText("95 % within", forecast.p95, units),
      figureText("all within", forecast.worst, units), predicted.worst_hole);
  text += fmt::format("  in addition, from encoder noise at each visit: rms {:.3g} in the median, {:.3g} at worst\n",
                      forecast.encoders.median / unit, forecast.encoders.worst / unit);
  if (predicted.out_of_reach > 0)
    text += fmt::format("  {} of the requested holes are out of reach\n", predicted.out_of_reach);
  if (predicted.later_stage) text += "  parameters of earlier stages are taken as exact here\n";
  return text;
}

}  // namespace tubeplan::app
