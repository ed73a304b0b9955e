// `tubeplan arm`: imports arms from URDF or a controller's calibration, exports them to URDF or to rows of another
// convention, and shows an arm file for checking.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/cli/caller.hpp"
#include "app/cli/command.hpp"
#include "app/cli/planning_hooks.hpp"
#include "app/commands/action_options.hpp"
#include "app/commands/option_checks.hpp"
#include "app/commands/option_groups.hpp"
#include "app/documents/arm_drawing.hpp"
#include "app/documents/arm_figures.hpp"
#include "app/formats/arm/arm_reader.hpp"
#include "app/formats/arm/arm_writer.hpp"
#include "app/formats/arm/controller_calibration.hpp"
#include "app/formats/arm/robot_kinematics.hpp"
#include "app/formats/cell/cell_reader.hpp"
#include "app/formats/urdf/urdf_edit.hpp"
#include "app/formats/urdf/urdf_import.hpp"
#include "app/formats/urdf/urdf_reader.hpp"
#include "app/formats/urdf/urdf_writer.hpp"
#include "app/formats/yaml/strict_yaml.hpp"
#include "app/formats/yaml/yaml_text.hpp"
#include "app/jobs/export_fit.hpp"
#include "app/storage/atomic_file.hpp"
#include "app/storage/input_error.hpp"
#include "app/storage/text_file.hpp"
#include "app/storage/utf8.hpp"
#include "deflection/effects/constant_effects.hpp"
#include "deflection/row_conventions.hpp"

