#include "planner/collision/deflection_travel.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "deflection/chain.hpp"
#include "deflection/effects/effect_context.hpp"
#include "deflection/elements/element.hpp"
#include "planner/collision/anchored_reach.hpp"

namespace tubeplan::planner {

namespace {

using deflection::Arm;

constexpr double kMostBending = 0.1;  // largest rotation of one element for which the bound is proved [rad]
constexpr int kMostTerms = 200;
// Change of a member's bow from its chord, as a fraction of the motion of the member's end.
constexpr double kBowShare = 0.3;

/// A flexible element with its largest moment, weight, reach and rotation over all postures. Every prismatic joint is
/// assumed to be fully extended. The element of a joint is at its row's origin, the element of a beam at the far end of
/// its member.
struct FlexiblePlace {
  int row;
  double compliance;  ///< compliance of the element [rad/(N m)]
  double length;      ///< length of the member, or of the bar of a prismatic joint; 0 for the element of a joint [m]
  double moment;      ///< largest first moment of all weight beyond the near end, about the near end [N m]
  double weight;      ///< weight beyond the near end [N]
  double reach;       ///< largest distance of a body point beyond the near end from that end [m]
  double bending;     ///< largest rotation of the element [rad]
};

double weightOf(const deflection::Row<double>& row, double length) {
  double weight = row.weight.distributed * length + row.weight.end;
  for (const auto& lump : row.weight.lumps) weight += std::abs(lump.weight);
  return weight;
}

/// Returns the first moment of a row's weight about its origin [N m], with its lumped weights moved outwards by `lumps`
/// [m].
double momentOf(const deflection::Row<double>& row, double length, double lumps) {
  double moment = row.weight.distributed * length * length / 2 + row.weight.end * length;
  for (const auto& lump : row.weight.lumps) moment += std::abs(lump.weight) * (lumps + lump.at.norm());
  return moment;
}

double complianceOf(const deflection::Row<double>& row, deflection::ElementPlace place, const Eigen::Vector3d& member) {
  for (const auto& kind : deflection::elementKinds()) {
    if (kind.place != place || !kind.isFlexible(row)) continue;
    const auto flexibility = kind.flexibilityOf(row, member);
    const Eigen::Matrix3d C = flexibility.compliance;
    return C.selfadjointView<Eigen::Lower>().eigenvalues().maxCoeff() + flexibility.softness.maxCoeff();
  }
  return 0;
}

class Bound {
 public:
  /// Prepares the bound; `load` is the weight that hangs from the tip [N].
  Bound(const AnchoredReach& anchored, double load) : arm_(anchored.arm) {
    const int rows = static_cast<int>(arm_.rows.size());
    // Sums the loads beyond each element, from the tip inwards.
    double weight = load, moment = 0, reach = 0;
    for (int row = rows - 1; row >= 0; --row) {
      const auto& numbers = arm_.rows[static_cast<std::size_t>(row)];
      const Eigen::Vector3d member = deflection::memberOf(arm_, row), bar = barOf(numbers, member);
      const double slide = deflection::slideLength(numbers.joint) * kLengthening, step = member.norm() * kLengthening,
                   length = bar.norm() * kLengthening;
      moment += weight * (slide + step) + momentOf(numbers, length, slide);
      weight += weightOf(numbers, length);
      reach = slide + std::max(reach + step, anchored.body_reach[static_cast<std::size_t>(row)]);
      add({row, complianceOf(numbers, deflection::ElementPlace::kMember, bar), length, moment, weight, reach, 0});
      add({row, complianceOf(numbers, deflection::ElementPlace::kOrigin, bar), 0, moment, weight, reach, 0});
      at_origin_.push_back({moment, weight});
    }
    std::ranges::reverse(places_);
    std::ranges::reverse(at_origin_);
    spread();
  }

  [[nodiscard]] bool bendsLittle() const {
    return std::ranges::all_of(places_, [](const FlexiblePlace& place) { return place.bending <= kMostBending; });
  }

  /// Returns how far changes of the deflection move a point per radian or metre of a row's joint [m]; infinite if the
  /// Neumann series does not converge.
  [[nodiscard]] double travelBy(int row) const {
    const bool is_slide = arm_.rows[static_cast<std::size_t>(row)].joint.type == deflection::JointType::kPrismatic;
    Eigen::VectorXd sum(static_cast<Eigen::Index>(places_.size()));
    std::ranges::transform(places_, sum.begin(), [&](const FlexiblePlace& place) {
      return is_slide ? gainedBySlide(place, row) : gainedByTurn(place, row);
    });
    Eigen::VectorXd term = sum;
    for (int k = 0; k < kMostTerms && term.sum() > 1e-12 * sum.sum(); ++k) {
      term = spread_ * term;
      sum += term;
      if (!(sum.sum() < 1e3)) return std::numeric_limits<double>::infinity();
    }
    return moved(sum);
  }

  static constexpr double kLengthening = 1 + kMostBending * kMostBending;

 private:
  struct Hanging {
    double moment, weight;  ///< first moment about the row's origin [N m], and weight [N], of the loads beyond it
  };

  /// Returns the vector along the part of a row that bends [m]: the member, or the fully extended bar of a prismatic
  /// joint.
  static Eigen::Vector3d barOf(const deflection::Row<double>& row, const Eigen::Vector3d& member) {
    if (row.joint.type != deflection::JointType::kPrismatic) return member;
    return deflection::slideLength(row.joint) * Eigen::Vector3d::UnitZ();
  }

