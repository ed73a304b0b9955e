// An arm prepared for many postures: values that do not depend on the posture are computed once, and solving a shape
// does not allocate memory.
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

/// Solves one posture after another; each thread needs its own object.
class PreparedArm {
 public:
  /// `arm` must outlive this object, and must not change.
  explicit PreparedArm(const Arm& arm);
  PreparedArm(const PreparedArm&) = delete;
  PreparedArm& operator=(const PreparedArm&) = delete;
  ~PreparedArm();

  /// Solves the deflected shape at a posture. The other functions refer to the posture solved last.
  KinematicsStatus solve(const Posture& posture, const FlexibleKinematicsOptions& options = {});

  /// Returns true if a kernel solves the shape at every posture, with derivatives with respect to the joints.
  [[nodiscard]] bool hasJacobian() const;

  /// Returns the rule that combines a kernel's derivatives into derivatives with respect to `variables`, or null if
  /// there is none. The rule is computed once for repeated calls with the same variables; it is valid until a call with
  /// other variables.
  [[nodiscard]] const simd::RevoluteVariables* kernelFor(const std::vector<Variable>& variables);

  /// Solves a posture, and writes to `derivatives` the kernel's derivatives that `variables`, a rule from kernelFor(),
  /// combines. They are laid out for a single lane.
  KinematicsStatus solveWithDerivatives(const Posture& posture, const FlexibleKinematicsOptions& options,
                                        const simd::RevoluteVariables& variables, double* derivatives);

  /// Returns the arm in the form for kernels, valid for every posture, or null if no kernel can solve the arm
  /// (revolute_chain/revolute_chain.hpp).
  [[nodiscard]] const simd::RevoluteChain* revoluteChain() const;

  [[nodiscard]] KinematicsStatus status() const { return status_; }
  [[nodiscard]] std::string reason() const;

  /// Returns the deflected pose of the tip, with the last row's axes, in the nominal base; NaN if an effect is
  /// undefined.
  [[nodiscard]] const PoseOf<double>& X_BD() const { return X_BD_; }

  /// Returns a row's deflected frame in the nominal base.
  [[nodiscard]] PoseOf<double> X_BL(int row) const;

  /// Returns the complete shape: frames, loads and deflections.
  [[nodiscard]] FlexibleKinematics shape() const;

  /// Accessors of the last shape, for computing its derivatives: the arm and posture with effects applied, the chain,
  /// its elements and loads at equilibrium, the near frames of all links followed by the tip's frame, and the pose of
  /// the base moved by effects (null without effects).
  [[nodiscard]] const Arm& effective() const { return context_ ? context_->arm : arm_; }
  [[nodiscard]] const Posture& effectivePosture() const { return context_ ? context_->posture : nominal_posture_; }
  [[nodiscard]] const Chain<double>& chain() const { return chain_; }
  [[nodiscard]] const Equilibrium& equilibrium() const {
    if (!is_copied_out_) copyOutElements();
    return equilibrium_;
  }
  [[nodiscard]] const PoseOf<double>* movedBase() const { return context_ ? &context_->X_BM : nullptr; }
  void linkFrames(bool rigid, std::vector<PoseOf<double>>& frames) const;

 private:
  /// Rotation of a joint at a link of the chain.
  struct JointTurn {
    std::size_t link;
    int joint;      ///< joint index; -1 if the joint follows others
    double offset;  ///< offset of the joint's reading [rad]
    int row;
  };
  /// A rigid part of a body, followed by the rotation of a joint. `turn` is -1 if there is none.
  struct RigidPart {
    RigidBody rigid;
    bool has_rotation = false;
    int turn = -1;
  };
  /// Attachment of a load other than gravity: the load, the rigid part that carries it, and its position in the part's
  /// near axes.
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
  Posture nominal_posture_;
  std::optional<EffectContext<double>> context_;  ///< effects at the current posture; empty if there are none
  bool is_fixed_;                                 ///< true if the links are the same at every posture
  bool is_prepared_ = false;                      ///< true if is_fixed_ and the members below are set
  Chain<double> chain_;                           ///< chain with the revolute joints at zero
  std::vector<JointTurn> turns_;
  std::vector<RigidPart> parts_;
  std::vector<std::size_t> part_ends_;  ///< for each body, the index after its last part
  std::vector<Hanging> hanging_;
  /// Elements and loads at equilibrium, filled by copyOutElements() on demand if a kernel has solved the shape.
  mutable Equilibrium equilibrium_;
  std::unique_ptr<const simd::RevoluteChain> revolute_chain_;  ///< the arm in kernel form; null if there is none
  std::vector<double> element_states_;                         ///< a kernel's Shapes::element_states
  std::vector<Variable> kernel_variables_;                     ///< variables of the last call of kernelFor()
  std::unique_ptr<const simd::RevoluteVariables> kernel_;      ///< rule for kernel_variables_; null if there is none
  mutable bool is_copied_out_ = true;
  int iterations_ = 0;
  KinematicsStatus status_ = KinematicsStatus::kNotRun;
  PoseOf<double> X_BD_;
};

}  // namespace tubeplan::deflection
