// Question of a plan in parts that can be compared: equal parts lead to equal plans.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "app/formats/cell/cell_reader.hpp"
#include "planner/visit_conditions.hpp"
#include "planner/visit_plan.hpp"
#include "planner/workcell.hpp"

namespace tubeplan::app {

/// Parts of a question by name, in a fixed order. Values are short texts: a number, a word or a fingerprint.
using PlanKey = std::vector<std::pair<std::string, std::string>>;

/// Name of the part on which travels from the start and to the end posture depend.
inline constexpr const char* kEndsPart = "start and end";

struct PlanKeyInputs {
  const Cell& cell;
  const planner::Workcell& model;  ///< model used for planning: base as calibrated, load, insertion
  const planner::VisitConditions& conditions;
  std::string compensation;
  double standoff = 0;  ///< depth below the face where an approach begins [m]
  double padding = 0;   ///< additional clearance [standard deviations of the base's place]
  std::uint64_t seed = 1;
  std::string from;  ///< fingerprint of the memory from which the plan begins; empty without
  planner::TravelKind travel = planner::TravelKind::kJoints;
};

/// Returns the parts of a question. Proved motions and postures depend on the first ones: program, arm and scene, base,
/// load, clearance, compensation, insertion, tilt allowed, travel, sheet. The others are seed, tubes, start and end,
/// other conditions and from.
[[nodiscard]] PlanKey planKeyOf(const PlanKeyInputs& inputs, const std::vector<int>& tubes);

/// Returns the program's version and the fingerprint of its executable, because another build may round differently.
[[nodiscard]] std::string programText();

/// Returns the fingerprint of a cell's values, except its name, base, sheet, tool and the numbers to be identified.
[[nodiscard]] std::string modelFingerprint(const Cell& cell);

/// Returns the fingerprint of a matrix's numbers, exact to the last bit.
[[nodiscard]] std::string numbersFingerprint(const Eigen::Ref<const Eigen::MatrixXd>& numbers);

/// Returns the parts that differ, as "another seed (1, now 2)" each; empty if the questions are the same.
[[nodiscard]] std::vector<std::string> findDifferences(const PlanKey& before, const PlanKey& now);

/// Returns the differences of those parts on which proved motions and postures depend.
[[nodiscard]] std::vector<std::string> findModelDifferences(const PlanKey& before, const PlanKey& now);

/// Returns the value of a part; empty if there is none.
[[nodiscard]] std::string partOf(const PlanKey& question, std::string_view name);

/// Returns a fingerprint of 16 hexadecimal digits.
[[nodiscard]] std::string fingerprintOf(std::string_view bytes);

}  // namespace tubeplan::app
