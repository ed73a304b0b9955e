#include "app/commands/plan_identity.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tubeplan::app {

namespace {

using tubesheets::Leg;
using tubesheets::tubeName;

constexpr std::size_t kMostRows = 20;

std::string echoText(const TubeEcho& echo) { return fmt::format("{} {}", echo.leg, tubeName(echo.row, echo.column)); }

void checkSheet(const PlanFiles& files, const tubesheets::Sheet& sheet, std::vector<std::string>& problems) {
  if (files.fingerprint != sheet.fingerprint()) {
    const bool is_mirrored = files.fingerprint == mirroredLeg(sheet).fingerprint();
    problems.push_back(fmt::format("the plan was made for another sheet (fingerprint {}){}", files.fingerprint,
                                   is_mirrored ? ": the mirror image of this one, the other leg" : ""));
  }
  const auto leg = tubesheets::legName(sheet.leg);
  const auto side = tubesheets::viewedFromName(sheet.viewed_from);
  if (files.leg != leg)
    problems.push_back(fmt::format("the plan is for the {} leg, the cell's sheet is the {} leg's", files.leg, leg));
  if (files.viewed_from != side)
    problems.push_back(
        fmt::format("the plan's sheet is viewed from {}, the cell's from {}: one of the two pictures is "
                    "mirrored",
                    files.viewed_from, side));
}

/// Returns the tube of a path segment. A visit has three segments: the travel to the tube, approach and retreat. The
/// first visit has no travel if the plan has no start posture. A retreat from the tube at which the arm starts comes
/// before all visits, and a final travel to the end posture is counted with the last one.
TubeEcho plannedAt(const PlanFiles& files, int segment) {
  if (files.start_at && segment <= 0) return *files.start_at;
  const int counted = std::max(segment, 0) + (files.start_at ? -1 : files.plan.start ? 0 : 1);
  const auto& tube = files.plan.tubes[std::min(static_cast<std::size_t>(counted / 3), files.plan.tubes.size() - 1)];
  return {files.leg, tube.row, tube.column};
}

void checkPath(const PlanFiles& files, std::vector<std::string>& problems) {
  std::size_t found = 0;
  for (std::size_t k = 0; k < files.path_echoes.size() && found < kMostRows; ++k) {
    if (files.plan.tubes.empty()) continue;
    const TubeEcho planned = plannedAt(files, files.plan.path[k].segment);
    if (files.path_echoes[k] == planned) continue;
    ++found;
    problems.push_back(fmt::format("path row {}: approaches {}, but the plan visits {} there", k + 1,
                                   echoText(files.path_echoes[k]), echoText(planned)));
  }
}

}  // namespace

tubesheets::Sheet mirroredLeg(tubesheets::Sheet sheet) {
  if (sheet.leg != Leg::kFull) sheet.leg = sheet.leg == Leg::kHot ? Leg::kCold : Leg::kHot;
  for (auto& tube : sheet.tubes) tube.y = -tube.y;
  return sheet;
}

std::vector<std::string> findIdentityProblems(const PlanFiles& files, const tubesheets::Sheet& sheet) {
  std::vector<std::string> problems;
  checkSheet(files, sheet, problems);
  for (std::size_t k = 0; k < files.tube_legs.size(); ++k)
    if (files.tube_legs[k] != files.leg)
      problems.push_back(fmt::format("{} is stated to be in the {} leg, the plan in the {} leg",
                                     tubeName(files.plan.tubes[k].row, files.plan.tubes[k].column), files.tube_legs[k],
                                     files.leg));
  checkPath(files, problems);
  if (!files.stated_path.empty() && files.stated_path != files.path_fingerprint)
    problems.push_back(
        fmt::format("path.csv differs from the path that plan.json was written with (fingerprint {}, stated {}): a row "
                    "was altered, or it belongs to another plan",
                    files.path_fingerprint, files.stated_path));
  return problems;
}

}  // namespace tubeplan::app
