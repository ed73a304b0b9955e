// What a diagnosis is asked for.
#pragma once

#include <cstdint>

#include "calibration/estimation/identification.hpp"

namespace tubeplan::calibration {

struct DiagnosisOptions {
  IdentificationOptions baseline;  ///< what is free beside the causes
  double sure = 0.9;               ///< probability from which a cause, or a set of alternatives, is named
  double likely = 0.7;             ///< ... from which alternatives are, beside that something unknown is missing
  double nothing = 0.5;            ///< probability of nothing missing from which the model is adequate
  int most_causes = 3;             ///< in one explanation
  int most_leaders = 14;           ///< models that are fitted
  int folds = 5;
  std::uint64_t seed = 1;  ///< of the folds, and of the postures at which causes are held to be the same
  WorkHooks hooks;         ///< of the baseline too
};

}  // namespace tubeplan::calibration
