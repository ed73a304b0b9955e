#include "calibration/estimation/profile_interval.hpp"

#include <algorithm>
#include <cmath>

#include "calibration/estimation/prior.hpp"

namespace tubeplan::calibration {

using Eigen::Index, Eigen::VectorXd;

namespace {

constexpr double kRise = 3.841458820694124;  // 95 % quantile of chi-square with one degree of freedom
constexpr int kMaxSteps = 12;
constexpr double kFarthest = 40;  // an interval that extends farther from the optimum is treated as unbounded [sigmas]

/// Returns solver options for refits, which start close to their solution.
LeastSquaresOptions nearby(const StopQuestion& stop) {
  return {1e-6, 30, LeastSquaresMethod::kLevenbergMarquardt, stop};
}

struct Profile {
  const PlacedArm& start;
  const std::vector<Unknown>& unknowns;
  const std::vector<Measurement>& measurements;
  const Fit& best;
  int variable;
  double least;  ///< chi-square of measurements and priors at the optimum
  LeastSquaresOptions solver;

  /// Refits with the variable fixed at `offset` from the optimum, and returns sqrt(rise of chi-square / kRise) - 1: -1
  /// at the optimum, 0 at an end of the interval.
  [[nodiscard]] double riseAt(double offset, VectorXd& x) const {
    std::vector<Unknown> fixed = unknowns;
    const double value = best.solution.x[variable] + offset;
    fixed[static_cast<std::size_t>(variable)].lower = fixed[static_cast<std::size_t>(variable)].upper = value;
    x[variable] = value;
    const auto solution =
        minimizeOrUnwind(fitProblem(start, fixed, measurements, best.weights, x, solver.stop), solver);
    if (solution.status == LeastSquaresStatus::kFailed) return kNotKnown;
    x = solution.x;
    return std::sqrt(std::max(0., solution.chi2 - least) / kRise) - 1;
  }

  /// Returns the offset in one direction at which chi-square has risen by kRise; infinite if it never rises that far.
  [[nodiscard]] double end(double direction, double sigma) const {
    const Unknown& unknown = unknowns[static_cast<std::size_t>(variable)];
    const double room =
        direction > 0 ? unknown.upper - best.solution.x[variable] : best.solution.x[variable] - unknown.lower;
    double inside = 0, inside_rise = -1, outside = kNotKnown, outside_rise = 0;
    double step = std::min(1.96 * sigma, room);
    VectorXd x = best.solution.x;
    for (int n = 0; n < kMaxSteps; ++n) {
      const double rise = riseAt(direction * step, x);
      if (std::isnan(rise)) break;
      if (std::abs(rise) < 1e-3) return direction * step;
      if (rise < 0) {
        if (step >= room || step > kFarthest * sigma) return direction * std::numeric_limits<double>::infinity();
        inside = step, inside_rise = rise;
      } else {
        outside = step, outside_rise = rise;
      }
      step = std::isnan(outside)
                 ? std::min(room, std::max(step * 1.5, std::min(3 * step, step / std::max(0.2, 1 + rise))))
                 : inside + (outside - inside) * std::clamp(-inside_rise / (outside_rise - inside_rise), 0.05, 0.95);
    }
    return direction * (std::isnan(outside) ? std::numeric_limits<double>::infinity() : outside);
  }
};

}  // namespace

ProfileInterval profileInterval(const PlacedArm& start, const std::vector<Unknown>& unknowns,
                                const std::vector<Measurement>& measurements, const Fit& best, int variable,
                                double sigma, const StopQuestion& stop) {
  const double least = best.solution.chi2 + priorResiduals(unknowns, best.solution.x).squaredNorm();
  const Profile profile{start, unknowns, measurements, best, variable, least, nearby(stop)};
  const double at = best.solution.x[variable];
  return {at + profile.end(-1, sigma), at + profile.end(1, sigma)};
}

}  // namespace tubeplan::calibration
