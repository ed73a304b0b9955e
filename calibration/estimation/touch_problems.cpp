// Detects touches that cannot determine a base, before any fit is attempted.
#include <algorithm>
#include <set>

#include "calibration/estimation/base_calibration.hpp"

namespace tubeplan::calibration {

namespace {

/// Holes closer than this are treated as the same hole [m] (0.1 in). The holes of a tube sheet are farther apart.
constexpr double kSameHole = 2.5e-3;

/// Returns the spread of the points perpendicular to their best-fit line, relative to their spread along the line; zero
/// if they lie on a line.
double flatness(const std::vector<Measurement>& touches) {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  for (const auto& touch : touches) centre += (*touch.p_W) / static_cast<double>(touches.size());
  Eigen::Matrix3Xd points(3, touches.size());
  for (std::size_t k = 0; k < touches.size(); ++k) points.col(static_cast<Eigen::Index>(k)) = *touches[k].p_W - centre;
  const Eigen::Vector3d spread = Eigen::JacobiSVD<Eigen::MatrixXd>(points).singularValues();
  return spread[0] > 0 ? spread[1] / spread[0] : 0;
}

}  // namespace

std::string findTouchProblem(const std::vector<Measurement>& touches, const BaseCalibrationOptions& options) {
  for (std::size_t i = 0; i < touches.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (touches[i].point != touches[j].point && (*touches[i].p_W - *touches[j].p_W).norm() < kSameHole)
        return "holes " + touches[j].point + " and " + touches[i].point + " are at the same position";
  std::set<std::string> holes;
  for (std::size_t k = 0; k < touches.size(); ++k) {
    const Measurement& touch = touches[k];
    holes.insert(touch.point);
    if (std::any_of(touches.begin(), touches.begin() + static_cast<std::ptrdiff_t>(k), [&](const Measurement& before) {
          return before.point == touch.point && before.load == touch.load && before.wrench == touch.wrench;
        }))
      return "hole " + touch.point + " is touched twice under the same load (second time by " + touch.id +
             "): every touch needs a hole of its own";
  }
  if (holes.size() < 3)
    return "a base needs at least three touched holes, and there " + std::string(holes.size() == 1 ? "is " : "are ") +
           std::to_string(holes.size());
  if (flatness(touches) < options.collinear_ratio)
    return "the touched holes lie nearly on a line, so the turn about that line is not identifiable: touch one hole "
           "well "
           "off it";
  return {};
}

}  // namespace tubeplan::calibration
