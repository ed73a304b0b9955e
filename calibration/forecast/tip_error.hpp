// How far the true tip may be off, sideways, where a calibrated arm is sent to: by where the base may stand, by the
// joints' readings, and by what the arm does that its model does not have.
//
// The last is judged by the touches that placed the base. Whatever the model lacks is taken as a little of every effect
// of the catalogue and of every stiffness, each kind as likely to matter as any other, and of an error of every
// posture's own; all in one unknown proportion tau. The base takes up what it can of that at the touches, so that
//      y = (A G - 1) (D theta + w - n),     e = D_h theta + w_h + n_h - A_h G (D theta + w - n)
// with y the residuals at the touches, e the tip's error at a hole, A and A_h their slopes by the base, G what the
// touches' fit makes of errors, D and D_h the effects' columns (theta ~ N(0, tau^2)), w the errors of postures' own, n
// the noise. Z spans what no base takes up (Z^T A = 0): Z^T y determines tau, and for each tau what is known of e. With
// three touches Z has three columns, and tau a wide posterior: e is a mixture with tails like Student's. The prior of
// tau is half-Cauchy (Gelman 2006, "Prior distributions for variance parameters in hierarchical models").
#pragma once

#include <optional>
#include <vector>

#include "calibration/measurement.hpp"
#include "deflection/arm.hpp"

namespace tubeplan::calibration {

/// The model's error as somebody found it before: standard deviation of each coordinate of the tip, another in each
/// posture.
struct StatedModelError {
  double sigma = 0;            ///< m
  int degrees_of_freedom = 0;  ///< by which it was found; 0: known
};

struct TipErrorOptions {
  double usual_error = 4.4e-4;    ///< m per coordinate (0.030 in over a touch, table 5.6): scale of tau's prior
  double own_share = 0.25;        ///< of the model error's variance that is every posture's own
  double difference_share = 0.2;  ///< of an effect's plausible size, for its column
  int scales = 40;                ///< at which tau is looked at
};

/// What is asked: where the arm stands, and what is known of that.
struct TipErrorQuestion {
  const deflection::Arm& arm;
  Eigen::Isometry3d X_WB;
  double load = 0;                   ///< N
  std::vector<Measurement> touches;  ///< that placed the base; none: `base_covariance` has it
  Eigen::Matrix<double, 6, 6> base_covariance = Eigen::Matrix<double, 6, 6>::Zero();
  std::optional<StatedModelError> stated;
  std::vector<Eigen::VectorXd> postures;
};

/// Where the model's error comes from.
enum class ModelErrorSource { kLeftOut, kStated, kTouches };

/// One of the normal distributions of a mixture: sideways offset of the true tip from the model's [m].
struct TipErrorCase {
  double weight = 0;
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
};

struct TipError {
  ModelErrorSource source = ModelErrorSource::kLeftOut;
  /// m per coordinate: of the model's error that no base takes up, the median of its posterior and where it lies in
  /// 95 %.
  double model_error = 0, lower = 0, upper = 0;
  std::vector<std::vector<TipErrorCase>> at;  ///< for each posture; weights add up to 1
};

[[nodiscard]] TipError findTipError(const TipErrorQuestion& question, const TipErrorOptions& options = {});

}  // namespace tubeplan::calibration
