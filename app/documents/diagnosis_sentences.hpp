// A diagnosis in words: its sentences, which texts, pages and reports show as they are.
#pragma once

#include <string>
#include <vector>

#include "app/formats/units.hpp"
#include "calibration/diagnosis/diagnosis.hpp"

namespace tubeplan::app {

/// Predicate of a remainder that no slow function of the measurements' conditions explains.
inline constexpr const char* kFollowsNothing = "follows no slow function of what the readings record";

/// What the probabilities of a ranking are: each is of the models that the effect is part of.
inline constexpr const char* kProbabilityWords =
    "the probability of an effect is that it is there; several may be, so that these do not add to 100 %";

/// The ids of the readings at these places.
[[nodiscard]] std::vector<std::string> idsOf(const std::vector<int>& places,
                                             const std::vector<calibration::Measurement>& readings);

/// "half width 0.0586 ± 0.0010 deg"; of a size that the readings leave open "x -0.040 to 0.042 in".
[[nodiscard]] std::string numberText(const calibration::FoundNumber& number, const Units& units);

/// "hysteresis at theta4 (half width 0.0586 ± 0.0010 deg) and ...".
[[nodiscard]] std::string sizesText(const calibration::Explanation& explanation, const Units& units);

/// "hysteresis at theta4 and link-bending at 4 places".
[[nodiscard]] std::string namesText(const calibration::Explanation& explanation);

/// Which other effects no reading could tell from this one; empty where there are none.
[[nodiscard]] std::string alsoText(const calibration::FoundEffect& effect);

/// What a diagnosis comes to, sentence by sentence.
[[nodiscard]] std::vector<std::string> diagnosisSentences(const calibration::Diagnosis& result, const Units& units);

/// The same as one text.
[[nodiscard]] std::string diagnosisSentence(const calibration::Diagnosis& result, const Units& units);

/// An effect that a diagnosis found, as AdditionRequest::causes takes it.
[[nodiscard]] std::string additionText(const calibration::FoundEffect& found, const deflection::Arm& arm,
                                       const Units& units);

}  // namespace tubeplan::app
