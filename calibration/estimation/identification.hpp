// The numbers of the model found from readings, each with its uncertainty and whether the readings determine it
// (Calkins 1994, chapter 3).
//
// Example, compiled and run by tests/examples:
//
//     #include "calibration/estimation/identification.hpp"
//     #include "calibration/measurements/reading_placement.hpp"
//     #include "calibration/measurements/reading_prediction.hpp"
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
//     std::vector<calibration::Measurement> readings;
//     for (int k = 0; k < 12; ++k) {
//       auto& reading = readings.emplace_back();
//       reading.id = std::to_string(k);
//       reading.q = Eigen::VectorXd::Constant(1, 0.1 * k);
//       reading.load = 50 * (k % 3);  // N
//       reading.sigma = 1e-5;         // m
//       reading.p_W = calibration::predictTip(real, X_WB, reading.q, reading.load).value;
//     }
//     calibration::IdentificationOptions options;
//     options.free.names = {"link.joint_stiffness.z"};
//     const auto start = calibration::placeForReadings(arm, X_WB, true, readings);
//     const auto found = calibration::identify(start, readings, options);
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
#include "calibration/measurements/reading_problems.hpp"

namespace tubeplan::calibration {

enum class RobustLoss { kNone, kHuber, kCauchy };

struct IdentificationOptions {
  FreeChoice free;
  LeastSquaresOptions solver;
  RobustLoss loss = RobustLoss::kNone;
  int starts = 1;               ///< number of starts: the first as given, the others drawn around it
  std::uint64_t seed = 1;       ///< seed of the drawn starts and the folds
  int folds = 5;                ///< folds of the cross-validation by pose, if no reading is marked held-out; 0: none
  double outlier_level = 0.01;  ///< chance of naming any reading an outlier if there is none
  double drop_level = 0;        ///< above 0: numbers that the readings do not need at this level are dropped
  bool intervals_by_profile = true;
  bool may_hold_all = false;  ///< true: a model without free numbers is judged as it stands; false: it is refused
  /// Uncertainty of the numbers that are held; nothing: determined numbers are not computed.
  std::optional<ArmUncertainty> uncertainty;
  WorkHooks hooks;  ///< also stop the solver
  /// Called for the fits to all readings, from every start, but not for refits of some.
  IterationObserver observe = {};
};

enum class IdentificationStatus { kNotRun, kDone, kRefused, kNotConverged, kStopped };

struct IdentifiedNumber {
  Unknown unknown;
  double value = 0;  ///< of the parameter; of a base component: of its step
  double sigma = kNotKnown;
  double lower = kNotKnown;  ///< 95 % interval
  double upper = kNotKnown;
  bool is_profile = false;  ///< the interval is by profile, not by sigma
  Identifiability identifiable = Identifiability::kNo;
  std::vector<std::string> with;  ///< names of the unknowns that it is determined in combination with
  double prior_deviation = 0;     ///< deviation from the arm's file, in standard deviations of its prior
  bool is_at_bound = false;
  /// Values of an effect's size that explain the readings equally well, most probable first; empty if only `value`
  /// does. The interval covers all.
  std::vector<double> modes;
  std::string note;  ///< a sentence for the user, or empty
};

struct Outlier {
  int reading = -1;
  double size = 0;    ///< error of the reading against the fit without it [m]
  double sigmas = 0;  ///< `size` in noise sigmas
};

struct StrongCorrelation {
  std::string a, b;
  double value = 0;
};

/// Errors of a set of readings: root mean square, mean and largest of their lengths [m]. The length of an error
/// combines all its rows: for a measured place the distance to the predicted one, for an angle the angle times
/// kTurnLever.
struct ErrorSize {
  double rms = kNotKnown;
  double mean = kNotKnown;
  double max = kNotKnown;
  int readings = 0;
  bool are_angles = false;  ///< true: all readings measure angles alone
};

struct Identification {
  IdentificationStatus status = IdentificationStatus::kNotRun;
  std::string reason;
  std::vector<FreeProblem> problems;              ///< names that cannot be freed, if refused
  std::optional<ReadingProblem> reading_problem;  ///< readings that do not determine enough, if refused
  std::vector<std::string> dropped;               ///< numbers that the readings do not need, "NAME: why"
  PlacedArm start, fitted;                        ///< model with only the bases placed; with everything fitted
  std::vector<IdentifiedNumber> numbers;
  Eigen::MatrixXd covariance;  ///< covariance of the numbers' variables, in their order (compliances for stiffnesses)
  std::vector<StrongCorrelation> correlations;
  ErrorSize before, after_base, after;  ///< as the model stands; with only the bases fitted; with everything
  ErrorSize heldout_before, heldout;    ///< on readings kept from the fit; before: with only the bases fitted
  int not_judged = 0;                   ///< readings kept from the fit that it cannot judge (judgeable())
  double noise_floor = kNotKnown;       ///< rms that noise alone leaves [m]
  double chi2 = kNotKnown;
  int degrees_of_freedom = 0;  ///< of the readings, less the numbers that they determine; may be none
  double p_value = kNotKnown;
  double model_error = 0;  ///< m, standard deviation of each coordinate beyond the noise, as the covariance has it:
                           ///< above 0 where chi-square refuses the stated noise
  std::optional<ArmUncertainty> uncertainty;  ///< of all the arm's numbers by the readings, where it was asked for
  std::vector<Outlier> outliers;
  Eigen::VectorXd errors;  ///< length of each fitted reading's error [m], in the order of `used`
  std::vector<int> used;   ///< indices of the fitted readings
  /// Singular values of the readings' Jacobian, each column scaled by its number's typical size.
  Eigen::VectorXd singular_values;
  int iterations = 0, evaluations = 0, jacobian_evaluations = 0;
  int starts_agreeing = 1;
};

/// Returns the numbers in the order of the covariance, as variables that are 0 at the fit.
[[nodiscard]] std::vector<Unknown> fittedUnknowns(const Identification& result);

/// Finds the free numbers and the unknown base poses. Readings marked held-out are not fitted but judged.
[[nodiscard]] Identification identify(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB, bool base_known,
                                      const std::vector<Measurement>& readings, const IdentificationOptions& options);

/// A stage of an identification: the numbers that it frees, and the set-up whose readings it uses (empty: all).
struct IdentificationStage {
  std::vector<std::string> names;
  std::string setup;
};

/// Identifies in stages, as in the thesis: each stage frees its own numbers with those of earlier stages held at their
/// values, whose covariance is carried over. Returns one result for each stage, up to one that is refused or stopped.
/// The sigmas of the last include the whole covariance.
[[nodiscard]] std::vector<Identification> identifyInStages(const PlacedArm& start,
                                                           const std::vector<Measurement>& readings,
                                                           const std::vector<IdentificationStage>& stages,
                                                           const IdentificationOptions& options);

/// Identifies from a state with a base pose for every set-up.
[[nodiscard]] Identification identify(const PlacedArm& start, const std::vector<Measurement>& readings,
                                      const IdentificationOptions& options);

}  // namespace tubeplan::calibration
