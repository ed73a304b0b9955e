// Chains of links in a robot described by URDF, and the links at their tips.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/formats/urdf/urdf_tree.hpp"
#include "app/storage/input_question.hpp"

namespace tubeplan::app {

/// Links from the first link after the root to the tip.
using UrdfChain = std::vector<const UrdfTree::Link*>;

/// Error in a file that another choice of the tip may avoid.
struct TipError final : InputError {
  explicit TipError(const InputError& error) : InputError(error) {}
};

[[nodiscard]] inline bool isMoving(const UrdfTree::Joint& joint) { return joint.type != "fixed"; }

/// Returns the chain to the link `tip`. Throws InputError if the links form a closed loop.
[[nodiscard]] UrdfChain chainTo(const UrdfTree& tree, const UrdfTree::Link& tip, const std::string& file);

/// Returns the link `name`; if it is empty, the only leaf at the end of the longest chain. Throws TipError if there is
/// no such link.
[[nodiscard]] const UrdfTree::Link& findTip(const UrdfTree& tree, const std::string& name, const std::string& file);

/// Returns the links that can be the tip: those behind a moving joint for which `can_end` holds, leaves first, and
/// those behind more joints before others.
[[nodiscard]] InputChoice tipChoice(const UrdfTree& tree, const std::function<bool(const UrdfTree::Link&)>& can_end);

}  // namespace tubeplan::app
