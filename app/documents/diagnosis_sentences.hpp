// Sentences on a diagnosis, shared by texts, pages and reports.
#pragma once

#include <string>
#include <vector>

#include "app/formats/units.hpp"
#include "calibration/diagnosis/diagnosis.hpp"

namespace tubeplan::app {

/// End of a sentence on a residual that does not depend smoothly on the recorded conditions of the measurements.
inline constexpr const char* kFollowsNothing = "is not a smooth function of anything that the readings record";

/// Explanation of the probabilities in a ranking: each is the summed probability of all models that include the effect.
inline constexpr const char* kProbabilityWords =
    "the probability of an effect is that it is present; several may be present, so these do not add to 100 %";

/// Returns the ids of the measurements with the indices `places`.
[[nodiscard]] std::vector<std::string> idsOf(const std::vector<int>& places,
                                             const std::vector<calibration::Measurement>& measurements);

/// Returns a string such as "half width 0.0586 ± 0.0010 deg"; for a parameter that the measurements leave undetermined,
/// its interval, such as "x -0.040 to 0.042 in".
[[nodiscard]] std::string numberText(const calibration::FoundNumber& number, const Units& units);

/// Returns a string that lists the effects of an explanation with their parameter values, such as "hysteresis at theta4
/// (half width 0.0586 ± 0.0010 deg) and ...".
[[nodiscard]] std::string sizesText(const calibration::Explanation& explanation, const Units& units);

/// Returns a string that lists the effects of an explanation without parameter values, such as "hysteresis at theta4
/// and link-bending at 4 places".
[[nodiscard]] std::string namesText(const calibration::Explanation& explanation);

/// Returns a clause that names the effects that no measurement could distinguish from the given effect; empty if there
/// are none.
[[nodiscard]] std::string indistinguishableText(const calibration::FoundEffect& effect);

/// Returns the conclusions of a diagnosis, one sentence per element.
[[nodiscard]] std::vector<std::string> diagnosisSentences(const calibration::Diagnosis& result, const Units& units);

/// Returns the sentences of diagnosisSentences(), joined by spaces.
[[nodiscard]] std::string diagnosisSentence(const calibration::Diagnosis& result, const Units& units);

/// Returns a found effect in the notation of AdditionRequest::causes.
[[nodiscard]] std::string additionText(const calibration::FoundEffect& found, const deflection::Arm& arm,
                                       const Units& units);

}  // namespace tubeplan::app
