// Identification of the thesis (Calkins 1994, section 5.3), repeated as least-squares problems.
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

/// Returns the campaign of the Cobra on its mezzanine: 31 postures, 20, 30 and 40 lb hung on the tip, six unknown
/// stiffnesses. Variables are the natural logarithms of the stiffnesses over their true values; they start off by a
/// factor of three, up and down in turn. Residuals are tip positions in the base frame, with noise of 0.02 in each, the
/// same in every run.
[[nodiscard]] Campaign thesisCampaign();

/// Input for the thesis's eleven stiffnesses: 45 unmeasured points, each touched bare and under 20, 30 and 40 lb,
/// within 0.0005 in (at 0.005 in several of the eleven are not identifiable). Stiffnesses that the thesis found to be
/// rigid are slightly compliant here, so that the touches determine all eleven. Each starts off by a factor of three,
/// up and down in turn.
struct TouchSession {
  calibration::PlacedArm start;
  std::vector<calibration::Measurement> readings;
  std::vector<std::string> names;
  std::vector<double> truth;  ///< true value of each name
};
[[nodiscard]] std::shared_ptr<const TouchSession> touchSession();

/// Returns the same session as the program's own least-squares problem.
[[nodiscard]] Campaign touchCampaign();

}  // namespace tubeplan::benchmarks
