// Closed form for six joints whose last three axes meet in one point: the first three joints bring that point to its
// position, the last three turn the tool (Pieper 1968, "The kinematics of manipulators under computer control").
// Internal to the inverse kinematics.
#pragma once

#include <span>
#include <vector>

#include "deflection/inverse/closed_loop.hpp"
#include "deflection/inverse/rigid_branches.hpp"

namespace tubeplan::deflection {

/// Returns true if an arm has six joints or more, and its last three axes nearly meet in one point and can turn a tool
/// in any direction.
[[nodiscard]] bool carriesWrist(const AxesAtZero& axes, double reach);

/// Returns the axes before the last three, with the point where the last three meet as tip.
[[nodiscard]] AxesAtZero axesBeforeWrist(const AxesAtZero& axes);

class WristBranches {
 public:
  /// `axes` must have six joints and satisfy carriesWrist(); `reach` is the arm's reach [m].
  WristBranches(const AxesAtZero& axes, double reach);

  /// Adds postures with the tip at the goal position and the tool along the goal axis, rotated about it by each of
  /// `rolls` [rad]; at most eight postures for each roll. They are exact if the last three axes meet in one point,
  /// otherwise approximate. If there are several rolls, they must cover a whole turn in order; postures between
  /// successive rolls with the last axis in line with the third-to-last axis are then also added. In such a posture,
  /// these two joints can turn against each other freely; some of their readings are sampled. If the last joint only
  /// turns the tool about its own axis through the tip, `rolls` are readings of that joint.
  void addPostures(const ToolGoal& goal, std::span<const double> rolls, double most_imaginary,
                   std::vector<Eigen::VectorXd>& postures) const;

  /// Adds the postures that meet the goal with the same rotation of the tool about its axis as at readings `q`.
  void addPosturesLike(const ToolGoal& goal, const Eigen::VectorXd& q, double most_imaginary,
                       std::vector<Eigen::VectorXd>& postures) const;

 private:
  /// Readings of the first three joints with the wrist centre at its position, and the rotation that the wrist must
  /// then make.
  struct Root {
    Eigen::VectorXd arm;
    Eigen::Matrix3d turn;  ///< rotation that the wrist must make
    /// Components of the required direction of the last axis perpendicular to the third-to-last axis: zero if both are
    /// in line.
    Eigen::Vector2d out_of_line;
  };
  [[nodiscard]] std::vector<Eigen::VectorXd> armsAt(const Eigen::Vector3d& p_BW, double most_imaginary) const;
  [[nodiscard]] std::vector<Root> rootsAt(const ToolGoal& goal, double roll, double most_imaginary) const;
  [[nodiscard]] Eigen::Matrix3d turnAt(const ToolGoal& goal, double roll) const;
  [[nodiscard]] Root rootAt(Eigen::VectorXd arm, const Eigen::Matrix3d& R) const;
  /// Iterates from a root to readings with the wrist centre at its position. Returns false if the centre does not come
  /// near it.
  [[nodiscard]] bool iterate(const Eigen::Vector3d& p_BW, Eigen::VectorXd& arm) const;
  void addWrists(const Root& root, double q4_in_line, std::vector<Eigen::VectorXd>& postures) const;
  [[nodiscard]] Eigen::VectorXd withWrist(const Root& root, double q4, double q5) const;
  void addInLineBetween(const ToolGoal& goal, std::span<const Root> from, double from_roll, std::span<const Root> to,
                        double to_roll, std::vector<Eigen::VectorXd>& postures) const;

  AxesAtZero axes_, arm_;
  PlaceLoop loop_;
  double reach_;
  bool carries_two_links_;
  bool last_turns_in_place_;
};

}  // namespace tubeplan::deflection
