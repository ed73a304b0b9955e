// Identification campaigns of the thesis (Calkins 1994, section 5.3) as least-squares problems.
#pragma once

#include <functional>
#include <memory>

#include "calibration/estimation/identification.hpp"
#include "calibration/estimation/least_squares.hpp"

namespace tubeplan::benchmarks {

struct Campaign {
  calibration::LeastSquaresProblem problem;
  /// Returns the largest relative error of a stiffness at the variables x.
  std::function<double(const Eigen::VectorXd& x)> error;
};

/// Returns the campaign of the Cobra on its mezzanine: 31 postures, each with 20, 30 and 40 lb on the tip, and six
/// unknown stiffnesses. The variables are the natural logarithms of the stiffnesses relative to their true values. They
/// start with an error of a factor of three, alternately up and down. The residuals are tip positions in the base frame
/// with noise of 0.02 in per coordinate, identical in every run.
[[nodiscard]] Campaign thesisCampaign();

/// Input for identifying the thesis's eleven stiffnesses: 45 unmeasured points, each touched without load and under 20,
/// 30 and 40 lb, within 0.0005 in (at 0.005 in, several stiffnesses are not identifiable). Stiffnesses that the thesis
/// found to be rigid are slightly compliant here, so that the touches determine all eleven. Each stiffness starts with
/// an error of a factor of three, alternately up and down.
struct TouchSession {
  calibration::PlacedArm start;
  std::vector<calibration::Measurement> measurements;
  std::vector<std::string> names;
  std::vector<double> truth;  ///< true value of each stiffness, in the order of the names
};
[[nodiscard]] std::shared_ptr<const TouchSession> touchSession();

/// Returns the touches of the TouchSession as the program's least-squares problem.
[[nodiscard]] Campaign touchCampaign();

}  // namespace tubeplan::benchmarks
