#include "app/documents/predicted_centring_json.hpp"

#include <nlohmann/json.hpp>

#include "app/documents/figures_text.hpp"

namespace tubeplan::app {

namespace {

double inUnit(double metres, const Units& units) { return rounded(metres / units.factor(dimension::kLength)); }

nlohmann::json bandJson(const calibration::ForecastFigure& figure, const Units& units) {
  return {inUnit(figure.lower, units), inUnit(figure.upper, units)};
}

constexpr TextLine kPredictedWords[] = {
    {"reason", "predicted centring error: none, since {}\n"},
    {"holes",
     "predicted centring error over {} of {holes_on_sheet} holes, from the parameters' uncertainty, {unit} (95 %):\n"
     "  half of the holes within {median:.3r} ({band/median:.3i}), 95 % within {p95:.3r} ({band/p95:.3i}), all within "
     "{worst/value:.3r} ({band/worst:.3i}) near {worst/hole}\n"
     "  in addition, from encoder noise at each visit: rms {encoder_noise/median:.3r} in the median, "
     "{encoder_noise/worst:.3r} at worst\n"},
    {"holes_out_of_reach", "  {} of the requested holes (is|are) out of reach\n"},
    {"earlier_stages_exact", "  parameters of earlier stages are taken as exact here\n"}};

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

std::string predictedCentringText(const nlohmann::json& predicted) { return textOf(predicted, kPredictedWords); }

}  // namespace tubeplan::app
