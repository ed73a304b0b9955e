// `tubeplan pose`: computes the pose of the tip of the rigid and of the deflected arm.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/cli/caller.hpp"
#include "app/cli/command.hpp"
#include "app/commands/option_groups.hpp"
#include "app/documents/figures.hpp"
#include "app/documents/figures_text.hpp"
#include "app/documents/pose_json.hpp"
#include "app/formats/cell/command_inputs.hpp"
#include "app/formats/units_json.hpp"
#include "app/storage/input_error.hpp"
#include "deflection/elements/element.hpp"
#include "deflection/flexible_kinematics.hpp"
#include "deflection/side_chains.hpp"

namespace tubeplan::app {

namespace {

struct PoseOptions {
  std::string cell, joints, side_joints;
  FiguresTarget figures;
  std::vector<double> force, moment;
  double load = 0;
  bool all = false;
};

/// Returns the intermediate results that Appendix A of Calkins 1994 lists for every link: frames, loads and the
/// deflection of each component.
nlohmann::json intermediatesJson(const deflection::Arm& arm, const deflection::FlexibleKinematics& shape,
                                 const Units& units) {
  nlohmann::json rows = nlohmann::json::array(), components = nlohmann::json::array();
  const Dimension moment{1, 0, 1};
  for (std::size_t k = 0; k < shape.rows.size(); ++k) {
    const auto& row = shape.rows[k];
    rows.push_back({{"row", arm.rows[k].name},
                    {"rigid", figuresJson(poseFiguresOf(row.X_BL_rigid), units)},
                    {"flexible", figuresJson(poseFiguresOf(row.X_BL), units)},
                    {"force_base", vectorJson(row.force_B, units, dimension::kForce)},
                    {"moment_base", vectorJson(row.moment_B, units, moment)},
                    {"force_link", vectorJson(row.force_L, units, dimension::kForce)},
                    {"moment_link", vectorJson(row.moment_L, units, moment)}});
  }
  for (const auto& part : shape.components)
    components.push_back({{"row", arm.rows[static_cast<std::size_t>(part.row)].name},
                          {"element", deflection::elementKinds()[static_cast<std::size_t>(part.kind)].key},
                          {"segment", part.segment + 1},
                          {"displacement", vectorJson(part.displacement, units, dimension::kLength)},
                          {"rotation", vectorJson(part.rotation, units, dimension::kAngle)}});
  return {{"rows", rows}, {"components", components}};
}

constexpr std::string_view kTipWords = "{@:<9}{position:>36l units/length}   {fixed_angles:>32.4f units/angle}\n";
constexpr TextLine kPoseWords[] = {
    {"", "tip in the arm's base frame: position, fixed angles (gamma, beta, alpha)\n"},
    {"rigid", kTipWords, {}, "rigid"},
    {"flexible", kTipWords, {}, "flexible"},
    {"change", kTipWords, {}, "change"},
    {"", "deflection {deflection:l units/length}, converged in {iterations} iterations\n"},
    {"segments/warning", "warning: {}\n"}};

Eigen::Vector3d parseVector(const std::vector<double>& numbers, const char* option, const Cell& cell,
                            Dimension dimension) {
  if (numbers.empty()) return Eigen::Vector3d::Zero();
  const Eigen::Map<const Eigen::VectorXd> vector(numbers.data(), static_cast<Eigen::Index>(numbers.size()));
  if (numbers.size() != 3 || !vector.allFinite())
    throw InputError(option, fmt::format("{}", fmt::join(numbers, ",")),
                     fmt::format("X,Y,Z in {}, in the world's axes", cell.units.nameOf(dimension)));
  return cell.units.factor(dimension) * vector;
}

std::optional<deflection::Wrench> parseWrench(const PoseOptions& options, const Cell& cell) {
  if (options.force.empty() && options.moment.empty()) return std::nullopt;
  const Eigen::Matrix3d R_BW = cell.X_WB.linear().transpose();
  return deflection::Wrench{R_BW * parseVector(options.force, "--force", cell, dimension::kForce),
                            R_BW * parseVector(options.moment, "--moment", cell, dimension::kTorque)};
}

int run(const PoseOptions& options) {
  const Cell cell = readCell(options.cell);
  deflection::Posture posture{parseJoints(options.joints, cell.arm, cell.units, "--joints"),
                              parseLoad(options.load, cell.units, "--load"),
                              deflection::gravityInBase(cell.arm, cell.X_WB)};
  posture.wrench = parseWrench(options, cell);
  if (!options.side_joints.empty())
    posture.side_q = parseJointsOf(options.side_joints, deflection::sideJoints(cell.arm), cell.units, "--side-joints",
                                   "the arm's side chains");
  checkFigures(options.figures);
  const auto shape = deflection::solveFlexibleKinematics(cell.arm, posture);
  if (shape.status == deflection::KinematicsStatus::kUndefined)
    throw InputError::problem("--joints", shape.reason,
                              "choose a posture at which every formula of the cell has a value");
  if (shape.status != deflection::KinematicsStatus::kConverged) {
    remark("{}\n", shape.reason);
    return kNegativeAnswer;
  }
  nlohmann::json json = poseFiguresJson(shape, cell.units);
  json["load"] = cell.units.toFile(posture.load, dimension::kForce);
  json["units"] = unitsJson(cell.units);
  json["segments"] = segmentsJson(cell, posture, shape);
  if (options.all) json["intermediates"] = intermediatesJson(cell.arm, shape, cell.units);
  showFigures(options.figures, json, textOf(json, kPoseWords));
  return kDone;
}

}  // namespace

Run configurePose(CLI::App& cli) {
  const auto options = std::make_shared<PoseOptions>();
  addCell(cli, options->cell);
  cli.add_option("--joints", options->joints, "joint readings A,B,C,D in the cell's unit of angle")
      ->type_name("POSTURE")
      ->required();
  cli.add_option("--side-joints", options->side_joints, "joint readings of the arm's side chains (default: zero)");
  cli.add_option("--load", options->load, "load hung on the tip, in the cell's unit of force")->type_name("FORCE");
  cli.add_option("--force", options->force,
                 "X,Y,Z: a force on the tip in addition to the load, in the world's axes and the cell's unit of force")
      ->type_name("FORCE")
      ->delimiter(',')
      ->allow_extra_args(false);
  cli.add_option("--moment", options->moment,
                 "X,Y,Z: a moment on the tip, in the world's axes, units of force and length")
      ->type_name("TORQUE")
      ->delimiter(',')
      ->allow_extra_args(false);
  cli.add_flag("--all", options->all, "include every frame, force, moment and component's deflection in the JSON");
  addFigures(cli, options->figures);
  return [options] { return run(*options); };
}

}  // namespace tubeplan::app
