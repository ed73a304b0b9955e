// Every posture of the rigid arm that meets a goal, for arms of three joints and more; where there are more joints than
// the goal asks for, every posture at each of some readings of those that are over. Internal to the inverse.
#pragma once

#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "deflection/inverse/closed_loop.hpp"
#include "deflection/inverse/rigid_branches.hpp"

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
  /// Whether the postures leave nothing to be done for the tool's lean.
  [[nodiscard]] bool areUpright() const { return form_ != Form::kPlace; }

  /// The same at readings of the sampled joints of the caller's choice.
  void addPosturesAt(const ToolGoal& goal, const Eigen::VectorXd& readings,
                     std::vector<Eigen::VectorXd>& postures) const;

 private:
  enum class Form { kTurret, kLine, kPlace };
  /// The arm with the joints that are over held.
  struct Slice {
    Eigen::VectorXd readings;
    std::variant<AxesAtZero, PlaceLoop, LineLoop> chain;  ///< the first of turret arms
  };
  void chooseHeld(const Arm& arm, Hold hold);
  [[nodiscard]] Slice sliceAt(const Eigen::VectorXd& readings) const;
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
