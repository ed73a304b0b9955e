// The links and joints of a URDF file, read whole or refused.
#pragma once

#include <Eigen/Geometry>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace tubeplan::app {

/// Lengths in m, angles in rad, masses in kg, as the file has them; what it leaves out is as URDF says.
struct UrdfTree {
  struct Origin {
    Eigen::Vector3d xyz = Eigen::Vector3d::Zero(), rpy = Eigen::Vector3d::Zero();

    [[nodiscard]] Eigen::Isometry3d pose() const;
  };
  struct Limits {
    double lower = 0, upper = 0, velocity = 0;
  };
  struct Mimic {
    std::string joint;
    double multiplier = 1, offset = 0;
  };
  /// What the file tells a joint's controller and no kinematics has, in its own words; empty where it says nothing.
  struct ControllerWords {
    std::string soft_limits, reference_marks, transmission;
  };
  struct Joint {
    std::string name, type;  ///< "revolute", "continuous", "prismatic", "fixed", "floating" or "planar"
    Origin origin;
    Eigen::Vector3d axis = Eigen::Vector3d::UnitX();
    std::optional<Limits> limits;
    std::optional<Mimic> mimic;
    ControllerWords controller;
  };
  /// Sizes of a box; of a cylinder radius and length; of a sphere its radius. A mesh has a file instead.
  struct Solid {
    std::string kind, file;
    Origin origin;
    Eigen::Vector3d size = Eigen::Vector3d::Zero();
  };
  struct Link {
    std::string name;
    double mass = 0;
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< of mass
    bool has_inertia = false;
    std::vector<Solid> solids;
    std::optional<Joint> joint;         ///< that carries it; the root has none
    const Link* parent = nullptr;       ///< of this tree
    std::vector<const Link*> children;  ///< of this tree, by the names of their joints
  };

  std::string name;
  std::map<std::string, Link> links;  ///< by their names; one root, every other one behind one joint
  const Link* root = nullptr;
  std::vector<std::string> left_out;  ///< what the file says and the tree has not, a sentence each

  UrdfTree() = default;
  UrdfTree(UrdfTree&&) = default;
};

/// Reads what a description of an arm needs of a URDF: pictures, materials and a controller's numbers are passed over,
/// however they are written. Throws InputError.
[[nodiscard]] UrdfTree readUrdfTree(const std::string& text, const std::string& file);

}  // namespace tubeplan::app
