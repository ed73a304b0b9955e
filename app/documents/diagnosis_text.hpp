// A diagnosis in words: its sentences, which pages and reports show as they are, and a screen for people.
#pragma once

#include <string>
#include <vector>

#include "app/files/units.hpp"
#include "calibration/diagnosis/diagnosis.hpp"

namespace tubeplan::app {

/// Of what remains where no term of the unknown discrepancy, smooth functions all, takes it.
inline constexpr const char* kFollowsNothing = "follows no slow function of what the readings record";

/// What the probabilities of a ranking are: each is of the models that the effect is part of.
inline constexpr const char* kProbabilityWords =
    "the probability of an effect is that it is there; several may be, so that these do not add to 100 %";

/// The ids of the readings at these places.
[[nodiscard]] std::vector<std::string> idsOf(const std::vector<int>& places,
                                             const std::vector<calibration::Measurement>& readings);

/// "hysteresis at theta4 and link-bending at 4 places".
[[nodiscard]] std::string namesText(const calibration::Explanation& explanation);

/// Which other effects no reading could tell from this one; empty where there are none.
[[nodiscard]] std::string alsoText(const calibration::FoundEffect& effect);

/// What a diagnosis comes to, sentence by sentence.
[[nodiscard]] std::vector<std::string> diagnosisSentences(const calibration::Diagnosis& result, const Units& units);

/// The same as one text.
[[nodiscard]] std::string diagnosisSentence(const calibration::Diagnosis& result, const Units& units);

[[nodiscard]] std::string diagnosisText(const calibration::Diagnosis& result,
                                        const std::vector<calibration::Measurement>& readings, const Units& units);

/// The command that adds the first alternative to the cell of this path; empty where there is none.
[[nodiscard]] std::string additionCommand(const calibration::Diagnosis& result, const std::string& cell,
                                          const Units& units);

/// An effect that a diagnosis found, as AdditionRequest::causes takes it.
[[nodiscard]] std::string additionText(const calibration::FoundEffect& found, const deflection::Arm& arm,
                                       const Units& units);

}  // namespace tubeplan::app
