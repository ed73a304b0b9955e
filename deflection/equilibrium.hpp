// Equilibrium shape of an arm under its loads: rigid bodies between flexible elements, and the sweeps that bring both
// to equilibrium.
//
// All loads are dead loads: forces of constant magnitude and direction. For each direction of loads, the moment on an
// element follows from three quantities: the direction g in the element's axes, and the magnitude and first moment S of
// the loads beyond the element. A sweep outwards rotates g from body to body; a sweep inwards accumulates magnitude and
// S. The moment is M = S x g (step 3 of table 2.1 of Calkins 1994), and both sweeps bend the elements that they pass
// (step 4). No memory is allocated during the iteration.
#pragma once

#include <vector>

#include "deflection/elements/clearance.hpp"
#include "deflection/elements/element.hpp"
#include "deflection/flexible_kinematics.hpp"
#include "deflection/rotation.hpp"

namespace tubeplan::deflection {

/// The rigid part between two elements: the pose of its far end relative to its near end, and its weight.
struct RigidBody {
  PoseOf<double> far;
  double weight = 0;                                 ///< [N]
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();  ///< first moment of the weight about the near end [N m]
};

/// A flexible element and its deflection.
struct FlexibleElement {
  const ElementKind* kind = nullptr;
  Flexibility<double> flexibility;
  double weight = 0;  ///< weight along the element [N]
  int hinge = -1;     ///< the only axis about which the element rotates, if its law is linear; otherwise -1
  std::array<bool, 3> has_gap{};
  Eigen::Vector3d gap_width = Eigen::Vector3d::Zero();  ///< [rad]

  Deflection<double> deflection;                  ///< deflection; its rotation includes the motion in the gap
  Eigen::Vector3d gap = Eigen::Vector3d::Zero();  ///< part of the rotation within the clearance [rad]
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();

  [[nodiscard]] Eigen::Vector3d chord() const { return flexibility.member + deflection.displacement; }
  [[nodiscard]] bool hasGap() const { return has_gap[0] || has_gap[1] || has_gap[2]; }
};

/// All loads that act in one direction, or a couple of constant magnitude and direction.
struct DeadLoad {
  bool is_couple = false;
  Eigen::Vector3d direction_B = Eigen::Vector3d::Zero();
  double at_tip = 0;                                     ///< load at the tip, as a multiple of direction_B
  Eigen::Vector3d tip_moment = Eigen::Vector3d::Zero();  ///< first moment of the load at the tip, in the tip's axes
  int body = -1;                                         ///< index of the body that carries a unit load; -1 if none
  Eigen::Vector3d place = Eigen::Vector3d::Zero();       ///< point of action in the body's near frame [m]
};

class Equilibrium {
 public:
  /// Bodies and elements alternate from the base to the tip, with one more body than elements. The first load is
  /// gravity, acting on the bodies' weights; it always exists.
  std::vector<RigidBody> bodies;
  std::vector<FlexibleElement> elements;
  std::vector<DeadLoad> loads;
  double reach = 0;    ///< lever arm that converts rotations to tip motions [m]
  int clearances = 0;  ///< number of axes with a clearance greater than zero

  /// Iterates from the undeflected shape until a sweep outwards moves the tip by no more than `tolerance` [m].
  KinematicsStatus converge(double tolerance, int max_iterations);

  /// Computes the loads on the elements for the current deflections.
  void carryLoads();

  /// Returns the number of pairs of sweeps that the last call of converge() took.
  [[nodiscard]] int iterations() const { return iterations_; }

  /// Returns the pose of the deflected tip in the base.
  [[nodiscard]] PoseOf<double> tip() const;

  /// Returns the last computed outboard loads on an element.
  [[nodiscard]] Loading<double> loadingOf(std::size_t element) const;

  /// Returns the position that an element takes in its gap about an axis, under a moment about that axis [N m].
  [[nodiscard]] clearance::GapPosition gapPositionOf(std::size_t element, int axis, double moment) const;

 private:
  /// Loads in one direction beyond an element: their magnitude, their first moment about the element's far end in far
  /// axes, and their direction in near axes.
  struct OutboardLoad {
    double size = 0;
    Eigen::Vector3d moment = Eigen::Vector3d::Zero(), direction = Eigen::Vector3d::Zero();
  };

  void straighten();
  void gatherInwards(bool bend);
  [[nodiscard]] double turnOutwards(bool bends);
  double bend(std::size_t element, bool with_gaps);
  double turnHinge(std::size_t element);
  [[nodiscard]] OutboardLoad& outboard(std::size_t element, std::size_t load) {
    return outboard_[element * loads.size() + load];
  }
  [[nodiscard]] const OutboardLoad& outboard(std::size_t element, std::size_t load) const {
    return outboard_[element * loads.size() + load];
  }

  std::vector<OutboardLoad> outboard_;
  int iterations_ = 0;
};

}  // namespace tubeplan::deflection
