// Tree of the links and joints in a URDF file, and its reader, which checks the whole file.
#pragma once

#include <Eigen/Geometry>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace tubeplan::app {

/// Robot as described by a URDF file, in m, rad and kg. Missing values have the defaults of URDF.
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
  /// Data of a joint's controller as text, which kinematics does not use; empty if the file has none.
  struct ControllerWords {
    std::string soft_limits, reference_marks, transmission;
  };
  struct Joint {
    std::string name, type;  ///< joint type: "revolute", "continuous", "prismatic", "fixed", "floating" or "planar"
    Origin origin;
    Eigen::Vector3d axis = Eigen::Vector3d::UnitX();
    std::optional<Limits> limits;
    std::optional<Mimic> mimic;
    ControllerWords controller;
  };
  /// Solid of a link: `size` has the side lengths of a box, the radius and length of a cylinder, or the radius of a
  /// sphere. A mesh has a file instead.
  struct Solid {
    std::string kind, file;
    Origin origin;
    Eigen::Vector3d size = Eigen::Vector3d::Zero();
  };
  struct Link {
    std::string name;
    double mass = 0;
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< centre of mass in the link's frame [m]
    bool has_inertia = false;
    std::vector<Solid> solids;
    std::optional<Joint> joint;         ///< joint that carries the link; std::nullopt for the root
    const Link* parent = nullptr;       ///< parent link; null for the root
    std::vector<const Link*> children;  ///< child links, in the order of their joints' names
  };

  std::string name;
  std::map<std::string, Link> links;  ///< links keyed by name: one root; every other link has one joint to its parent
  const Link* root = nullptr;
  std::vector<std::string> left_out;  ///< content of the file that the tree does not represent, one sentence each

  UrdfTree() = default;
  UrdfTree(UrdfTree&&) = default;
};

/// Reads the elements of a URDF that describe an arm; does not check visuals, materials and controller data. Throws
/// InputError.
[[nodiscard]] UrdfTree readUrdfTree(const std::string& text, const std::string& file);

}  // namespace tubeplan::app
