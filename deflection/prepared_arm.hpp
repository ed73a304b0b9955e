// An arm made ready for many postures: what no posture changes is worked out once, and solving a shape takes nothing
// from the heap.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "deflection/chain.hpp"
#include "deflection/effects/effect_context.hpp"
#include "deflection/equilibrium.hpp"
#include "deflection/flexible_kinematics.hpp"

namespace tubeplan::deflection {

namespace simd {
class RevoluteChain;
class RevoluteVariables;
struct Shapes;
}  // namespace simd
struct Variable;

/// Solves one posture after the other; each thread needs its own.
class PreparedArm {
 public:
  /// `arm` must outlive this, and stay as it is.
  explicit PreparedArm(const Arm& arm);
  PreparedArm(const PreparedArm&) = delete;
  PreparedArm& operator=(const PreparedArm&) = delete;
  ~PreparedArm();

  /// Solves the deflected shape at a posture. All that follows is about the last one solved.
  KinematicsStatus solve(const Posture& posture, const FlexibleKinematicsOptions& options = {});

  /// Whether a kernel solves the shape at every posture, and gives derivatives by joints with it.
  [[nodiscard]] bool hasJacobian() const;

  /// How a kernel's derivatives make those by `variables`; null where they do not. Worked out once for variables that
  /// are asked for again and again, and good until others are.
  [[nodiscard]] const simd::RevoluteVariables* kernelFor(const std::vector<Variable>& variables);

  /// Solves a posture with the derivatives that `variables` of kernelFor() is put together from, as one lane of a
  /// kernel writes them.
  KinematicsStatus solveWithDerivatives(const Posture& posture, const FlexibleKinematicsOptions& options,
                                        const simd::RevoluteVariables& variables, double* derivatives);

  /// The arm as a kernel takes it, for every posture alike; null where it is not (revolute_chain/revolute_chain.hpp).
  [[nodiscard]] const simd::RevoluteChain* revoluteChain() const;

  [[nodiscard]] KinematicsStatus status() const { return status_; }
  [[nodiscard]] std::string reason() const;

  /// The last row's axes at the deflected tip, in the base as named; not numbers where an effect is undefined.
  [[nodiscard]] const PoseOf<double>& X_BD() const { return X_BD_; }

  /// A row's frame as deflected, in the base as named.
  [[nodiscard]] PoseOf<double> X_BL(int row) const;

  /// All that is known of the shape.
  [[nodiscard]] FlexibleKinematics shape() const;

  /// What derivatives of the shape are taken from: the arm and the posture with its effects, the chain that was put
  /// together from them, its elements and loads at rest, the near frame of every link and the tip's, and the base as
  /// effects have moved it (null where there are none).
  [[nodiscard]] const Arm& effective() const { return context_ ? context_->arm : arm_; }
  [[nodiscard]] const Posture& effectivePosture() const { return context_ ? context_->posture : asked_; }
  [[nodiscard]] const Chain<double>& chain() const { return chain_; }
  [[nodiscard]] const Equilibrium& equilibrium() const {
    if (!is_copied_out_) copyOutElements();
    return equilibrium_;
  }
  [[nodiscard]] const PoseOf<double>* movedBase() const { return context_ ? &context_->X_BM : nullptr; }
  void linkFrames(bool rigid, std::vector<PoseOf<double>>& frames) const;

 private:
  /// The turn of a joint, by a link of the chain.
  struct JointTurn {
    std::size_t link;
    int joint;      ///< -1 where it follows others
    double offset;  ///< of the joint's reading [rad]
    int row;
  };
  /// A rigid part of a body, then the turn of a joint (-1: none).
  struct RigidPart {
    RigidBody rigid;
    bool has_rotation = false;
    int turn = -1;
  };
  /// Where a load other than gravity hangs: which one, in which body and before which of its parts.
  struct Hanging {
    std::size_t load;
    int part;
    Eigen::Vector3d place;
  };

  void prepare(const Arm& arm, const Eigen::VectorXd& q);
  void prepareFixed();
  [[nodiscard]] double angleOf(const JointTurn& turn, const Eigen::VectorXd& q) const;
  void findRevoluteChain(const Arm& arm);
  KinematicsStatus solveRevoluteChain(const FlexibleKinematicsOptions& options, simd::Shapes out);
  void copyOutElements() const;
  void addLink(const Arm& arm, const std::vector<int>& joints, std::size_t k);
  void addElement(const Arm& arm, const ChainLink<double>& link);
  void addTipLoad(const Eigen::Vector3d& direction_B, bool is_couple);
  void pose(const Eigen::VectorXd& q) const;
  void load(const Arm& arm, const Posture& posture) const;
  void undefine();
  template <class Visit>
  void walkLinks(bool rigid, Visit&& visit) const;
  void recordLoads(const std::vector<PoseOf<double>>& frames, std::vector<RowState>& rows) const;

  const Arm& arm_;
  Posture asked_;
  std::optional<EffectContext<double>> context_;  ///< where the arm has effects
  bool is_fixed_;                                 ///< no slides, nothing that depends on the posture: the same links
  bool is_prepared_ = false;                      ///< what follows is of the fixed arm
  Chain<double> chain_;                           ///< with the turning joints at zero
  std::vector<JointTurn> turns_;
  std::vector<RigidPart> parts_;
  std::vector<std::size_t> part_ends_;  ///< of each body
  std::vector<Hanging> hanging_;
  mutable Equilibrium
      equilibrium_;  ///< where a kernel has solved the shape, filled by copyOutElements() when asked for
  std::unique_ptr<const simd::RevoluteChain>
      revolute_chain_;                                     ///< the same arm for the kernels, where it is one for them
  std::vector<double> element_states_;                     ///< what a kernel has found of each turn
  std::vector<Variable> kernel_asked_;                     ///< of kernelFor(), the last ones
  std::unique_ptr<const simd::RevoluteVariables> kernel_;  ///< of those, null where there is none
  mutable bool is_copied_out_ = true;
  int iterations_ = 0;
  KinematicsStatus status_ = KinematicsStatus::kNotRun;
  PoseOf<double> X_BD_;
};

}  // namespace tubeplan::deflection
