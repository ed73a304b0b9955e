// Options of a diagnosis.
#pragma once

#include <cstdint>

#include "calibration/estimation/identification.hpp"

namespace tubeplan::calibration {

struct DiagnosisOptions {
  IdentificationOptions baseline;  ///< baseline fit; its free numbers stay free beside the causes
  double sure = 0.9;               ///< least probability for which a cause, or a set of alternatives, is named
  double likely = 0.7;             ///< least probability for which alternatives are named beside an unknown remainder
  double nothing = 0.5;            ///< least probability of nothing missing for which the model is adequate
  int most_causes = 3;             ///< most causes in one explanation
  int most_leaders = 14;           ///< most models that are fitted
  int folds = 5;
  std::uint64_t seed = 1;  ///< seed of the folds, and of the postures that are used to compare causes
  WorkHooks hooks;         ///< hooks of the diagnosis and of its baseline
};

}  // namespace tubeplan::calibration
