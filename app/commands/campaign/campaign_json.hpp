// Parts of the JSON documents of several kinds of campaigns.
#pragma once

#include <nlohmann/json.hpp>
#include <span>

#include "app/formats/units.hpp"
#include "app/studies/monte_carlo/centring_trial.hpp"
#include "app/studies/monte_carlo/confidence.hpp"
#include "app/studies/monte_carlo/failure_count.hpp"

namespace tubeplan::app {

/// Returns {value, low, high}: a probability with its 95 % interval.
[[nodiscard]] nlohmann::json probabilityJson(const Probability& probability);

/// Returns {count, of, value, low, high}: a share of independent runs with Wilson's interval.
[[nodiscard]] nlohmann::json shareJson(std::uint64_t part, std::uint64_t total);

/// Returns the standard deviations of what is drawn about the arm `truth`.
[[nodiscard]] nlohmann::json drawnJson(const TruthSpread& spread, const deflection::Arm& truth, const Units& units);

/// Returns [{reason, runs, first_run}, ...]: the reasons for which runs could not be calibrated; `failures` is indexed
/// by TrialFailure.
[[nodiscard]] nlohmann::json failuresJson(std::span<const FailureCount> failures);

}  // namespace tubeplan::app
