// Verdict of a diagnosis, with its name in files and its description for users.
#pragma once

namespace tubeplan::calibration {

enum class Verdict {
  kNotRun,
  kAdequate,         ///< nothing is missing
  kExplained,        ///< one cause, or one set of causes, explains the errors
  kPartlyExplained,  ///< some causes are certain, and errors remain that no cause explains
  kAmbiguous,        ///< these measurements cannot distinguish several causes, or a cause from an unknown effect
  kUnexplained,      ///< an effect is missing, and no cause is certain
  kInconclusive,     ///< too few measurements, or too weak evidence
  kStopped,
};

/// Returns the verdict's name in files: "adequate", "explained", ...
[[nodiscard]] const char* nameOf(Verdict verdict);

/// Returns the verdict's description for users: "Adequate: nothing is missing", ...
[[nodiscard]] const char* wordsOf(Verdict verdict);

}  // namespace tubeplan::calibration
