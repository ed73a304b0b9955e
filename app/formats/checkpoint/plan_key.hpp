// What a plan was asked, in parts that can be compared: two plans with the same parts are the same plan.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "app/formats/cell/cell_reader.hpp"
#include "planner/visit_conditions.hpp"
#include "planner/visit_plan.hpp"
#include "planner/workcell.hpp"

namespace tubeplan::app {

/// By name, in a fixed order. Values are short texts: a number, a word or a fingerprint.
using PlanKey = std::vector<std::pair<std::string, std::string>>;

/// The part that travels from the start and to the end posture depend on.
inline constexpr const char* kEndsPart = "start and end";

struct PlanKeyInputs {
  const Cell& cell;
  const planner::Workcell& model;  ///< as planned with: base as calibrated, load, insertion
  const planner::VisitConditions& conditions;
  std::string compensation;
  double standoff = 0;  ///< m
  double padding = 0;   ///< standard deviations of the base's place
  std::uint64_t seed = 1;
  std::string from;  ///< fingerprint of the memory that the plan begins with; empty without
  planner::TravelKind travel = planner::TravelKind::kJoints;
};

/// program, arm and scene, base, load, clearance, compensation, insertion, tilt allowed, travel, sheet: what proved
/// motions and postures depend on; then seed, tubes, start and end, other conditions and from.
[[nodiscard]] PlanKey planKeyOf(const PlanKeyInputs& inputs, const std::vector<int>& tubes);

/// The program's version and the fingerprint of its own bytes: another build may round otherwise.
[[nodiscard]] std::string programText();

/// Of a cell's values, but for its name, base, sheet, tool and what is to be identified.
[[nodiscard]] std::string modelFingerprint(const Cell& cell);

/// Of a matrix's numbers, to the last bit.
[[nodiscard]] std::string numbersFingerprint(const Eigen::Ref<const Eigen::MatrixXd>& numbers);

/// Names of the parts that differ, "another seed (1, now 2)" each; empty when the questions are the same.
[[nodiscard]] std::vector<std::string> findDifferences(const PlanKey& before, const PlanKey& now);

/// The same, but of those parts alone that proved motions and postures depend on.
[[nodiscard]] std::vector<std::string> findModelDifferences(const PlanKey& before, const PlanKey& now);

/// A part's value; empty where there is none.
[[nodiscard]] std::string partOf(const PlanKey& question, std::string_view name);

/// 16 hexadecimal digits.
[[nodiscard]] std::string fingerprintOf(std::string_view bytes);

}  // namespace tubeplan::app
