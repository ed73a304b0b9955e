// Every posture of the rigid arm that meets a goal, for arms of three joints and more; where there are more joints than
// the goal asks for, every posture at each of some readings of those that are over. Internal to the inverse.
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
  enum class Hold { kPlaceAndAxis, kPlace };
  /// Of an arm of three joints or more, which is asked for its limits only. Where an arm cannot turn its tool both ways
  /// with its tip held, and where only the place is to be held, the joints that are over leave it as it comes.
  RigidSearch(const Arm& arm, const AxesAtZero& axes, Hold hold = Hold::kPlaceAndAxis);

  /// Adds readings near all postures that have the tip at its place and, where that is to be held, the tool along its
  /// axis, in the same order for every goal. None: there is no such posture.
  void addPostures(const ToolGoal& goal, std::vector<Eigen::VectorXd>& postures) const;

  /// Joints that are given readings in turn.
  [[nodiscard]] std::span<const int> sampled() const { return held_; }
  /// Whether postures of a goal are a continuum, of which some are taken.
  [[nodiscard]] bool isContinuum() const { return !held_.empty() || form_ == Form::kWrist; }
  /// Whether the postures leave nothing to be done for the tool's lean.
  [[nodiscard]] bool areUpright() const { return form_ != Form::kPlace; }

  /// The same where a posture of the caller's choice is in the continuum, if it meets the goal.
  void addPosturesLike(const ToolGoal& goal, const Eigen::VectorXd& q, std::vector<Eigen::VectorXd>& postures) const;

 private:
  enum class Form { kTurret, kWrist, kLine, kPlace };
  /// The arm with the joints that are over held.
  struct Slice {
    Eigen::VectorXd readings;
    std::variant<AxesAtZero, WristBranches, PlaceLoop, LineLoop> chain;  ///< the first of turret arms
    std::vector<double> rolls;  ///< rad, of arms with a wrist: turns of the tool about its axis
  };
  void chooseForm(const Arm& arm, Hold hold);
  [[nodiscard]] Slice sliceAt(const Eigen::VectorXd& readings, std::vector<double> rolls = {}) const;
  [[nodiscard]] Eigen::VectorXd withoutHeld(const Eigen::VectorXd& q) const;
  void addSlices(const Arm& arm);
  /// The same with the slice's readings.
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
