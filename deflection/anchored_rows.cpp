#include "deflection/anchored_rows.hpp"

#include <algorithm>
#include <cmath>

#include "deflection/chain.hpp"
#include "deflection/shortest_chain.hpp"

namespace tubeplan::deflection {

using Eigen::Vector3d;

namespace {

/// Returns the name of the property that fixes the origin of a row: its beam, an effect, or a weight along its member
/// or at the member's end. Empty if there is none.
std::string heldByMember(const Row<double>& row) {
  if (row.beam) return "a beam";
  if (row.effect_terms) return "an effect";
  return row.weight.distributed != 0 || row.weight.end != 0 ? "a weight along or at the end of it" : "";
}

/// Returns the origins of base, rows and tip with all joints at zero, each with its z axis and whether it may slide
/// along that axis.
std::vector<ChainLine> slidableOrigins(const Arm& arm) {
  std::vector<ChainLine> chain{{Vector3d::Zero(), Vector3d::UnitZ(), false}};
  PoseOf<double> X_BL;
  for (std::size_t k = 0; k < arm.rows.size(); ++k) {
    X_BL = X_BL * PoseOf<double>{rotationFromPrevious<double>(arm.rows[k]), offsetInPreviousAxes<double>(arm.rows[k])};
    chain.push_back({X_BL.p, X_BL.R.col(2), heldAgainstSlide(arm, k).empty()});
  }
  chain.push_back({X_BL.p + X_BL.R * arm.p_LT, Vector3d::UnitZ(), false});
  return chain;
}

void slideRow(const Row<double>& given, double before, double by, Row<double>& row) {
  if (before == 0 && by == 0) return;
  const Eigen::Matrix3d R = rotationFromPrevious<double>(given);
  row.placement = Origin<double>{offsetInPreviousAxes<double>(given) - before * Vector3d::UnitZ() + by * R.col(2),
                                 fixedAnglesOf(R)};
  for (auto& lump : row.weight.lumps) lump.at.z() -= by;
}

}  // namespace

std::string heldAgainstSlide(const Arm& arm, std::size_t k) {
  const Row<double>& row = arm.rows[k];
  if (const std::string held = heldByMember(row); !held.empty())
    return "its origin is where its member with " + held + " begins";
  if (const std::string held = k > 0 ? heldByMember(arm.rows[k - 1]) : ""; !held.empty())
    return "its origin is where the member before it, with " + held + ", ends";
  if (row.joint_stiffness.head<2>().array().isFinite().any())
    return "its joint_stiffness across the joint's axis acts at its origin";
  const bool carries = std::any_of(arm.side_chains.begin(), arm.side_chains.end(),
                                   [&](const auto& chain) { return chain.row == static_cast<int>(k); });
  return carries ? "a side chain is on it" : "";
}

AnchoredRows anchoredRows(const Arm& arm) {
  AnchoredRows anchored{arm, std::vector<double>(arm.rows.size(), 0.)};
  std::vector<ChainLine> chain = slidableOrigins(arm);
  const std::vector<double> slid = drawTogether(chain);
  if (std::all_of(slid.begin(), slid.end(), [](double by) { return by == 0; })) return anchored;
  anchored.arm.effects.clear();
  double before = 0;
  for (std::size_t k = 0; k < arm.rows.size(); ++k) {
    anchored.slid[k] = slid[k + 1];
    slideRow(arm.rows[k], before, slid[k + 1], anchored.arm.rows[k]);
    before = slid[k + 1];
  }
  anchored.arm.p_LT.z() -= before;
  return anchored;
}

}  // namespace tubeplan::deflection
