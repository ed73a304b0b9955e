// Options for diagnosing which physical effects a model lacks.
#pragma once

#include <cstdint>

#include "calibration/estimation/identification.hpp"

namespace tubeplan::calibration {

struct DiagnosisOptions {
  IdentificationOptions baseline;     ///< baseline fit; its free parameters stay free in the fits with causes
  double required_probability = 0.9;  ///< smallest probability at which a cause, or a set of alternatives, is named
  /// Smallest total probability at which alternatives are named, even though errors may remain unexplained.
  double likely = 0.7;
  /// The model is judged adequate only if nothing is missing with at least this probability.
  double nothing = 0.5;
  int most_causes = 3;    ///< maximum number of causes in one explanation
  int most_leaders = 14;  ///< maximum number of models that are fitted
  int folds = 5;
  std::uint64_t seed = 1;  ///< seed for the folds and for the postures at which causes are compared
  WorkHooks hooks;         ///< hooks of the diagnosis and of its baseline fit
};

}  // namespace tubeplan::calibration
