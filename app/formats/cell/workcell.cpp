#include "app/formats/cell/workcell.hpp"

#include <fmt/format.h>

#include <cmath>

#include "app/storage/input_error.hpp"

namespace tubeplan::app {

namespace {

void refuseWhatIsNotPlannedFor(const Cell& cell, const std::string& purpose) {
  requireToolAxis(cell, purpose);
  for (const auto& row : cell.arm.rows) {
    if (!row.joint.follows.empty())
      throw InputError::problem(
          cell.path,
          fmt::format("the joint {} follows others, but to {} each joint needs an encoder reading of its own",
                      row.joint.name, purpose),
          "give that joint one: motions of coupled joints are not planned");
    if (!std::isfinite(deflection::slideLength(row.joint)))
      throw InputError::problem(
          cell.path, fmt::format("the slide {} has no limits, which are needed to {}", row.joint.name, purpose),
          "add limits: [LOWEST, HIGHEST] to its joint");
  }
  if (!cell.arm.side_chains.empty())
    throw InputError::problem(
        cell.path,
        fmt::format("the arm has a side chain at {}, but to {} it must have none",
                    cell.arm.rows[static_cast<std::size_t>(cell.arm.side_chains.front().row)].name, purpose),
        "if the chain does not move, write its weight as a lump of the link that carries it");
}

}  // namespace

planner::Workcell workcellOf(const Cell& cell, const std::string& purpose) {
  refuseWhatIsNotPlannedFor(cell, purpose);
  planner::Workcell work;
  work.arm = cell.arm;
  work.arm.mountings.clear();  // the planned arm is on its own mounting, to which the set-ups on a bench do not apply
  work.X_WB = cell.X_WB;
  if (cell.base_covariance) work.base_covariance = *cell.base_covariance;
  work.sheet = requireSheet(cell, purpose);
  work.tool = requireTool(cell, purpose);
  work.scene = cell.scene;
  return work;
}

void requireSpeeds(const Cell& cell) {
  for (const auto& joint : cell.arm.joints())
    if (!std::isfinite(joint.max_speed) && !std::isfinite(joint.max_acceleration))
      throw InputError::problem(
          cell.path,
          fmt::format("joint {} has neither max_speed nor max_acceleration, which determine the times of a plan",
                      inQuotes(joint.name)),
          "state one of them in the arm file; velocity=\"0\" in a URDF states no speed");
}

}  // namespace tubeplan::app
