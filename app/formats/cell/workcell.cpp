#include "app/formats/cell/workcell.hpp"

#include <cmath>

#include "app/storage/input_error.hpp"

namespace tubeplan::app {

namespace {

void refuseWhatIsNotPlannedFor(const Cell& cell, const std::string& purpose) {
  const std::string needed = ": needed to " + purpose;
  requireToolAxis(cell, purpose);
  for (const auto& row : cell.arm.rows) {
    if (!row.joint.follows.empty())
      throw InputError(cell.path, "the joint " + row.joint.name + ", which follows others",
                       "joints with encoder readings of their own" + needed,
                       "give it a reading of its own: motions of coupled joints are not planned");
    if (!std::isfinite(deflection::slideLength(row.joint)))
      throw InputError(cell.path, "the slide " + row.joint.name + " without limits",
                       "how far it goes either way" + needed, "add limits: [LOWEST, HIGHEST] to its joint");
  }
  if (!cell.arm.side_chains.empty())
    throw InputError(
        cell.path,
        "the side chain at " + cell.arm.rows[static_cast<std::size_t>(cell.arm.side_chains.front().row)].name,
        "an arm without side chains" + needed,
        "if it does not move, write its weight as a lump of the link that carries it");
}

}  // namespace

planner::Workcell workcellOf(const Cell& cell, const std::string& purpose) {
  refuseWhatIsNotPlannedFor(cell, purpose);
  planner::Workcell work;
  work.arm = cell.arm;
  work.arm.mountings.clear();  // set-ups on a bench do not apply: the arm is planned for on its own mounting
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
      throw InputError(cell.path, "neither max_speed nor max_acceleration of joint " + inQuotes(joint.name),
                       "one of them at least: a plan's times follow from them",
                       "state it in the arm file; a URDF's velocity=\"0\" is none");
}

}  // namespace tubeplan::app
