// How the deflected tip answers to anything that happens along the arm: a turn, a shift, a force, a moment, an element
// that gives a little more.
//
// All loads are dead, so the loads beyond a cut change only because their places move with it. About the base's origin:
// dM = A w + v x F for a motion (w, v) of the cut, w a turn and v the motion of the point at the origin. One sweep
// inwards finds A at every cut, the elements' answer included (as articulated bodies are solved in dynamics), without
// iteration. The tip's sensitivities are the transpose of that solution: a sweep inwards for what motions do to the
// tip, a sweep outwards for what loads do. Whatever a variable changes directly is then one product.
#pragma once

#include <vector>

#include "deflection/prepared_arm.hpp"

namespace tubeplan::deflection {

/// In the place of a row: the tool frame, at the tip.
inline constexpr int kTool = -1;

/// Motion of the tip (position [m], then rotation vector [rad], base axes) per unit of a vector.
using TipRows = Eigen::Matrix<double, 6, 3>;

/// Answers to an element that gives more under the same load, in its near axes, and to a weight along it, in base axes.
struct ElementSensitivity {
  TipRows displacement, rotation, weight;
  std::array<clearance::Rest, 3> rests;  ///< in its gaps
};

/// The sensitivities of one arm, shape after shape.
class TipSensitivity {
 public:
  /// Linearises about the shape that `arm` has solved last. Where the arm has moved its base, all is seen from there.
  /// With a `row` the frame whose answers these are is that row's, as deflected, in the place of the tip's: what
  /// happens beyond it reaches it by the loads alone.
  void linearize(const PreparedArm& arm, int row = kTool);

  [[nodiscard]] const std::vector<PoseOf<double>>& frames() const { return frames_; }  ///< near ones, the tip's last
  /// The frame whose answers these are.
  [[nodiscard]] const PoseOf<double>& frame() const { return frames_[answering_]; }
  [[nodiscard]] bool isOfTool() const { return answering_ + 1 == frames_.size(); }
  [[nodiscard]] const ElementSensitivity& element(std::size_t e) const { return elements_[e]; }
  /// Answer to a change of gravity's direction.
  [[nodiscard]] const TipRows& gravity() const { return gravity_; }

  /// Answers to what happens in a link, in base axes: to a turn of all beyond about a place, to a shift of all beyond,
  /// to a dead force at a place that is fixed to the link, and to a dead moment on the link.
  [[nodiscard]] TipRows turnAt(std::size_t link, const Eigen::Vector3d& p) const;
  [[nodiscard]] TipRows shiftAt(std::size_t link) const;
  [[nodiscard]] TipRows forceAt(std::size_t link, const Eigen::Vector3d& p) const;
  [[nodiscard]] const TipRows& momentAt(std::size_t link) const { return loads_[link].by_moment; }

 private:
  /// What is beyond a cut: the force, and how its moment about the base's origin changes with a turn of it.
  struct OutboardLoad {
    Eigen::Vector3d force;
    Eigen::Matrix3d by_turn;
  };
  /// The tip's answer to a dead force at the base's origin and to a dead moment, on a link.
  struct LoadAnswer {
    TipRows by_force, by_moment;
  };
  /// An element's answer, linearised. Near axes, but for the moments and turns in base axes that are named so.
  struct Answer {
    bool is_member;             ///< else it only turns, and only moments turn it
    Eigen::Matrix3d R, turn_B;  ///< near axes; rotation vector in base axes, per change of the rotation
    Eigen::Matrix3d displacement_by_force, displacement_by_moment, displacement_by_weight;
    Eigen::Matrix3d rotation_by_force, rotation_by_moment, rotation_by_weight, rotation_by_displacement;
    Eigen::Matrix3d displacement_itself;          ///< by what it gives under the same load
    Eigen::Matrix3d moment_by_rotation, inverse;  ///< of the loads beyond; of the rotation's own equation
    Eigen::Vector3d is_compliant;                 ///< 0 for an axis that hangs freely in its gap, else 1
    Eigen::Matrix3d turn_by_turn, shift_by_turn;  ///< base axes: of the element, by a turn of its near end
  };

  /// Whether a motion of all beyond a link takes the answering frame with it.
  [[nodiscard]] bool carries(std::size_t link) const { return link < answering_; }
  /// The answer to a shift of all beyond a link, under the same loads.
  [[nodiscard]] const TipRows& carriedShift(std::size_t link) const;
  void answerOf(const PreparedArm& arm, std::size_t k, std::size_t e);
  void sweepInwards(const PreparedArm& arm);
  void sweepOutwards(const PreparedArm& arm);
  void passElement(const PreparedArm& arm, std::size_t k, std::size_t e, LoadAnswer& load);
  void addGravity(const PreparedArm& arm);

  std::vector<PoseOf<double>> frames_;
  std::size_t answering_ = 0;           ///< of the frames, the one whose answers these are
  std::vector<OutboardLoad> outboard_;  ///< of each link's far end
  std::vector<TipRows> motion_;  ///< answer to a turn about the base's origin under the same loads inboard, far ends
  std::vector<Answer> answers_;
  std::vector<LoadAnswer> loads_;  ///< of each link
  std::vector<ElementSensitivity> elements_;
  TipRows gravity_;
};

}  // namespace tubeplan::deflection