  /// Returns an element's rotation per rotation of the joint of `row`, without the coupling between elements [rad/rad].
  /// The joint turns all loads beyond it, but an element further out carries only the loads beyond itself.
  [[nodiscard]] double gainedByTurn(const FlexiblePlace& place, int row) const {
    return place.compliance * std::min(place.moment, at_origin_[static_cast<std::size_t>(row)].moment);
  }

  /// Returns an element's rotation per travel of the prismatic joint of `row`, without the coupling between elements
  /// [rad/m]. A longer bar bends more, because its compliance grows with its length. Elements before the bar carry its
  /// load further out, and the added weight of the bar.
  [[nodiscard]] double gainedBySlide(const FlexiblePlace& place, int row) const {
    if (place.row > row) return 0;
    if (place.row == row && place.length > 0) return kLengthening * place.compliance / place.length * place.moment;
    const double bar_weight = arm_.rows[static_cast<std::size_t>(row)].weight.distributed;
    return place.compliance * (at_origin_[static_cast<std::size_t>(row)].weight + bar_weight * place.reach);
  }

  /// Returns the largest displacement of a member's end per rotation of the member [m/rad].
  static double displacement(const FlexiblePlace& place) { return place.length * (1 + 2 * place.bending); }

  void add(FlexiblePlace place) {
    if (place.compliance <= 0) return;
    place.bending = place.compliance * place.moment;
    places_.push_back(place);
  }

  /// Fills `spread_`: entry (e, other) is the rotation of element e caused by a unit rotation of element `other`
  /// [rad/rad].
  void spread() {
    const auto count = static_cast<Eigen::Index>(places_.size());
    spread_ = Eigen::MatrixXd::Zero(count, count);
    for (Eigen::Index e = 0; e < count; ++e)
      for (Eigen::Index other = 0; other < count; ++other) {
        const FlexiblePlace& turned = places_[static_cast<std::size_t>(e)];
        const FlexiblePlace& turning = places_[static_cast<std::size_t>(other)];
        const double by_displacement = turning.weight * displacement(turning);
        // An inboard element rotates gravity relative to the loads beyond element e. Element e itself or an outboard
        // element rotates and displaces the loads beyond that element.
        const double moment = other < e ? turned.moment : turning.moment + by_displacement;
        spread_(e, other) = turned.compliance * moment;
      }
  }

  /// Returns the motion of a point beyond all elements [m] for these rotations per joint motion, including the rotation
  /// of frames along bent chords and the bow of members.
  [[nodiscard]] double moved(const Eigen::VectorXd& rotations) const {
    double travel = 0;
    for (std::size_t e = 0; e < places_.size(); ++e) {
      const FlexiblePlace& place = places_[e];
      const double bow = kBowShare * displacement(place);
      travel += rotations[static_cast<Eigen::Index>(e)] * ((1 + 2 * place.bending) * place.reach + bow);
    }
    return travel;
  }

  const Arm& arm_;
  std::vector<FlexiblePlace> places_;
  std::vector<Hanging> at_origin_;  ///< loads beyond the origin of each row
  Eigen::MatrixXd spread_;
};

}  // namespace

double gapJumpOf(const Workcell& cell, const std::vector<double>& body_reach) {
  if (!dependsOnPosture(cell.arm)) return 0;
  const deflection::Posture posture{Eigen::VectorXd::Zero(cell.arm.jointCount()), cell.load,
                                    deflection::gravityInBase(cell.arm, cell.X_WB)};
  const auto context = deflection::contextOf(cell.arm, posture);
  const AnchoredReach anchored = anchoredReachOf(context.arm, cell.scene, body_reach);
  double jump = 0, reach = 0;
  for (int row = static_cast<int>(cell.arm.rows.size()) - 1; row >= 0; --row) {
    const auto& numbers = anchored.arm.rows[static_cast<std::size_t>(row)];
    reach = deflection::slideLength(numbers.joint) + std::max(reach + deflection::memberOf(anchored.arm, row).norm(),
                                                              anchored.body_reach[static_cast<std::size_t>(row)]);
    if (numbers.effect_terms) jump += numbers.effect_terms->gap.cwiseAbs().sum() * reach;
  }
  return jump;
}

DeflectionTravel deflectionTravelOf(const Workcell& cell, const std::vector<double>& body_reach) {
  DeflectionTravel travel;
  const auto refuse = [&](std::string reason) {
    travel.reason = std::move(reason);
    return travel;
  };
  travel.jump = gapJumpOf(cell, body_reach);
  if (dependsOnPosture(cell.arm)) return refuse("the arm has effects beyond its elements");
  for (const auto& row : cell.arm.rows)
    if (!std::isfinite(deflection::slideLength(row.joint))) return refuse("the arm has a slide without limits");
  const AnchoredReach anchored = anchoredReachOf(cell.arm, cell.scene, body_reach);
  const Bound bound(anchored, cell.load);
  if (!bound.bendsLittle()) return refuse("an element may rotate by more than 0.1 rad");
  const auto active = deflection::activeRows(cell.arm);
  travel.per_joint.setZero(static_cast<Eigen::Index>(active.size()));
  for (std::size_t j = 0; j < active.size(); ++j)
    for (const auto& turned : deflection::turnedWith(cell.arm, active[j]))
      travel.per_joint[static_cast<Eigen::Index>(j)] += std::abs(turned.ratio) * bound.travelBy(turned.row);
  if (!travel.per_joint.allFinite()) return refuse("the arm is too compliant for its loads");
  travel.stretch = Bound::kLengthening;
  travel.is_proved = true;
  return travel;
}

}  // namespace tubeplan::planner
