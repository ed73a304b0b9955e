#include "app/formats/plan/plan_conditions.hpp"

#include <fmt/format.h>

#include <cmath>

#include "app/formats/cell/command_inputs.hpp"
#include "app/formats/checkpoint/plan_key.hpp"
#include "app/storage/input_error.hpp"
#include "tubesheets/work_list.hpp"

namespace tubeplan::app {

namespace {

std::optional<Eigen::VectorXd> postureOf(const std::string& text, const std::string& option, const Cell& cell) {
  if (text.empty()) return std::nullopt;
  if (text != "park") return parseJoints(text, cell.arm, cell.units, option);
  if (!cell.park)
    throw InputError::problem(cell.path, "there is no key 'park', the park posture that " + option + " asks for",
                              "add park: [...], one reading for each joint, or write the readings after " + option);
  return cell.park;
}

std::string numbersText(const std::optional<Eigen::VectorXd>& q) {
  std::string text;
  if (q)
    for (const double value : *q) text += fmt::format("{:a} ", value);
  return text.empty() ? "anywhere" : text;
}

}  // namespace

std::optional<int> startTubeOf(const ConditionsRequest& request, const tubesheets::Sheet& sheet) {
  const auto name = tubesheets::parseTubeName(request.start);
  if (!name) return std::nullopt;
  if (const auto tube = sheet.indexOf(name->row, name->column)) return tube;
  throw InputError::problem("--start", fmt::format("{} is not on this sheet", inQuotes(request.start)),
                            "name the tube at which the arm is, or write its joint readings, --start=A,B,...");
}

planner::VisitConditions conditionsOf(const ConditionsRequest& request, const Cell& cell,
                                      std::map<int, double> dwell_at) {
  planner::VisitConditions conditions;
  const auto& sheet = requireSheet(cell, "plan tube visits");
  if (!startTubeOf(request, sheet)) conditions.start = postureOf(request.start, "--start", cell);
  conditions.end = postureOf(request.end, "--end", cell);
  for (const auto& zone : request.first)
    conditions.zones.push_back(readTubes(zone, sheet, request.columns, "--first").tube_indices);
  if (!(request.dwell >= 0 && request.dwell <= tubesheets::kLongestDwell))
    throw InputError("--dwell", fmt::format("{}", request.dwell), "seconds from 0 to a day");
  conditions.dwell = request.dwell;
  conditions.dwell_at = std::move(dwell_at);
  return conditions;
}

std::string endsText(const planner::VisitConditions& conditions) {
  if (!conditions.start && !conditions.end) return "anywhere";
  return fingerprintOf(numbersText(conditions.start) + "; " + numbersText(conditions.end));
}

std::string conditionsText(const planner::VisitConditions& conditions) {
  std::string text;
  for (const auto& zone : conditions.zones) {
    for (const int tube : zone) text += fmt::format("{} ", tube);
    text += "; ";
  }
  for (const auto& [tube, dwell] : conditions.dwell_at) text += fmt::format("{}:{:a} ", tube, dwell);
  if (text.empty() && conditions.dwell == 0) return "none";
  return fingerprintOf(text + fmt::format("{:a}", conditions.dwell));
}

}  // namespace tubeplan::app
