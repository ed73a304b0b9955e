// The thesis's identification (Calkins 1994, section 5.3) acted out again: Cobra on its mezzanine, 31 postures, 20, 30
// and 40 lb hung on the tip, six stiffnesses unknown.
#pragma once

#include "calibration/least_squares.hpp"

namespace tubeplan::benchmarks {

struct Campaign {
  calibration::LeastSquaresProblem problem;
  Eigen::VectorXd truth;  ///< the variables of the arm that was measured
};

/// Variables are the natural logarithms of six stiffnesses over their true values; they start a factor of three off,
/// up and down in turn. Residuals are tip places in the base frame, of 0.02 in noise each, the same in every run.
[[nodiscard]] Campaign thesisCampaign();

}  // namespace tubeplan::benchmarks
