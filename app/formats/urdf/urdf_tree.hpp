// Links and joints of a URDF file, with checks of the whole file.
#pragma once

#include <Eigen/Geometry>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace tubeplan::app {

/// Robot as in the file, lengths in m, angles in rad, masses in kg. Missing values have the defaults of URDF.
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
  /// Data for a joint's controller, which kinematics does not use, in the words of the file; empty if it has none.
  struct ControllerWords {
    std::string soft_limits, reference_marks, transmission;
  };
  struct Joint {
    std::string name, type;  ///< type: "revolute", "continuous", "prismatic", "fixed", "floating" or "planar"
    Origin origin;
    Eigen::Vector3d axis = Eigen::Vector3d::UnitX();
    std::optional<Limits> limits;
    std::optional<Mimic> mimic;
    ControllerWords controller;
  };
  /// Solid of a link: `size` has the sizes of a box, the radius and length of a cylinder or the radius of a sphere; a
  /// mesh has a file instead.
  struct Solid {
    std::string kind, file;
    Origin origin;
    Eigen::Vector3d size = Eigen::Vector3d::Zero();
  };
  struct Link {
    std::string name;
    double mass = 0;
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< centre of mass
    bool has_inertia = false;
    std::vector<Solid> solids;
    std::optional<Joint> joint;         ///< joint that carries the link; nothing for the root
    const Link* parent = nullptr;       ///< parent link in this tree; null for the root
    std::vector<const Link*> children;  ///< child links, in the order of their joints' names
  };

  std::string name;
  std::map<std::string, Link> links;  ///< links by name: one root; each other link has one joint to its parent
  const Link* root = nullptr;
  std::vector<std::string> left_out;  ///< content of the file that the tree does not have, a sentence each

  UrdfTree() = default;
  UrdfTree(UrdfTree&&) = default;
};

/// Reads the parts of a URDF that describe an arm; pictures, materials and controller data are not checked. Throws
/// InputError.
[[nodiscard]] UrdfTree readUrdfTree(const std::string& text, const std::string& file);

}  // namespace tubeplan::app
