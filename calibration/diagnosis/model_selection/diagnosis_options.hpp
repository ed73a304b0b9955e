// Options of a diagnosis.
#pragma once

#include <cstdint>

#include "calibration/estimation/identification.hpp"

namespace tubeplan::calibration {

struct DiagnosisOptions {
  IdentificationOptions baseline;  ///< baseline fit; its free parameters stay free in the fits with causes
  double sure = 0.9;               ///< least probability for which a cause, or a set of alternatives, is named
  double likely = 0.7;    ///< least probability for which alternatives are named that may leave unexplained errors
  double nothing = 0.5;   ///< least probability of nothing missing for which the model is judged adequate
  int most_causes = 3;    ///< most causes in one explanation
  int most_leaders = 14;  ///< most models that are fitted
  int folds = 5;
  std::uint64_t seed = 1;  ///< seed for the folds and for the postures at which causes are compared
  WorkHooks hooks;         ///< hooks of the diagnosis and of its baseline fit
};

}  // namespace tubeplan::calibration
