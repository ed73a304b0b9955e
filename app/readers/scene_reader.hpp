// A cell's scene: obstacles in the world and shapes on the links, by the planner's table of shapes.
#pragma once

#include "app/readers/units.hpp"
#include "app/readers/yaml_node.hpp"
#include "deflection/arm.hpp"
#include "planner/scene.hpp"

namespace tubeplan::app {

/// Reads the keys scene, link_shapes and clearance of a cell, each of which may be missing. Throws InputError for an
/// unknown shape, link or field and for what planner::findSceneProblems finds.
[[nodiscard]] planner::Scene readScene(const YamlNode& cell, const deflection::Arm& arm, const Units& units);

}  // namespace tubeplan::app
