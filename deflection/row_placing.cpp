#include "deflection/row_placing.hpp"

#include <algorithm>
#include <cassert>

#include "deflection/frames_along_chords.hpp"
#include "deflection/revolute_chain/kernels.hpp"
#include "deflection/revolute_chain/plain_pose.hpp"
#include "deflection/revolute_chain/revolute_chain.hpp"

namespace tubeplan::deflection {

using Eigen::Index, Eigen::Isometry3d, Eigen::Vector3d, Eigen::VectorXd;
using simd::copy, simd::kMostLanes, simd::plainPose, simd::RevoluteChain;

namespace {

/// Default options of the solver.
constexpr FlexibleKinematicsOptions kUsual;
constexpr double kBowMargin = 1.1;

}  // namespace

/// The arm in kernel form.
struct RowPlacing::Plain {
  const RevoluteChain& chain;
  std::vector<simd::PlainRow> rows;
  std::vector<simd::BentPiece> pieces;
  simd::PlainPose X_WB;

  [[nodiscard]] simd::PlainArm arm() const { return {rows.data(), pieces.data(), static_cast<int>(rows.size()), X_WB}; }

  /// Returns the arm in kernel form, or null if no kernel can place it. `components` are the arm's elements in order.
  static std::unique_ptr<const Plain> of(const Arm& given, const Isometry3d& X_WB, const PreparedArm& arm,
                                         const std::vector<ComponentState>& components) {
    const RevoluteChain* chain = arm.revoluteChain();
    if (!chain || chain->rows().size() != given.rows.size() || chain->rows().size() > simd::kMostRows) return nullptr;
    auto plain = std::make_unique<Plain>(Plain{*chain, {}, {}, plainPose(X_WB)});
    for (int row = 0; row < static_cast<int>(given.rows.size()); ++row) plain->addRow(given, row, components);
    return plain;
  }

  void addRow(const Arm& arm, int row, const std::vector<ComponentState>& components) {
    const auto& found = chain.rows()[static_cast<std::size_t>(row)];
    assert(found.row == row);
    const Vector3d member = memberOf(arm, row);
    simd::PlainRow plain{};
    plain.turn = found.turn;
    plain.X_TL = plainPose(found.X_TL.R, found.X_TL.p);
    plain.is_at_turn = found.X_TL.R.isIdentity(0) && found.X_TL.p.isZero(0);
    plain.along_chord = arm.rows[static_cast<std::size_t>(row)].beam && !member.isZero(0);
    copy(member, plain.member);
    plain.first_piece = static_cast<int>(pieces.size());
    if (plain.along_chord) addPieces(row, member, components);
    plain.pieces = static_cast<int>(pieces.size()) - plain.first_piece;
    plain.bow_factor = kBowMargin * member.norm() / 8;
    rows.push_back(plain);
  }

