#include "calibration/estimation/determined_numbers.hpp"

#include <algorithm>

#include "calibration/estimation/prior.hpp"
#include "calibration/estimation/whitened_residual.hpp"

namespace tubeplan::calibration {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

namespace {

bool contains(const std::vector<Unknown>& unknowns, const std::string& name) {
  return std::ranges::any_of(unknowns, [&](const Unknown& unknown) { return unknown.name == name; });
}

/// Returns the uncertain parameters that the fit held fixed.
UncertainNumbers heldNumbers(const Identification& fit, const std::vector<Unknown>& fitted,
                             const ArmUncertainty& uncertainty) {
  UncertainNumbers all = uncertainNumbers(fit.fitted.arm, uncertainty), held;
  std::vector<Index> rows;
  for (std::size_t k = 0; k < all.unknowns.size(); ++k) {
    if (contains(fitted, all.unknowns[k].name)) continue;
    held.unknowns.push_back(all.unknowns[k]);
    rows.push_back(static_cast<Index>(k));
  }
  held.root = all.root(rows, Eigen::all);
  return held;
}

/// Returns true for unknowns that the result includes. A base step is included only if there is a single base pose,
/// because several base poses would each apply only to their own set-up.
bool isKept(const Unknown& unknown, const Identification& fit) {
  return unknown.owner == Unknown::Owner::kArm || fit.fitted.base_poses.size() == 1;
}

std::string nameOf(const Unknown& unknown) {
  return unknown.owner == Unknown::Owner::kBase ? baseStepNames()[static_cast<std::size_t>(unknown.component)]
                                                : unknown.name;
}

}  // namespace

std::optional<ArmUncertainty> determinedNumbers(const Identification& fit, const std::vector<Measurement>& measurements,
                                                const ArmUncertainty& held_numbers) {
  const std::vector<Unknown> fitted = fittedUnknowns(fit);
  const UncertainNumbers held = heldNumbers(fit, fitted, held_numbers);
  std::vector<Unknown> all = fitted;
  all.insert(all.end(), held.unknowns.begin(), held.unknowns.end());
  const auto weights = weighMeasurements(fit.fitted, measurements, {}, fit.model_error);
  if (!weights) return std::nullopt;
  const auto at = whitenedResidual(fit.fitted, all, measurements, *weights, zerosOf(all), true);
  if (!at.ok) return std::nullopt;
  // Variables: those of the fitted parameters, then independent standard normal variables for the parameters held
  // fixed.
  const auto own = static_cast<Index>(fitted.size()), n = static_cast<Index>(all.size());
  MatrixXd to_numbers = MatrixXd::Zero(n, own + held.root.cols());
  to_numbers.topLeftCorner(own, own).setIdentity();
  to_numbers.bottomRightCorner(n - own, held.root.cols()) = held.root;
  const MatrixXd jacobian = at.jacobian * to_numbers;
  VectorXd prior = VectorXd::Ones(to_numbers.cols()), gradient = jacobian.transpose() * at.r;
  prior.head(own) = priorSlopes(fitted).cwiseAbs2();
  gradient.head(own) += priorSlopes(fitted).cwiseProduct(priorResiduals(fitted, zerosOf(fitted)));
  const MatrixXd inverse = inverseOfInformation(jacobian.transpose() * jacobian + MatrixXd(prior.asDiagonal()));
  const VectorXd shift = inverse * gradient;  // step from the current values of the variables to the most probable ones
  const MatrixXd covariance = to_numbers * (inverse + shift * shift.transpose()) * to_numbers.transpose();
  ArmUncertainty determined = held_numbers;
  determined.determined.clear();
  std::vector<Index> kept;
  for (Index k = 0; k < n; ++k) {
    const Unknown& unknown = all[static_cast<std::size_t>(k)];
    if (!isKept(unknown, fit)) continue;
    determined.determined.push_back(nameOf(unknown));
    kept.push_back(k);
  }
  VectorXd slopes(static_cast<Index>(kept.size()));
  for (Index k = 0; k < slopes.size(); ++k)
    slopes[k] = slopeAt(all[static_cast<std::size_t>(kept[static_cast<std::size_t>(k)])], 0);
  determined.covariance = slopes.asDiagonal() * covariance(kept, kept) * slopes.asDiagonal();
  return determined;
}

}  // namespace tubeplan::calibration
