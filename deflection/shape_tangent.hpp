// The tangent of a converged shape: how the deflected tip moves with the numbers behind it.
//
// What a variable changes in the chain directly (a translation, a turn, a weight, an element under unchanged loads)
// comes from dual numbers through the very templates that build the shape. How that spreads over the arm is the
// linearisation of the two sweeps, with the elements' laws linearised by dual numbers too, iterated as the shape was.
#pragma once

#include <array>
#include <vector>

#include "deflection/effects/situation.hpp"
#include "deflection/sweeps.hpp"

namespace tubeplan::deflection {

/// A vector's derivatives, one column for each slot of a dual number.
using VectorTangent = Eigen::Matrix<double, 3, kDualSize, Eigen::RowMajor>;
using NumberTangent = Eigen::Matrix<double, 1, kDualSize>;

/// Motion of a frame: of its origin [m], and the rotation vector of its axes [rad], in base axes.
struct FrameTangent {
  VectorTangent position = VectorTangent::Zero();
  VectorTangent rotation = VectorTangent::Zero();
};

struct TipTangent {
  KinematicsStatus status = KinematicsStatus::kNotRun;
  int iterations = 0;
  FrameTangent tip;
};

/// What the derivatives of one shape share, whatever they are taken by.
class ShapeTangent {
 public:
  /// `shape` is the converged shape of the arm at that posture; arm and posture must outlive the tangent.
  ShapeTangent(const Arm& arm, const Posture& posture, const FlexibleKinematics& shape);

  /// Derivatives by the slots that are seeded in the arm and the posture: the same ones, in dual numbers.
  [[nodiscard]] TipTangent along(const ArmOf<Dual>& arm, const PostureOf<Dual>& posture,
                                 const FlexibleKinematicsOptions& options) const;

 private:
  /// An element under its load, and the slope of its law there.
  struct Element {
    Loading<Dual> loading;               ///< its derivatives zero
    Eigen::Matrix<double, 6, 12> slope;  ///< of (displacement, rotation) by (force, moment, weight, chord)
    Eigen::Matrix3d turn_B;              ///< of the far axes, per change of the rotation
    std::array<clearance::Rest, 3> rests;
  };

  /// What a link hands to its near frame, and the load at its far frame, all in base axes.
  struct Carried {
    Eigen::Vector3d chord, weight, force, moment;
  };

  struct Direct;
  struct State;

  [[nodiscard]] Element elementOf(const InwardSweep& sweep, std::size_t link) const;
  [[nodiscard]] Direct directly(const ArmOf<Dual>& arm, const PostureOf<Dual>& posture) const;
  void moveFrames(const Direct& direct, State& state) const;
  void moveLoads(const Direct& direct, State& state) const;
  void deflectElement(std::size_t link, const Direct& direct, const VectorTangent& chord, const VectorTangent& weight,
                      State& state) const;
  [[nodiscard]] FrameTangent tipInBase(const Direct& direct, const State& state) const;

  Situation<double> situation_;
  ArmOf<Dual> constant_arm_;  ///< the situation's, in dual numbers
  Chain<double> chain_;
  double reach_;
  int enough_;  ///< passes after which only rounding still moves
  std::vector<PoseOf<double>> frames_;
  std::vector<Carried> carried_;   ///< by link
  std::vector<Element> elements_;  ///< by component
};

}  // namespace tubeplan::deflection