  void addPieces(int row, const Vector3d& member, const std::vector<ComponentState>& components) {
    const auto numbers = chain.numbers();
    for (std::size_t e = 0; e < components.size(); ++e) {
      const auto& hinge = chain.elements()[e];
      if (components[e].row != row || hinge.turn < 0 ||
          elementKinds()[static_cast<std::size_t>(components[e].kind)].place != ElementPlace::kMember)
        continue;
      simd::BentPiece piece{};
      piece.turn = hinge.turn;
      piece.bends = hinge.is_beam;
      piece.compliance = hinge.compliance;
      piece.others = numbers.turns[hinge.turn].compliance - hinge.compliance;
      copy(hinge.member, piece.along);
      copy(hinge.axis.cross(hinge.member), piece.across);
      copy(hinge.axis.cross(member), piece.turning);
      pieces.push_back(piece);
    }
  }
};

Isometry3d PlacedRows::X_WL(int row, int lane) const {
  const double* at = frames.data() + 12 * row * lanes + lane;
  const auto number = [&](int k) { return at[k * lanes]; };
  Isometry3d X = Isometry3d::Identity();
  X.translation() = Vector3d(number(0), number(1), number(2));
  for (int k = 0; k < 9; ++k) X.linear()(k % 3, k / 3) = number(3 + k);
  return X;
}

RowPlacing::RowPlacing(const Arm& arm, double load, const Isometry3d& X_WB)
    : given_(arm), load_(load), X_WB_(X_WB), gravity_B_(gravityInBase(arm, X_WB)), arm_(arm) {
  const auto joints = arm.jointCount();
  constexpr std::size_t kLanes = kMostLanes;
  if (arm_.revoluteChain()) {
    arm_.solve({VectorXd::Zero(joints), load, gravity_B_});
    plain_ = Plain::of(arm, X_WB, arm_, arm_.shape().components);
  }
  q_.resize(static_cast<std::size_t>(joints) * kLanes);
  loads_.assign(kLanes, load);
  placed_.frames.resize(12 * kLanes * arm.rows.size());
  placed_.bow.resize(kLanes);
  placed_.is_converged.resize(kLanes);
  if (!plain_) return;
  const auto turns = static_cast<std::size_t>(plain_->chain.numbers().count);
  tip_.resize(12 * kLanes);
  turns_.resize(12 * kLanes * turns);
  element_states_.resize(4 * kLanes * turns);
  sweeps_.resize(kLanes);
}

RowPlacing::~RowPlacing() = default;

int RowPlacing::lanes() const { return simd::kernels().back().lanes; }

const PlacedRows& RowPlacing::place(const Side& q, Index first) {
  const int count = static_cast<int>(std::min<Index>(q.cols() - first, lanes()));
  assert(count > 0 && q.rows() * kMostLanes == static_cast<Index>(q_.size()));
  const int width = placed_.lanes = simd::kernelFor(count).lanes;
  for (Index joint = 0; joint < q.rows(); ++joint)
    for (int l = 0; l < width; ++l)
      q_[static_cast<std::size_t>(joint * width + l)] = q(joint, first + std::min(l, count - 1));
  return run(count);
}

const PlacedRows& RowPlacing::place(const VectorXd& q) {
  assert(q.size() * kMostLanes == static_cast<Index>(q_.size()));
  placed_.lanes = 1;
  std::copy_n(q.data(), q.size(), q_.begin());
  return run(1);
}

const PlacedRows& RowPlacing::run(int count) {
  placed_.count = count;
  if (plain_)
    runKernel();
  else
    runOneByOne();
  return placed_;
}

void RowPlacing::runKernel() {
  const int width = placed_.lanes;
  const simd::Kernel& kernel = simd::kernelFor(width);
  assert(kernel.lanes == width);
  const simd::RevoluteArm arm = plain_->chain.numbers();
  double gravity[3 * kMostLanes];
  for (int k = 0; k < 3 * width; ++k) gravity[k] = gravity_B_[k / width];
  simd::Shapes shapes{};
  shapes.pose = tip_.data();
  shapes.sweeps = sweeps_.data();
  shapes.element_states = element_states_.data();
  shapes.turns = turns_.data();
  shapes.stride = width;
  kernel.solve(arm, {q_.data(), loads_.data(), gravity, width, kUsual.tolerance * arm.reach, kUsual.max_iterations},
               shapes);
  kernel.place(plain_->arm(), {tip_.data(), turns_.data(), element_states_.data(), width},
               {placed_.frames.data(), placed_.bow.data(), width});
  for (int l = 0; l < width; ++l)
    placed_.is_converged[static_cast<std::size_t>(l)] = !(sweeps_[static_cast<std::size_t>(l)] < 0);
}

void RowPlacing::runOneByOne() {
  const int width = placed_.lanes;
  VectorXd q(static_cast<Index>(q_.size()) / kMostLanes);
  for (int l = 0; l < width; ++l) {
    const auto lane = static_cast<std::size_t>(l);
    for (Index joint = 0; joint < q.size(); ++joint) q[joint] = q_[static_cast<std::size_t>(joint * width + l)];
    // The remaining lanes repeat the last posture, which is already solved.
    if (l < placed_.count)
      placed_.is_converged[lane] = arm_.solve({q, load_, gravity_B_}) == KinematicsStatus::kConverged;
    else
      placed_.is_converged[lane] = placed_.is_converged[lane - 1];
    const auto frames = placed_.is_converged[lane]
                            ? framesAlongChords(given_, X_WB_, arm_.shape(), &placed_.bow[lane])
                            : std::vector<Isometry3d>(given_.rows.size(), Isometry3d::Identity());
    for (std::size_t row = 0; row < frames.size(); ++row) {
      double* to = placed_.frames.data() + 12 * row * static_cast<std::size_t>(width) + lane;
      for (int k = 0; k < 3; ++k) to[k * width] = frames[row].translation()[k];
      for (int k = 0; k < 9; ++k) to[(3 + k) * width] = frames[row].linear()(k % 3, k / 3);
    }
  }
}

}  // namespace tubeplan::deflection
