#include <fmt/format.h>

#include <cmath>

#include "tubesheets/stepped_tool.hpp"

namespace tubeplan::tubesheets {
namespace {

constexpr double kGapSlack = 1.05;  // tolerances are quoted to three digits, so they may exceed the gap slightly

bool isPositive(double number) { return std::isfinite(number) && number > 0; }

void findStepProblems(const Step& step, const std::string& name, double hole_diameter, std::vector<Problem>& problems) {
  if (!isPositive(step.diameter) || !(step.diameter < hole_diameter))
    problems.push_back({name + ".diameter", fmt::format("{:.6g} m", step.diameter),
                        fmt::format("a length above zero and below the hole's diameter, {:.6g} m", hole_diameter), ""});
  if (!isPositive(step.tolerance))
    problems.push_back({name + ".tolerance", fmt::format("{:.6g} m", step.tolerance), "a number above zero", ""});
  const double gap = (hole_diameter - step.diameter) / 2;
  if (isPositive(gap) && isPositive(step.tolerance) && step.tolerance > kGapSlack * gap)
    problems.push_back({name + ".tolerance", fmt::format("{:.6g} m", step.tolerance),
                        fmt::format("at most the gap between step and hole, {:.6g} m", gap), "check the unit"});
}

void findOrderProblems(const Step& before, const Step& step, const std::string& name, std::vector<Problem>& problems) {
  if (!(step.diameter > before.diameter))
    problems.push_back({name + ".diameter", fmt::format("{:.6g} m", step.diameter),
                        fmt::format("more than that of the step before, {:.6g} m", before.diameter),
                        "list the thinnest step first"});
  if (!(step.tolerance < before.tolerance))
    problems.push_back({name + ".tolerance", fmt::format("{:.6g} m", step.tolerance),
                        fmt::format("less than that of the step before, {:.6g} m", before.tolerance),
                        "a thicker step needs better centring"});
}

}  // namespace

std::vector<Problem> findToolProblems(const SteppedTool& tool, double hole_diameter) {
  if (tool.steps.empty()) return {{"steps", "no step", "at least one", ""}};
  std::vector<Problem> problems;
  for (std::size_t k = 0; k < tool.steps.size(); ++k) {
    const std::string name = fmt::format("steps[{}]", k);
    findStepProblems(tool.steps[k], name, hole_diameter, problems);
    if (k > 0) findOrderProblems(tool.steps[k - 1], tool.steps[k], name, problems);
  }
  if (!tool.lengths.empty() && tool.lengths.size() != tool.steps.size())
    problems.push_back({"lengths", fmt::format("{} numbers", tool.lengths.size()),
                        fmt::format("one for each of the {} steps", tool.steps.size()), ""});
  for (std::size_t k = 0; k < tool.lengths.size(); ++k)
    if (!isPositive(tool.lengths[k]))
      problems.push_back(
          {fmt::format("lengths[{}]", k), fmt::format("{:.6g} m", tool.lengths[k]), "a number above zero", ""});
  return problems;
}

}  // namespace tubeplan::tubesheets
