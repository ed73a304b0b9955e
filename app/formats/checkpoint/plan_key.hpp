// The inputs that determine a plan, called its question, divided into parts that can be compared. Equal parts lead to
// equal plans.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "app/formats/cell/cell_reader.hpp"
#include "planner/visit_conditions.hpp"
#include "planner/visit_plan.hpp"
#include "planner/workcell.hpp"

namespace tubeplan::app {

/// Inputs of a plan as a list of parts, each a name and a value, in a fixed order. Values are short strings: a number,
/// a word or a fingerprint.
using PlanKey = std::vector<std::pair<std::string, std::string>>;

/// Name of the part with the start and end postures; only the motions from and to these postures depend on it.
inline constexpr const char* kEndsPart = "start and end";

struct PlanKeyInputs {
  const Cell& cell;
  const planner::Workcell& model;  ///< model used for planning, with the calibrated base, the load and the insertion
  const planner::VisitConditions& conditions;
  std::string compensation;
  double standoff = 0;  ///< depth below the sheet's face at which an approach begins [m]
  /// True if each hole is approached from the shortest clear distance, up to `standoff`.
  bool has_least_standoff = false;
  double padding = 0;  ///< additional clearance [standard deviations of the base position]
  std::uint64_t seed = 1;
  std::string from;  ///< fingerprint of the earlier plan's memory.json; empty if there is no earlier plan
  planner::TravelKind travel = planner::TravelKind::kJoints;
};

/// Returns the inputs of a plan as a list of parts. Proved motions and postures depend only on the first parts:
/// program, arm and scene, base, load, clearance, compensation, insertion, tilt allowed, travel, sheet. The remaining
/// parts are seed, tubes, start and end, other conditions and from.
[[nodiscard]] PlanKey planKeyOf(const PlanKeyInputs& inputs, const std::vector<int>& tubes);

/// Returns the program's version and the fingerprint of its executable, because another build may round differently.
[[nodiscard]] std::string programText();

/// Returns the fingerprint of a cell's values that describe arm and scene. It excludes the name, base, sheet, tool and
/// park posture, the parameters to be identified and their uncertainty.
[[nodiscard]] std::string modelFingerprint(const Cell& cell);

/// Returns the fingerprint of a matrix's elements, exact to the last bit.
[[nodiscard]] std::string numbersFingerprint(const Eigen::Ref<const Eigen::MatrixXd>& numbers);

/// Returns the parts in which the inputs of two plans differ, each as "another seed (1, now 2)"; empty if they are
/// equal.
[[nodiscard]] std::vector<std::string> findDifferences(const PlanKey& before, const PlanKey& now);

/// Returns only the differences in parts on which proved motions and postures depend.
[[nodiscard]] std::vector<std::string> findModelDifferences(const PlanKey& before, const PlanKey& now);

/// Returns the value of the part with the given name; empty if there is none.
[[nodiscard]] std::string partOf(const PlanKey& question, std::string_view name);

/// Returns a fingerprint of the bytes, 16 hexadecimal digits.
[[nodiscard]] std::string fingerprintOf(std::string_view bytes);

}  // namespace tubeplan::app
