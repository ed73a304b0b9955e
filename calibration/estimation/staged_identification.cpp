#include <algorithm>
#include <cmath>
#include <tuple>

#include "calibration/estimation/fit.hpp"
#include "calibration/estimation/identification.hpp"
#include "deflection/resized.hpp"

namespace tubeplan::calibration {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

namespace {

/// Unknowns found in the stages so far, with variables that are 0 at the current state, and their covariance.
struct Found {
  std::vector<Unknown> unknowns;
  MatrixXd covariance;
};

/// Returns the indices of the measurements of a set-up; of all measurements if `setup` is empty.
std::vector<int> placesOf(const std::vector<Measurement>& all, const std::string& setup) {
  std::vector<int> places;
  for (std::size_t k = 0; k < all.size(); ++k)
    if (setup.empty() || all[k].setup == setup) places.push_back(static_cast<int>(k));
  return places;
}

/// Converts indices in a stage's result, which refer to the stage's own measurements, to indices among all
/// measurements.
void countAmongAll(const std::vector<int>& places, Identification& stage) {
  const auto rename = [&](int& measurement) { measurement = places[static_cast<std::size_t>(measurement)]; };
  for (auto& outlier : stage.outliers) rename(outlier.measurement);
  for (int& measurement : stage.used) rename(measurement);
  if (stage.measurement_problem && stage.measurement_problem->measurement >= 0)
    rename(stage.measurement_problem->measurement);
}

/// Recomputes sigmas and intervals after the covariance of the stage has been increased.
void inflateCovariance(Identification& stage) {
  for (std::size_t i = 0; i < stage.numbers.size(); ++i) {
    auto& number = stage.numbers[i];
    const double sigma = std::sqrt(stage.covariance(static_cast<Index>(i), static_cast<Index>(i)));
    const Unknown unknown = rebased(number.unknown, number.value);
    number.sigma = sigma * std::abs(slopeAt(unknown, 0));
    std::tie(number.lower, number.upper) = valuesBetween(unknown, -1.959964 * sigma, 1.959964 * sigma);
    number.is_profile = false;
  }
}

/// Adds the effect of held parameters' uncertainty to a stage's covariance. Errors e of these parameters move the
/// stage's optimum by A e, where A = -C J^T J_held and C is the posterior covariance of the stage.
void carry(const std::vector<Measurement>& measurements, Found& found, Identification& stage) {
  auto own = fittedUnknowns(stage);
  const auto weights = weighMeasurements(stage.fitted, measurements, {}, stage.model_error);
  std::vector<Unknown> both = own;
  both.insert(both.end(), found.unknowns.begin(), found.unknowns.end());
  if (!weights) return;
  const auto residual = whitenedResidual(stage.fitted, both, measurements, *weights, zerosOf(both), true);
  if (!residual.ok) return;
  const auto n = static_cast<Index>(own.size()), held = static_cast<Index>(found.unknowns.size());
  const MatrixXd J = residual.jacobian.leftCols(n), J_held = residual.jacobian.rightCols(held);
  const MatrixXd A = -stage.covariance * (J.transpose() * J_held);
  const MatrixXd cross = found.covariance * A.transpose();
  stage.covariance += A * cross;
  inflateCovariance(stage);
  MatrixXd joint_covariance(n + held, n + held);
  joint_covariance << stage.covariance, cross.transpose(), cross, found.covariance;
  found.covariance = std::move(joint_covariance);
  found.unknowns = both;
}

/// Returns true if the stage frees a parameter that an earlier stage found, and therefore does not hold it fixed.
bool isFreed(const Identification& stage, const Unknown& number) {
  return std::ranges::any_of(stage.numbers,
                             [&](const IdentifiedNumber& own) { return own.unknown.name == number.name; });
}

}  // namespace

std::vector<Identification> identifyInStages(const PlacedArm& start, const std::vector<Measurement>& measurements,
                                             const std::vector<IdentificationStage>& stages,
                                             const IdentificationOptions& options) {
  std::vector<Identification> results;
  PlacedArm state = start;
  Found found;
  found.covariance.resize(0, 0);
  for (const auto& stage : stages) {
    IdentificationOptions now = options;
    now.free.names = stage.names;
    now.uncertainty.reset();  // the measurements of one stage do not determine the uncertainty after all measurements
    const auto places = placesOf(measurements, stage.setup);
    PlacedArm from{state.arm, {}};
    for (const auto& base_pose : state.base_poses)
      if (stage.setup.empty() || base_pose.setup == stage.setup) from.base_poses.push_back(base_pose);
    results.push_back(identify(from, picked(measurements, places), now));
    Identification& result = results.back();
    countAmongAll(places, result);
    if (result.status == IdentificationStatus::kRefused || result.fitted.arm.rows.empty()) return results;
    // Only parameters of the arm are carried over, because each stage finds its own base poses.
    Found carried;
    std::vector<Index> arm_numbers;
    for (std::size_t k = 0; k < found.unknowns.size(); ++k)
      if (found.unknowns[k].owner == Unknown::Owner::kArm && !isFreed(result, found.unknowns[k])) {
        carried.unknowns.push_back(found.unknowns[k]);
        arm_numbers.push_back(static_cast<Index>(k));
      }
    carried.covariance = found.covariance(arm_numbers, arm_numbers);
    if (results.size() == 1) {
      carried.unknowns = fittedUnknowns(result);
      deflection::takeSized(carried.covariance, result.covariance);
    } else {
      carry(picked(measurements, result.used), carried, result);
    }
    found = std::move(carried);
    state.arm = result.fitted.arm;
    for (const auto& base_pose : result.fitted.base_poses)
      for (auto& known : state.base_poses)
        if (known.setup == base_pose.setup) known.X_WB = base_pose.X_WB;
  }
  return results;
}

}  // namespace tubeplan::calibration
