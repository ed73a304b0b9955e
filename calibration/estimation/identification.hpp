// The numbers of the model found from readings, each with its uncertainty and a word on whether the readings determine
// it (Calkins 1994, chapter 3).
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
  int starts = 1;               ///< the first as given, the others drawn around it
  std::uint64_t seed = 1;       ///< of the drawn starts and the folds
  int folds = 5;                ///< of the cross-validation by pose, where no reading is marked held-out; 0: none
  double outlier_level = 0.01;  ///< chance of naming any reading an outlier where there is none
  double drop_level = 0;        ///< above 0: numbers that the readings do not need at this level are given up
  bool intervals_by_profile = true;
  bool may_hold_all = false;                  ///< nothing free is no reason to refuse: the model is judged as it stands
  std::optional<ArmUncertainty> uncertainty;  ///< of the numbers that are held; none: what is determined is not asked
  WorkHooks hooks;                            ///< the solver is stopped by these too
  IterationObserver observe = {};  ///< of the fits to all readings, from every start; refits of some are not reported
};

enum class IdentificationStatus { kNotRun, kDone, kRefused, kNotConverged, kStopped };

struct IdentifiedNumber {
  Unknown unknown;
  double value = 0;  ///< of the parameter; of a base component: of its step
  double sigma = std::numeric_limits<double>::quiet_NaN();
  double lower = std::numeric_limits<double>::quiet_NaN();  ///< 95 % interval
  double upper = std::numeric_limits<double>::quiet_NaN();
  bool is_profile = false;  ///< the interval is by profile, not by sigma
  Identifiability identifiable = Identifiability::kNo;
  std::vector<std::string> with;  ///< names of the unknowns it is determined in combination with
  double prior_deviation = 0;     ///< from the arm's file, in standard deviations of its prior
  bool is_at_bound = false;
  /// Values of an effect's size with which the readings are explained equally, the most probable first; empty where
  /// only `value` does. The interval is over all.
  std::vector<double> modes;
  std::string note;  ///< one plain sentence where there is something to say
};

struct Outlier {
  int reading = -1;
  double size = 0;    ///< m, how far the reading is off by the fit without it
  double sigmas = 0;  ///< the same in noise sigmas
};

struct StrongCorrelation {
  std::string a, b;
  double value = 0;
};

/// Errors of a set of readings: root mean square, mean and largest of their lengths [m]. The length of an error is that
/// of all its rows together: of a measured place the distance to the predicted one, of an angle what it moves at
/// kTurnLever.
struct ErrorSize {
  double rms = std::numeric_limits<double>::quiet_NaN();
  double mean = std::numeric_limits<double>::quiet_NaN();
  double max = std::numeric_limits<double>::quiet_NaN();
  int readings = 0;
  bool are_angles = false;  ///< the readings measure nothing but angles
};

struct Identification {
  IdentificationStatus status = IdentificationStatus::kNotRun;
  std::string reason;
  std::vector<FreeProblem> problems;              ///< why refused: names that cannot be freed
  std::optional<ReadingProblem> reading_problem;  ///< why refused: readings that do not determine enough
  std::vector<std::string> dropped;               ///< "NAME: why", numbers that the readings do not need
  PlacedArm start, fitted;                        ///< with only the bases placed; with everything
  std::vector<IdentifiedNumber> numbers;
  Eigen::MatrixXd covariance;  ///< of the numbers' variables, in their order (compliances of stiffnesses)
  std::vector<StrongCorrelation> correlations;
  ErrorSize before, after_base, after;  ///< as the model stands; with only the bases fitted; with everything
  ErrorSize heldout_before, heldout;    ///< on readings kept from the fit; before: with only the bases fitted
  int not_judged = 0;                   ///< readings kept from the fit that it cannot judge (judgeable())
  double noise_floor = std::numeric_limits<double>::quiet_NaN();  ///< rms that noise alone leaves [m]
  double chi2 = std::numeric_limits<double>::quiet_NaN();
  int degrees_of_freedom = 0;  ///< of the readings, less the numbers that they determine; may be none
  double p_value = std::numeric_limits<double>::quiet_NaN();
  double model_error = 0;  ///< m, standard deviation of each coordinate beyond the noise, as the covariance has it:
                           ///< above 0 where chi-square refuses the stated noise
  std::optional<ArmUncertainty> uncertainty;  ///< of all the arm's numbers by the readings, where it was asked for
  std::vector<Outlier> outliers;
  Eigen::VectorXd errors;           ///< length of each fitted reading's error [m], in the order of `used`
  std::vector<int> used;            ///< readings that were fitted
  Eigen::VectorXd singular_values;  ///< of the readings' Jacobian, each column by its number's typical size
  int iterations = 0, evaluations = 0, jacobian_evaluations = 0;
  int starts_agreeing = 1;
};

/// The numbers in the order of the covariance, as variables that are 0 where the fit left them.
[[nodiscard]] std::vector<Unknown> fittedUnknowns(const Identification& result);

/// Finds the free numbers and the base poses that are not known. Readings marked held-out are not fitted but judged.
[[nodiscard]] Identification identify(const deflection::Arm& arm, const Eigen::Isometry3d& X_WB, bool base_known,
                                      const std::vector<Measurement>& readings, const IdentificationOptions& options);

/// One step of several: what it frees, and the set-up whose readings it uses (empty: all).
struct IdentificationStage {
  std::vector<std::string> names;
  std::string setup;
};

/// The thesis's way: each stage frees its own numbers with those of the stages before held where they were found, their
/// covariance carried into its own. Returns one result for each stage, up to one that is refused or stopped; the last
/// has the whole covariance in its sigmas.
[[nodiscard]] std::vector<Identification> identifyInStages(const PlacedArm& start,
                                                           const std::vector<Measurement>& readings,
                                                           const std::vector<IdentificationStage>& stages,
                                                           const IdentificationOptions& options);

/// The same from a state with a base pose for every set-up.
[[nodiscard]] Identification identify(const PlacedArm& start, const std::vector<Measurement>& readings,
                                      const IdentificationOptions& options);

}  // namespace tubeplan::calibration
