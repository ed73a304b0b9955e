#include "app/commands/campaign/campaign_json.hpp"

#include "app/documents/figures.hpp"
#include "app/formats/arm/joint_units.hpp"

namespace tubeplan::app {

using nlohmann::json;

json probabilityJson(const Probability& probability) {
  return {{"value", finiteJson(probability.value)},
          {"low", finiteJson(probability.low)},
          {"high", finiteJson(probability.high)}};
}

json shareJson(std::uint64_t part, std::uint64_t total) {
  json share = probabilityJson(wilsonInterval(static_cast<double>(part), static_cast<double>(total)));
  share["count"] = part;
  share["of"] = total;
  return share;
}

json drawnJson(const TruthSpread& spread, const deflection::Arm& truth, const Units& units) {
  json encoders = json::object();
  for (const auto& joint : truth.joints())
    encoders[joint.name] = finiteJson(joint.encoder_sigma / units.factor(jointDimension(joint)));
  return {{"base_shift_sigma", lengthJson(spread.base_shift_sigma, units)},
          {"base_turn_sigma", finiteJson(spread.base_turn_sigma / units.factor(dimension::kAngle))},
          {"stiffness_sigma", spread.stiffness_sigma},
          {"unmodelled_sigma", lengthJson(spread.unmodelled_sigma, units)},
          {"encoder_sigma", encoders}};
}

json failuresJson(std::span<const FailureCount> failures) {
  json list = json::array();
  for (std::size_t k = 1; k < failures.size(); ++k)
    if (const auto& failure = failures[k]; failure.runs > 0)
      list.push_back(
          {{"reason", nameOf(static_cast<TrialFailure>(k))}, {"runs", failure.runs}, {"first_run", failure.first_run}});
  return list;
}

}  // namespace tubeplan::app
