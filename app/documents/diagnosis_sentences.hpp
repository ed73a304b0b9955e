// Sentences of a diagnosis, which texts, pages and reports show unchanged.
#pragma once

#include <string>
#include <vector>

#include "app/formats/units.hpp"
#include "calibration/diagnosis/diagnosis.hpp"

namespace tubeplan::app {

/// Predicate for a remainder that no slow function of the measurements' conditions explains.
inline constexpr const char* kFollowsNothing = "follows no slow function of what the readings record";

/// Meaning of the probabilities in a ranking: each sums over the models that include the effect.
inline constexpr const char* kProbabilityWords =
    "the probability of an effect is that it is there; several may be, so that these do not add to 100 %";

/// Returns the ids of the readings at these indices.
[[nodiscard]] std::vector<std::string> idsOf(const std::vector<int>& places,
                                             const std::vector<calibration::Measurement>& readings);

/// Returns "half width 0.0586 ± 0.0010 deg"; for a size that the readings do not determine, "x -0.040 to 0.042 in".
[[nodiscard]] std::string numberText(const calibration::FoundNumber& number, const Units& units);

/// Returns "hysteresis at theta4 (half width 0.0586 ± 0.0010 deg) and ...".
[[nodiscard]] std::string sizesText(const calibration::Explanation& explanation, const Units& units);

/// Returns "hysteresis at theta4 and link-bending at 4 places".
[[nodiscard]] std::string namesText(const calibration::Explanation& explanation);

/// Returns the other effects that no reading could distinguish from this one, in words; empty if there are none.
[[nodiscard]] std::string alsoText(const calibration::FoundEffect& effect);

/// Returns the conclusions of a diagnosis, one sentence each.
[[nodiscard]] std::vector<std::string> diagnosisSentences(const calibration::Diagnosis& result, const Units& units);

/// Returns diagnosisSentences() joined into one text.
[[nodiscard]] std::string diagnosisSentence(const calibration::Diagnosis& result, const Units& units);

/// Returns an effect that a diagnosis found, in the notation of AdditionRequest::causes.
[[nodiscard]] std::string additionText(const calibration::FoundEffect& found, const deflection::Arm& arm,
                                       const Units& units);

}  // namespace tubeplan::app
