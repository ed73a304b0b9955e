// Response of the deflected tip to any change along the arm: a rotation, a shift, a force, a moment, or an increase in
// an element's compliance.
//
// All loads are dead, so the loads beyond a cut change only because their points of action move with the cut. About the
// base's origin, dM = A w + v x F for a motion (w, v) of the cut: w is a rotation and v the motion of the point at the
// origin. One inward sweep computes A at every cut without iteration, including the response of the elements, as in the
// articulated-body algorithm of dynamics. The tip's sensitivities are the transpose of that solution: a sweep inwards
// gives the effect of motions on the tip, a sweep outwards the effect of loads. The response to a variable is then one
// product.
#pragma once

#include <vector>

#include "deflection/prepared_arm.hpp"

namespace tubeplan::deflection {

/// Value of `row` that selects the tool frame at the tip instead of a row.
inline constexpr int kTool = -1;

/// Motion of the tip (position [m], then rotation vector [rad], base axes) per unit of each component of a vector.
using TipRows = Eigen::Matrix<double, 6, 3>;

/// Responses of the tip to a larger deflection of an element under the same load, in the element's near axes, and to a
/// weight along the element, in base axes.
struct ElementSensitivity {
  TipRows displacement, rotation, weight;
  std::array<clearance::GapPosition, 3> gap_positions;  ///< position in the gap about each axis
};

/// Sensitivities of one arm, computed for one shape after another.
class TipSensitivity {
 public:
  /// Linearises about the shape last solved by `arm`, in axes of the base as moved by effects. With a `row`, the
  /// responses are for the row's deflected frame instead of the tip; changes beyond that frame act on it only through
  /// loads.
  void linearize(const PreparedArm& arm, int row = kTool);

  /// Returns the near frames of the links, then the tip's frame.
  [[nodiscard]] const std::vector<PoseOf<double>>& frames() const { return frames_; }
  /// Returns the frame, of the tool or of a row, whose responses are computed.
  [[nodiscard]] const PoseOf<double>& frame() const { return frames_[answering_]; }
  [[nodiscard]] bool isOfTool() const { return answering_ + 1 == frames_.size(); }
  [[nodiscard]] const ElementSensitivity& element(std::size_t e) const { return elements_[e]; }
  /// Returns the response to a change of the direction of gravity.
  [[nodiscard]] const TipRows& gravity() const { return gravity_; }

  /// Return the responses to changes at a link, in base axes: to a rotation of everything beyond the link about a
  /// point, to a shift of everything beyond the link, to a dead force at a point fixed to the link, and to a dead
  /// moment on the link.
  [[nodiscard]] TipRows turnAt(std::size_t link, const Eigen::Vector3d& p) const;
  [[nodiscard]] TipRows shiftAt(std::size_t link) const;
  [[nodiscard]] TipRows forceAt(std::size_t link, const Eigen::Vector3d& p) const;
  [[nodiscard]] const TipRows& momentAt(std::size_t link) const { return loads_[link].by_moment; }

 private:
  /// Loads beyond a cut: their force, and the derivative of their moment about the base's origin with respect to a
  /// rotation.
  struct OutboardLoad {
    Eigen::Vector3d force;
    Eigen::Matrix3d by_turn;
  };
  /// Response of the tip to a dead force at the base's origin and to a dead moment, both acting on a link.
  struct LoadAnswer {
    TipRows by_force, by_moment;
  };
  /// Linearised response of an element, in near axes unless base axes are stated.
  struct Answer {
    bool is_member;             ///< false if the element only rotates, and only under moments
    Eigen::Matrix3d R, turn_B;  ///< near axes; rotation vector in base axes per change of the element's rotation
    Eigen::Matrix3d displacement_by_force, displacement_by_moment, displacement_by_weight;
    Eigen::Matrix3d rotation_by_force, rotation_by_moment, rotation_by_weight, rotation_by_displacement;
    Eigen::Matrix3d displacement_itself;  ///< amplification of a displacement by the change of chord that it causes
    /// Derivative of the moment of the loads beyond with respect to the element's rotation; inverse of the matrix of
    /// the linear equation for that rotation.
    Eigen::Matrix3d moment_by_rotation, inverse;
    Eigen::Vector3d is_compliant;                 ///< 0 for an axis that hangs freely in its gap, else 1
    Eigen::Matrix3d turn_by_turn, shift_by_turn;  ///< response of the element to a rotation of its near end, base axes
  };

  /// Returns true if a motion of everything beyond a link moves the frame whose responses are computed.
  [[nodiscard]] bool carries(std::size_t link) const { return link < answering_; }
  /// Returns the response to a shift of everything beyond a link, under constant loads.
  [[nodiscard]] const TipRows& carriedShift(std::size_t link) const;
  void answerOf(const PreparedArm& arm, std::size_t k, std::size_t e);
  void sweepInwards(const PreparedArm& arm);
  void sweepOutwards(const PreparedArm& arm);
  void passElement(const PreparedArm& arm, std::size_t k, std::size_t e, LoadAnswer& load);
  void addGravity(const PreparedArm& arm);

  std::vector<PoseOf<double>> frames_;
  std::size_t answering_ = 0;           ///< index of the frame whose responses are computed
  std::vector<OutboardLoad> outboard_;  ///< loads beyond each link's far end
  /// Response to a rotation of each link's far end about the base's origin, if the loads on the links before do not
  /// change.
  std::vector<TipRows> motion_;
  std::vector<Answer> answers_;
  std::vector<LoadAnswer> loads_;  ///< responses to a force and a moment on each link
  std::vector<ElementSensitivity> elements_;
  TipRows gravity_;
};

}  // namespace tubeplan::deflection
