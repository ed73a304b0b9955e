// Identification of a model's parameters from measurements, each with its uncertainty and a verdict on whether the
// measurements determine it (Calkins 1994, chapter 3).
//
// Example, compiled and run by tests/examples:
//
//     #include "calibration/estimation/identification.hpp"
//     #include "calibration/measurements/measurement_placement.hpp"
//     #include "calibration/measurements/measurement_prediction.hpp"
//     using namespace tubeplan;
//     deflection::Arm arm;
//     auto& row = (arm.rows.resize(1), arm.rows.front().name = "link", arm.rows.front());
//     row.placement = deflection::Origin<double>{{0, 0, 1}, {1.5707963267948966, 0, 0}};
//     row.joint = {.name = "shoulder", .type = deflection::JointType::kRevolute};
//     row.joint_stiffness.z() = 1e5;  // N m/rad, as drawn
//     arm.p_LT = {2, 0, 0};
//     deflection::Arm real = arm;
//     real.rows.front().joint_stiffness.z() = 8e4;
//     const Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
//     std::vector<calibration::Measurement> measurements;
//     for (int k = 0; k < 12; ++k) {
//       auto& measurement = measurements.emplace_back();
//       measurement.id = std::to_string(k);
//       measurement.q = Eigen::VectorXd::Constant(1, 0.1 * k);
//       measurement.load = 50 * (k % 3);  // N
//       measurement.sigma = 1e-5;         // m
//       measurement.p_W = calibration::predictTip(real, X_WB, measurement.q, measurement.load).value;
//     }
//     calibration::IdentificationOptions options;
//     options.free.names = {"link.joint_stiffness.z"};
//     const auto start = calibration::placeForMeasurements(arm, X_WB, true, measurements);
//     const auto found = calibration::identify(start, measurements, options);
//     std::printf("%.0f\n", found.numbers.front().value);  // prints 80000
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "calibration/estimation/arm_uncertainty.hpp"
#include "calibration/estimation/identifiability.hpp"
#include "calibration/estimation/least_squares.hpp"
#include "calibration/estimation/whitened_residual.hpp"
#include "calibration/measurements/measurement_problems.hpp"

