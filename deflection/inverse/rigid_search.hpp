// Search for every posture of the rigid arm that meets a goal, for arms of three joints or more. If there are more
// joints than the goal requires, redundant joints are held at sampled readings, and every posture is found for each
// sample. Internal to the inverse kinematics.
#pragma once

#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "deflection/inverse/closed_loop.hpp"
#include "deflection/inverse/rigid_branches.hpp"
#include "deflection/inverse/wrist_branches.hpp"

namespace tubeplan::deflection {

class RigidSearch {
 public:
  enum class Constraint { kPlaceAndAxis, kPlace };
  /// Prepares the search for an arm of three joints or more; `arm` provides the joint limits. If the arm cannot turn
  /// its tool in two directions with the tip in place, or if `constraint` is kPlace, the search ignores the tool's
  /// direction.
  RigidSearch(const Arm& arm, const AxesAtZero& axes, Constraint constraint = Constraint::kPlaceAndAxis);

  /// Adds readings near all postures with the tip at the goal position and, if areUpright(), the tool along the goal
  /// axis. The order is the same for every goal. Adds nothing if there is no such posture.
  void addPostures(const ToolGoal& goal, std::vector<Eigen::VectorXd>& postures) const;

  /// Returns the indices of the joints that are held at sampled readings.
  [[nodiscard]] std::span<const int> sampled() const { return held_; }
  /// Returns true if a continuous family of postures meets a goal; the search then returns samples of the family.
  [[nodiscard]] bool isContinuum() const { return !held_.empty() || form_ == Form::kWrist; }
  /// Returns true if the found postures have the tool along the goal axis; false if the search ignores the tool's
  /// direction.
  [[nodiscard]] bool areUpright() const { return form_ != Form::kPlace; }

  /// Adds the postures that meet the goal with the redundant joints at their readings in `q` and, for arms with a
  /// wrist, the tool rotated about its axis as at `q`.
  void addPosturesLike(const ToolGoal& goal, const Eigen::VectorXd& q, std::vector<Eigen::VectorXd>& postures) const;

 private:
  enum class Form { kTurret, kWrist, kLine, kPlace };
  /// The arm with its redundant joints held.
  struct Slice {
    Eigen::VectorXd readings;
    /// Solver for the remaining joints; turret arms use the first alternative.
    std::variant<AxesAtZero, WristBranches, PlaceLoop, LineLoop> chain;
    std::vector<double> rolls;  ///< rotations of the tool about its axis, for arms with a wrist [rad]
  };
  void chooseForm(const Arm& arm, Constraint constraint);
  [[nodiscard]] Slice sliceAt(const Eigen::VectorXd& readings, std::vector<double> rolls = {}) const;
  [[nodiscard]] Eigen::VectorXd withoutHeld(const Eigen::VectorXd& q) const;
  void addSlices(const Arm& arm);
  /// Adds the postures found in a slice, completed with the slice's held readings.
  void addAt(const Slice& slice, std::span<const Eigen::VectorXd> found, std::vector<Eigen::VectorXd>& postures) const;
  void addFrom(const Slice& slice, const ToolGoal& goal, double most_imaginary,
               std::vector<Eigen::VectorXd>& postures) const;

  AxesAtZero axes_;
  double reach_;
  Form form_ = Form::kPlace;
  std::vector<int> held_;
  std::optional<ClosureChain<kLineSize>> lines_;
  std::optional<ClosureChain<kPlaceSize>> places_;
  std::vector<Slice> slices_;
};

}  // namespace tubeplan::deflection
