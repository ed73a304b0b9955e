// The links and joints of a URDF file, read whole or refused.
#pragma once

#include <urdf_world/types.h>

#include <map>
#include <string>
#include <vector>

#include "app/files/urdf_remarks.hpp"

namespace tubeplan::app {

/// What the file tells a joint's controller and no kinematics has, in its own words; empty where it says nothing.
struct ControllerWords {
  std::string soft_limits, reference_marks, transmission;
};

struct UrdfTree {
  urdf::ModelInterfaceSharedPtr model;                 ///< one root, every link behind it once
  WrittenTurns turns;                                  ///< of the joints' origins, where they are written
  std::vector<std::string> left_out;                   ///< what the file says and the tree has not, a sentence each
  std::map<std::string, ControllerWords> controllers;  ///< by the joint's name
};

/// What a description of an arm needs of a URDF: pictures, materials and a controller's numbers are passed over,
/// however they are written. urdfdom itself leaves a link where it meets the first thing that it cannot read and says
/// so to a log; here that is refused. Throws InputError.
[[nodiscard]] UrdfTree readUrdfTree(const std::string& text, const std::string& file);

}  // namespace tubeplan::app
