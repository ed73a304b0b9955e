// `tubeplan verify`: proves or refutes a plan by code that the planner does not use.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/cli/caller.hpp"
#include "app/cli/command.hpp"
#include "app/cli/planning_hooks.hpp"
#include "app/cli/stop_signal.hpp"
#include "app/commands/option_groups.hpp"
#include "app/commands/plan_identity.hpp"
#include "app/documents/figures.hpp"
#include "app/documents/figures_text.hpp"
#include "app/documents/pose_json.hpp"
#include "app/formats/cell/workcell.hpp"
#include "app/formats/plan/plan_reader.hpp"
#include "app/formats/units.hpp"
#include "app/formats/units_json.hpp"
#include "app/storage/input_error.hpp"
#include "app/studies/positioning/row_deviations.hpp"
#include "app/studies/positioning/step_chances.hpp"
#include "deflection/parameters.hpp"
#include "tubesheets/work_list.hpp"

namespace tubeplan::app {

namespace {

struct VerifyOptions {
  std::string cell, folder;
  FiguresTarget figures;
};

/// Returns a sentence for each difference between the cell's arm and the plan's arm, with the parameter names of arm
/// files.
std::vector<std::string> armDifferences(const deflection::Arm& cell, const deflection::Arm& plan) {
  const auto now = deflection::parametersOf(cell), then = deflection::parametersOf(plan);
  if (now.size() != then.size()) return {"the cell's arm is not that of the plan: its rows or flexible axes differ"};
  std::vector<std::string> differences;
  for (std::size_t k = 0; k < now.size(); ++k)
    if (now[k].name != then[k].name || now[k].value != then[k].value)
      differences.push_back("the cell's arm differs from the plan's at " + then[k].name);
  return differences;
}

/// Returns a workcell with the sheet, tool and scene of the given cell, and with the arm, base, load and insertion of
/// the plan.
planner::Workcell checkedWorkcell(const Cell& cell, const Cell& planned, const PlanFiles& files) {
  planner::Workcell work = workcellOf(cell, "verify a plan on it");
  work.arm = workcellOf(planned, "verify a plan on it").arm;
  work.X_WB = planned.X_WB;
  work.load = files.load;
  work.insertion = files.insertion;
  if (planned.base_covariance) work.base_covariance = *planned.base_covariance;
  return work;
}

nlohmann::json checkJson(const planner::PlanCheck& check, const Cell& planned, const Units& units,
                         const std::vector<std::string>& warnings) {
  return {{"proved", check.status == planner::PlanCheckStatus::kProved},
          {"base", placedBaseJson(planned.X_WB, standingOf(planned), units)},
          {"findings", check.findings},
          {"tubes", check.tubes},
          {"path_rows", check.rows},
          {"worst_centring", check.worst_centring / units.factor(dimension::kLength)},
          {"worst_approach_deviation", lengthOf(check.worst_approach, units)},
          {"worst_tilt", angleOf(check.worst_tilt, units)},
          {"least_play_in_tube",
           std::isfinite(check.least_play) ? nlohmann::json(lengthOf(check.least_play, units)) : nlohmann::json()},
          {"worst_statics_difference", lengthOf(check.worst_statics, units)},
          {"statics_not_covered", check.statics_not_covered},
          {"worst_speed_share", check.worst_speed_share},
          {"worst_acceleration_share", check.worst_acceleration_share},
          {"deflection_travel_sampled", check.deflection_travel_sampled},
          {"least_margin_proved", lengthOf(check.least_margin, units)},
          {"tightest", check.tightest},
          {"warnings", warnings},
          {"units", unitsJson(units)}};
}

constexpr TextLine kPlanCheckWords[] = {
    {"warnings", "warning: {}\n"},
    {"", "{tubes} tube(|s), {path_rows} path row(|s): "},
    {"findings", "REFUTED", {}, {}, 1},
    {"!findings", "proved"},
    {"",
     " {base/words}\nlargest centring error {worst_centring:.1e units/length}, largest deviation from a hole's axis "
     "during an approach {worst_approach_deviation:.4r units/length}\n"},
    {"statics_not_covered", "statics not checked independently: {}\n"},
    {"worst_statics_difference",
     "independent statics on finely segmented members: the tip within {:.4r units/length} of that\n"},
    {"least_play_in_tube", "the tool's play in a tube at least {:.4r units/length}\n"},
    {"", "speed at most {worst_speed_share:.6f} of its limit, acceleration {worst_acceleration_share:.6f}"},
    {"+least_margin_proved", "; margin beyond the clearance at least {:.4r units/length}"},
    {"-least_margin_proved", "; the clearance is missed by {:.4a units/length}"},
    {"", "\n"},
    {"deflection_travel_sampled",
     "between rows, the travel due to deflection is sampled over postures, not proved: {}\n"},
    {"findings", "  {}\n"}};

/// Returns a sentence on the difference between the plan's base and the cell's base, which may have been calibrated
/// after planning; empty if both agree.
std::string baseDifference(const Cell& cell, const Cell& planned) {
  constexpr double kSamePlace = 1e-6, kSameTurn = 1e-6;  // tolerances of position [m] and rotation [rad]
  if (!cell.base_known) return "";
  const double place = (cell.X_WB.translation() - planned.X_WB.translation()).norm();
  const double turn =
      Eigen::AngleAxisd(Eigen::Matrix3d(cell.X_WB.linear().transpose() * planned.X_WB.linear())).angle();
  if (place <= kSamePlace && std::abs(turn) <= kSameTurn) return "";
  return fmt::format(
      "the plan is verified at its own base, which is {} and {:.3g} {} from that of {}: to work with that base, plan "
      "again (--from)",
      lengthText(place, cell.units), angleOf(std::abs(turn), cell.units), cell.units.angle().name, cell.path);
}

/// Returns a sentence that names the plan's tubes whose state on the map excludes them, for example because the map is
/// newer than the plan; empty if there are none.
std::string statesText(const tubesheets::Sheet& sheet, const planner::StatedPlan& plan) {
  constexpr std::size_t kNamed = 10;
  std::vector<std::string> named;
  std::size_t count = 0;
  for (const auto& stated : plan.tubes) {
    const auto* tube = sheet.find(stated.row, stated.column);
    if (!tube || !tubesheets::isExcludedUnlessNamed(tube->state)) continue;
    if (++count <= kNamed)
      named.push_back(fmt::format("{} ({})", tubesheets::tubeName(tube->row, tube->column),
                                  tubesheets::tubeStateWords(tube->state)));
  }
  if (count == 0) return "";
  return fmt::format("according to the map, {} of the {} planned tubes would be left out unless named: {}{}", count,
                     plan.tubes.size(), fmt::join(named, ", "), count > kNamed ? ", ..." : "");
}

int run(const VerifyOptions& options) {
  const Cell cell = readCell(options.cell);
  const Cell planned = readCell((std::filesystem::path(options.folder) / "cell.yaml").string());
  const PlanFiles files = readPlanFiles(options.folder, planned);
  checkFigures(options.figures);
  planner::Workcell work = checkedWorkcell(cell, planned, files);
  if (files.padding_sigmas > 0 && work.base_covariance.isZero(0))
    throw InputError::problem(options.folder + "/plan.json padding",
                              "the plan has a padding for the uncertainty of the base, but the cell.yaml next to "
                              "plan.json has no covariance of the base",
                              "plan again");
  if (files.padding_sigmas > 0) work.row_deviations = rowDeviations(work, jointUncertaintyOf(planned, work, nullptr));
  planner::PlanCheckOptions checks;
  checks.padding = files.padding_sigmas;
  checks.via_points = files.compensation == "via-point";
  // Without compensation, the deflected tip is expected to miss the holes. Centring and tilt are then not limited, and
  // only the values stated in the files are compared with the model.
  if (files.compensation == "none") {
    checks.centring_tolerance = 1;
    checks.limits_tilt = false;
  }
  planner::PlanCheck check = planner::checkPlan(work, files.plan, checks, terminalHooks());
  if (stopCondition()()) {
    remark("stopped; the plan is neither verified nor refuted\n");
    return kStoppedExitCode;
  }
  for (const auto& difference : armDifferences(cell.filedArm(), planned.filedArm()))
    check.findings.push_back(difference);
  const auto strangers = findIdentityProblems(files, work.sheet);
  check.findings.insert(check.findings.begin(), strangers.begin(), strangers.end());
  if (!check.findings.empty()) check.status = planner::PlanCheckStatus::kRefuted;
  std::vector<std::string> warnings = cell.warnings;
  if (auto nominal = warningOf(standingOf(planned)); !nominal.empty()) warnings.push_back(std::move(nominal));
  if (auto moved = baseDifference(cell, planned); !moved.empty()) warnings.push_back(std::move(moved));
  if (auto states = statesText(work.sheet, files.plan); !states.empty()) warnings.push_back(std::move(states));
  const nlohmann::json figures = checkJson(check, planned, cell.units, warnings);
  showFigures(options.figures, figures, textOf(figures, kPlanCheckWords));
  return check.findings.empty() ? kDone : kNegativeAnswer;
}

}  // namespace

Run configureVerify(CLI::App& cli) {
  const auto options = std::make_shared<VerifyOptions>();
  cli.add_option("CELL", options->cell, "the cell file: sheet, tool and scene to verify against")->required();
  cli.add_option("DIR", options->folder, "the folder of the plan")->required();
  addFigures(cli, options->figures);
  return [options] { return run(*options); };
}

}  // namespace tubeplan::app
