// Verdict of a diagnosis, with its name in files and its description for readers.
#pragma once

namespace tubeplan::calibration {

enum class Verdict {
  kNotRun,
  kAdequate,         ///< nothing is missing
  kExplained,        ///< one cause, or one set of them
  kPartlyExplained,  ///< sure causes, and a remainder that no cause explains
  kAmbiguous,        ///< one of several, or one or something unknown: these readings cannot distinguish them
  kUnexplained,      ///< something is missing, and no cause is sure
  kInconclusive,     ///< too few readings, or too weak a hint
  kStopped,
};

/// Returns the name in files: "adequate", "explained", ...
[[nodiscard]] const char* nameOf(Verdict verdict);

/// Returns the description for readers: "Adequate: nothing is missing", ...
[[nodiscard]] const char* wordsOf(Verdict verdict);

}  // namespace tubeplan::calibration