namespace tubeplan::app {

namespace {

struct ArmOptions {
  std::string action, file, tip, nominal, convention, out, into, cell, svg;
  FiguresTarget figures;
  MeasurementFiles measurement_files;
  MeasurementOptions given;
  bool is_kinematics = false;
};

/// An arm read from an arm file, a cell file or a URDF file, with the units of the file.
struct ShownArm {
  deflection::Arm arm;
  Units units;
  ToolAxis tool_axis = ToolAxis::kStated;
};

ShownArm readAnyArm(const std::string& path, const std::string& tip) {
  if (path.ends_with(".urdf") || path.ends_with(".xml"))
    return {parseUrdf(readTextFile(path), path, tip).arm, urdfUnits()};
  const YamlFile file = readYamlFile(path);
  if (file.root.find("arm")) {
    const Cell cell = readCell(path);
    return {cell.arm, cell.units};
  }
  ArmSource source = readArm(file.root);
  return {std::move(source.arm), source.units, source.names_tool_axis ? ToolAxis::kStated : ToolAxis::kLeftOut};
}

void remarkEach(const char* kind, const std::vector<std::string>& sentences) {
  constexpr std::size_t kLongest = 500;  // maximum length of a printed sentence [bytes]; names from a file may be long
  for (const auto& what : sentences) remark("{}: {}\n", kind, printable(what, kLongest));
}

/// Text of the nominal arm file with calibrated values inserted, and remarks on these values.
struct CalibratedText {
  std::string arm;
  std::vector<std::string> remarks;
};

CalibratedText controllersArm(const ArmOptions& options) {
  const auto calibration = parseControllerCalibration(readTextFile(options.file), options.file);
  return {withControllerCalibration(readYamlFile(options.nominal), calibration), calibration.remarks};
}

CalibratedText robotsArm(const ArmOptions& options) {
  const YamlFile file = readYamlFile(options.file);
  const RobotKinematics kinematics = readRobotKinematics(file.root);
  std::vector<std::string> remarks;
  if (kinematics.hash.empty())
    remarks.emplace_back("no hash: the file does not state to which controller these numbers belong");
  return {withRobotKinematics(readYamlFile(options.nominal), kinematics), remarks};
}

bool isYaml(const std::string& file) { return file.ends_with(".yaml") || file.ends_with(".yml"); }

int importCalibration(const ArmOptions& options) {
  if (options.nominal.empty())
    throw InputError::problem(
        "--nominal", "the option is missing",
        isYaml(options.file)
            ? "give the arm file whose joint origins " + options.file +
                  " replaces; `arm import robot.urdf` makes such a file"
            : "give the arm file with the model's standard Denavit-Hartenberg table, to which " + options.file +
                  " adds its corrections; write that arm file with `convention: standard` and the "
                  "maker's limits and speeds");
  for (const auto& [name, value] : {std::pair("--cell", options.cell), std::pair("--tip", options.tip)})
    if (!value.empty())
      throw InputError::problem(name, "this option is for URDF files, not for the calibration of a controller",
                                "leave it out");
  const CalibratedText text = options.file.ends_with(".conf") ? controllersArm(options) : robotsArm(options);
  const ArmSource calibrated = readArm(parseYaml(text.arm, options.out));
  writeFileAtomically(options.out, text.arm, "--out");
  remarkEach("remark", text.remarks);
  output("{}", armText(calibrated.arm, calibrated.units));
  return kDone;
}

int importRobot(const ArmOptions& options) {
  const ImportedUrdf imported = importUrdf(readTextFile(options.file), options.file, options.tip);
  const UrdfArm& read = imported.read;
  const auto folder = std::filesystem::absolute(options.cell.empty() ? "." : options.cell).parent_path();
  const auto arm_path = std::filesystem::relative(std::filesystem::absolute(options.out), folder);
  std::vector<TextFile> files = {{options.out, imported.arm}};
  if (!options.cell.empty()) files.push_back({options.cell, cellOfUrdf(read, arm_path.string())});
  writeFilesTogether(files, "--out");
  remarkEach("left out", read.left_out);
  remarkEach("remark", read.remarks);
  output("{}  the tool is the link {}\n", armText(read.arm, urdfUnits()), nameInLine(read.tip));
  return kDone;
}

std::string inLengths(double metres, const Units& units) {
  return fmt::format("{:.3g} {}", lengthOf(metres, units), units.length().name);
}

/// Prints the parts of the cell's model that the file does not contain, and the errors with and without them.
void remarkOnFit(const ExportFit& fit, const Units& units) {
  remarkEach("left out", fit.left_out);
  output(
      "rms error of the cell's model: {} ({} measurements); of the exported model: {}; of the exported model fitted "
      "again: {} ({} at held-out measurements)\n",
      inLengths(fit.of_model.rms, units), fit.measurements, inLengths(fit.as_fitted.rms, units),
      inLengths(fit.refitted.rms, units), inLengths(fit.heldout.rms, units));
}

/// Returns the arm to export, with effects that are the same at every posture as numbers. With --measurements, the
/// numbers are fitted again where the file cannot state all of the model.
ShownArm armToExport(const ArmOptions& options, ArmFileContent content) {
  if (options.measurement_files.empty()) {
    ShownArm given = readAnyArm(options.file, options.tip);
    auto [arm, written] = deflection::writeConstantEffects(given.arm);
    if (!written.empty())
      output("effects written as parameters of joints, links and tool: {}\n", fmt::join(written, ", "));
    if (!arm.effects.empty())
      remarkEach("remark",
                 {"the numbers were fitted together with effects that are left out here, so the file alone may "
                  "have a larger error: give --measurements to fit the numbers again"});
    given.arm = std::move(arm);
    return given;
  }
  const CellMeasurements input = readCellMeasurements(options.file, options.measurement_files, options.given);
  if (statesAll(input.cell.arm, content))
    return {deflection::writeConstantEffects(input.cell.arm).arm, input.cell.units};
  ExportFit fit = fitForExport(input, content, terminalWorkHooks());
  remarkOnFit(fit, input.cell.units);
  return {std::move(fit.arm), input.cell.units};
}

int exportRows(const ArmOptions& options) {
  const ShownArm given = armToExport(options, ArmFileContent::kCompliant);
  const auto names = deflection::rowConventionNames();
  const auto convention =
      static_cast<deflection::RowConvention>(std::ranges::find(names, options.convention) - names.begin());
  const auto converted = deflection::convertRows(given.arm, convention);
  if (!converted.is_converted)
    throw InputError::problem(options.file,
                              fmt::format("the frame of row {} cannot be placed as `--convention {}` requires: {}",
                                          inQuotes(converted.row), options.convention, converted.reason),
                              "use --convention origin, which leaves frames where they are");
  std::vector<std::string> left_out;
  if (!given.arm.effects.empty()) left_out.emplace_back("the cell's effects: rows of an arm file cannot express them");
  writeFileAtomically(options.out, armYaml(converted.arm, given.units, given.tool_axis), "--out");
  remarkEach("left out", left_out);
  return kDone;
}

/// Exports an arm to a copy of the URDF file from which the arm was imported. Prints the changes, and the properties
/// that URDF cannot express.
int exportIntoUrdf(const ArmOptions& options) {
  const deflection::Arm arm = armToExport(options, ArmFileContent::kRigid).arm;
  const UrdfEdit edit = withArmInUrdf(readTextBytes(options.into), options.into, options.tip, arm);
  writeFileAtomically(options.out, edit.text, "--out");
  remarkEach("left out", edit.left_out);
  for (const auto& what : edit.changed) output("changed: {}\n", what);
  if (edit.changed.empty()) output("nothing changed: the copy is equal to {}\n", nameInLine(options.into));
  return kDone;
}

int exportUrdf(const ArmOptions& options) {
  const UrdfText urdf = urdfOf(armToExport(options, ArmFileContent::kRigid).arm);
  writeFileAtomically(options.out, urdf.text, "--out");
  remarkEach("left out", urdf.left_out);
  return kDone;
}

/// Exports the kinematics YAML file that ROS reads for a Universal Robots arm.
int exportKinematics(const ArmOptions& options) {
  const deflection::Arm arm = armToExport(options, ArmFileContent::kRigid).arm;
  writeFileAtomically(options.out, robotKinematicsText(robotKinematicsOf(arm, options.file)), "--out");
  remarkEach("left out", {"the tool, weights and compliances: the file contains only joint origins"});
  return kDone;
}

int show(const ArmOptions& options) {
  const ShownArm shown = readAnyArm(options.file, options.tip);
  checkFigures(options.figures);
  if (!options.svg.empty()) writeFileAtomically(options.svg, armDrawing(shown.arm, shown.units), "--svg");
  showFigures(options.figures, armJson(shown.arm, shown.units), armText(shown.arm, shown.units));
  return kDone;
}

int exportArm(const ArmOptions& options) {
  if (!options.into.empty() && !options.convention.empty())
    throw InputError::problem("--into", "this option cannot be combined with --convention",
                              "use --into for a URDF file, or --convention for an arm file");
  if (options.is_kinematics && !(options.into.empty() && options.convention.empty()))
    throw InputError::problem("--kinematics", "this option cannot be combined with --into or --convention",
                              "use --kinematics only to write the kinematics YAML file for ROS");
  if (options.is_kinematics) return exportKinematics(options);
  if (!options.into.empty()) return exportIntoUrdf(options);
  return options.convention.empty() ? exportUrdf(options) : exportRows(options);
}

/// Options that not all actions have.
const std::vector<ActionOptions>& armActions() {
  static const std::vector<ActionOptions> kActions{
      {"import",
       "makes an arm file from URDF, a controller's calibration.conf or ROS's kinematics of a UR",
       {"--out", "--cell", "--nominal"}},
      {"export",
       "writes an arm as URDF, by --convention or by --kinematics",
       {"--out", "--into", "--convention", "--kinematics", "--measurements", "--sigma", "--prior", "--assume"}},
      {"show", "shows an arm for checking", {"--svg", "--json", "--format"}},
  };
  return kActions;
}

int run(const ArmOptions& options, const CLI::App& cli) {
  requireOptionsOf(cli, options.action, armActions());
  if (options.action == "show") return show(options);
  if (options.out.empty())
    throw InputError::problem("--out", "the option is missing",
                              fmt::format("name the file that `arm {}` writes", options.action));
  if (options.action == "export") return exportArm(options);
  const bool is_calibration = !options.nominal.empty() || options.file.ends_with(".conf") || isYaml(options.file);
  return is_calibration ? importCalibration(options) : importRobot(options);
}

}  // namespace

Run configureArm(CLI::App& cli) {
  const auto options = std::make_shared<ArmOptions>();
  addAction(cli, options->action, armActions());
  cli.add_option(
         "FILE", options->file,
         "a URDF file, an arm file, a cell, a controller's calibration.conf or a kinematics YAML of ur_calibration")
      ->required();
  cli.add_option("--out", options->out, "import: the arm file to write; export: the URDF file or arm file to write");
  const auto names = deflection::rowConventionNames();
  cli.add_option(
         "--convention", options->convention,
         "export: an arm file with rows by Craig's numbers, the standard ones or origins, instead of a URDF file")
      ->check(oneOf(std::vector<std::string>(names.begin(), names.end())));
  cli.add_option("--nominal", options->nominal,
                 "import of calibration.conf: the arm file with the model's standard table, to which it adds; of a "
                 "kinematics YAML: the arm imported from the robot's URDF, whose origins it replaces");
  cli.add_option("--into", options->into,
                 "export: the URDF file that the arm was imported from; only joint origins change");
  cli.add_flag("--kinematics", options->is_kinematics,
               "export: the kinematics YAML that ROS reads for a Universal Robots arm, in the format of import");
  cli.add_option("--measurements", options->measurement_files,
                 "export of a cell: measurements to which the numbers are fitted again, without the effects that the "
                 "file cannot state");
  addMeasurementOptions(cli, options->given);
  cli.add_option("--tip", options->tip, "of a URDF: the link at the tool's tip, if the robot has several end links");
  cli.add_option("--cell", options->cell, "import: also write a cell with the arm and its solids");
  cli.add_option("--svg", options->svg, "show: draw the arm from the side and from above");
  addFigures(cli, options->figures);
  return [options, &cli] { return run(*options, cli); };
}

}  // namespace tubeplan::app
