#include "app/documents/trajectory_yaml.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "app/storage/input_error.hpp"
#include "planner/trajectory.hpp"

namespace tubeplan::app {

namespace {

std::string listOf(const Eigen::VectorXd& values) {
  std::string text;
  for (const double value : values) text += fmt::format("{}{:.12g}", text.empty() ? "" : ", ", value);
  return "[" + text + "]";
}

std::string timeOf(double seconds) {
  constexpr long kNanoseconds = 1'000'000'000;
  const long nanoseconds = std::lround(seconds * 1e9);
  return fmt::format("{{sec: {}, nanosec: {}}}", nanoseconds / kNanoseconds, nanoseconds % kNanoseconds);
}

}  // namespace

void requireAccelerations(const deflection::Arm& arm) {
  for (const auto& joint : arm.joints())
    if (!std::isfinite(joint.max_acceleration))
      throw InputError::problem(kTrajectoryFile,
                                "joint " + inQuotes(joint.name) + " has no max_acceleration, so its speed would jump",
                                "state max_acceleration in the arm file, or leave out the trajectory");
}

std::string trajectoryYaml(const PlanOutcome& outcome) {
  const auto& arm = outcome.model.arm;
  requireAccelerations(arm);
  std::string text =
      fmt::format("header: {{stamp: {{sec: 0, nanosec: 0}}, frame_id: \"\"}}\njoint_names: [{}]\npoints:\n",
                  fmt::join(deflection::jointNames(arm), ", "));
  for (const auto& point : planner::trajectoryOf(outcome.plan, planner::jointSpeedsOf(arm)))
    text += fmt::format("- {{positions: {}, velocities: {}, accelerations: {}, time_from_start: {}}}\n",
                        listOf(point.position), listOf(point.speed), listOf(point.acceleration), timeOf(point.time));
  return text;
}

}  // namespace tubeplan::app
