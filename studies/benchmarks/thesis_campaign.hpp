// The thesis's identification (Calkins 1994, section 5.3) acted out again, as least-squares problems.
#pragma once

#include <functional>
#include <memory>

#include "calibration/estimation/identification.hpp"
#include "calibration/estimation/least_squares.hpp"

namespace tubeplan::benchmarks {

struct Campaign {
  calibration::LeastSquaresProblem problem;
  /// Largest relative error of a stiffness at the variables x.
  std::function<double(const Eigen::VectorXd& x)> error;
};

/// Cobra on its mezzanine, 31 postures, 20, 30 and 40 lb hung on the tip, six stiffnesses unknown. Variables are the
/// natural logarithms of the stiffnesses over their true values; they start a factor of three off, up and down in turn.
/// Residuals are tip places in the base frame, of 0.02 in noise each, the same in every run.
[[nodiscard]] Campaign thesisCampaign();

/// What the program is given to find the thesis's eleven stiffnesses: 45 points that nobody measured, each touched bare
/// and under 20, 30 and 40 lb, within 0.0005 in (at 0.005 in several of the eleven are not identifiable). Stiffnesses
/// that the thesis found to be rigid give a little here, so that the touches determine all eleven. Each starts a factor
/// of three off, up and down in turn.
struct TouchSession {
  calibration::PlacedArm start;
  std::vector<calibration::Measurement> readings;
  std::vector<std::string> names;
  std::vector<double> truth;  ///< of each name
};
[[nodiscard]] std::shared_ptr<const TouchSession> touchSession();

/// The same as the program's own least-squares problem.
[[nodiscard]] Campaign touchCampaign();

}  // namespace tubeplan::benchmarks