namespace tubeplan::calibration {

enum class RobustLoss { kNone, kHuber, kCauchy };

struct IdentificationOptions {
  FreeChoice free;
  LeastSquaresOptions solver;
  RobustLoss loss = RobustLoss::kNone;
  int starts = 1;          ///< number of starting points: the given one, plus random ones around it
  std::uint64_t seed = 1;  ///< seed of the random starts and of the assignment to folds
  /// Number of folds of the cross-validation, which is done if no measurement is marked as held out; 0 disables it.
  int folds = 5;
  double outlier_level = 0.01;  ///< probability that some measurement is reported as an outlier although there is none
  /// If above 0, parameters that are not significant at this level are dropped from the fit, one at a time.
  double drop_level = 0;
  bool intervals_by_profile = true;
  bool may_hold_all = false;  ///< true if a model without free parameters is evaluated; false if it is refused
  /// Uncertainty of the parameters that are held fixed. If empty, Identification::uncertainty is not computed.
  std::optional<ArmUncertainty> uncertainty;
  WorkHooks hooks;  ///< progress report and stop request, which also stops the solver
  /// Called at every iteration of a fit to all measurements, from each start, but not in fits to a part of the
  /// measurements.
  IterationObserver observe = {};
};

enum class IdentificationStatus { kNotRun, kDone, kRefused, kNotConverged, kStopped };

struct IdentifiedNumber {
  Unknown unknown;
  double value = 0;  ///< value of the parameter; for a component of a base pose, its step
  double sigma = kNotKnown;
  double lower = kNotKnown;  ///< lower end of the 95 % interval
  double upper = kNotKnown;
  bool is_profile = false;  ///< true if the interval is a likelihood-profile interval; false if it follows from `sigma`
  Identifiability identifiable = Identifiability::kNo;
  /// Names of the unknowns with which the errors of this one are correlated, for kInCombination.
  std::vector<std::string> with;
  double prior_deviation = 0;  ///< distance of the variable from its prior's mean, in standard deviations of the prior
  bool is_at_bound = false;
  /// For the magnitude of an effect: values that explain the measurements equally well, most probable first; empty if
  /// `value` is the only one. The interval covers all of them.
  std::vector<double> modes;
  std::string note;  ///< note for the user, as a sentence; may be empty
};

struct Outlier {
  int measurement = -1;
  double size = 0;    ///< error of the measurement relative to the fit without it [m]
  double sigmas = 0;  ///< `size` divided by the standard deviation of the noise
};

struct StrongCorrelation {
  std::string a, b;
  double value = 0;
};

/// Root mean square, mean and maximum of the errors of a set of measurements [m]. The error of a position is the
/// distance between measured and predicted position; the error of an angle is the difference times kTurnLever.
struct ErrorSize {
  double rms = kNotKnown;
  double mean = kNotKnown;
  double max = kNotKnown;
  int measurements = 0;
  bool are_angles = false;  ///< true if all measurements measure only angles
};

struct Identification {
  IdentificationStatus status = IdentificationStatus::kNotRun;
  std::string reason;
  std::vector<FreeProblem> problems;  ///< reasons why names cannot be freed, if the status is kRefused
  /// Reason why the measurements do not determine enough, if the status is kRefused.
  std::optional<MeasurementProblem> measurement_problem;
  std::vector<std::string>
      dropped;              ///< parameters dropped because the measurements do not require them, as "NAME: why"
  PlacedArm start, fitted;  ///< model with its bases placed before the fit, and model after the fit
  std::vector<IdentifiedNumber> numbers;
  /// Covariance of the variables of `numbers`, in the same order (compliances for stiffnesses).
  Eigen::MatrixXd covariance;
  std::vector<StrongCorrelation> correlations;
  /// Errors of the fitted measurements relative to the model before any fit, with only the bases fitted, and with all
  /// unknowns fitted.
  ErrorSize before, after_base, after;
  /// Errors of held-out measurements relative to the model with only the bases fitted, and with all unknowns fitted.
  ErrorSize heldout_before, heldout;
  int not_judged = 0;              ///< number of held-out measurements that the fit cannot predict; see judgeable()
  double noise_floor = kNotKnown;  ///< rms error due to noise alone [m]
  double chi2 = kNotKnown;
  /// Number of rows less the number of parameters and unknown places that they determine; may be zero or negative.
  int degrees_of_freedom = 0;
  double p_value = kNotKnown;
  /// Standard deviation of the model error of each coordinate [m], which the covariance takes into account; above 0 if
  /// the residuals are too large for the stated noise.
  double model_error = 0;
  /// Uncertainty of all parameters of the arm, given the measurements; empty if not requested.
  std::optional<ArmUncertainty> uncertainty;
  std::vector<Outlier> outliers;
  Eigen::VectorXd errors;  ///< length of each fitted measurement's error [m], in the order of `used`
  std::vector<int> used;   ///< indices of the fitted measurements
  /// Singular values of the measurements' Jacobian with respect to the parameters divided by their typical sizes.
  Eigen::VectorXd singular_values;
  int iterations = 0, evaluations = 0, jacobian_evaluations = 0;
  int starts_agreeing = 1;
};

/// Returns the identified parameters in the order of `result.covariance`, as unknowns whose variables are 0 at the fit.
[[nodiscard]] std::vector<Unknown> fittedUnknowns(const Identification& result);

/// Identifies the free parameters and the unknown base poses. Measurements marked held-out are not fitted, but used to
/// validate the fit.
[[nodiscard]] Identification identify(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB, bool base_known,
                                      const std::vector<Measurement>& measurements,
                                      const IdentificationOptions& options);

/// One stage of an identification: names of the parameters that it frees, and the set-up whose measurements it uses
/// (empty means all measurements).
struct IdentificationStage {
  std::vector<std::string> names;
  std::string setup;
};

/// Identifies parameters in stages, as in Calkins 1994; each stage frees its own parameters. Those found in earlier
/// stages are held at their values, and their uncertainty contributes to the sigmas of later stages. Returns one result
/// per stage, up to the first stage that is refused or stopped.
[[nodiscard]] std::vector<Identification> identifyInStages(const PlacedArm& start,
                                                           const std::vector<Measurement>& measurements,
                                                           const std::vector<IdentificationStage>& stages,
                                                           const IdentificationOptions& options);

/// Identifies like identify() above, but starts from an arm that already has a base pose for every set-up.
[[nodiscard]] Identification identify(const PlacedArm& start, const std::vector<Measurement>& measurements,
                                      const IdentificationOptions& options);

}  // namespace tubeplan::calibration
