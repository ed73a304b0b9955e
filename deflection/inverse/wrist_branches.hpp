// The closed form of six joints of which the last three axes meet: the first three bring the point where they meet to
// its place, the last three turn the tool (Pieper 1968, "The kinematics of manipulators under computer control").
// Internal to the inverse.
#pragma once

#include <span>
#include <vector>

#include "deflection/inverse/closed_loop.hpp"
#include "deflection/inverse/rigid_branches.hpp"

namespace tubeplan::deflection {

/// Whether the last three axes of an arm of six joints or more meet, nearly, and turn a tool any way.
[[nodiscard]] bool carriesWrist(const AxesAtZero& axes, double reach);

/// The axes before the last three, with the point where those meet as tip.
[[nodiscard]] AxesAtZero axesBeforeWrist(const AxesAtZero& axes);

class WristBranches {
 public:
  /// Of six joints that carriesWrist() is true of. `reach` [m].
  WristBranches(const AxesAtZero& axes, double reach);

  /// Adds postures with the tip at its place, the tool along its axis and turned about it by each of `rolls` [rad], at
  /// most eight of each. Exact where the axes meet, otherwise near. Where rolls go round the axis in order, those
  /// postures are added, too, that have the last axis in line with the third last somewhere between: there those two
  /// turn against each other freely, some readings of which are taken. Where the last joint does no more than turn the
  /// tool about its own axis through the tip, rolls are its readings.
  void addPostures(const ToolGoal& goal, std::span<const double> rolls, double most_imaginary,
                   std::vector<Eigen::VectorXd>& postures) const;

  /// The same as a posture that meets the goal, if there are such.
  void addPosturesLike(const ToolGoal& goal, const Eigen::VectorXd& q, double most_imaginary,
                       std::vector<Eigen::VectorXd>& postures) const;

 private:
  /// Readings of the first three joints that have the wrist at its place, and where the tool's wanted turn then is.
  struct Root {
    Eigen::VectorXd arm;
    Eigen::Matrix3d turn;         ///< that the wrist is to make
    Eigen::Vector2d out_of_line;  ///< where the last axis is to point, across the third last: zero in line with it
  };
  [[nodiscard]] std::vector<Eigen::VectorXd> armsAt(const Eigen::Vector3d& p_BW, double most_imaginary) const;
  [[nodiscard]] std::vector<Root> rootsAt(const ToolGoal& goal, double roll, double most_imaginary) const;
  [[nodiscard]] Eigen::Matrix3d turnAt(const ToolGoal& goal, double roll) const;
  [[nodiscard]] Root rootAt(Eigen::VectorXd arm, const Eigen::Matrix3d& R) const;
  /// Steps from a root near it to the readings that have the wrist at its place; false where it comes nowhere near.
  [[nodiscard]] bool lead(const Eigen::Vector3d& p_BW, Eigen::VectorXd& arm) const;
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
