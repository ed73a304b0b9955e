#include "app/formats/cell/cell_writer.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>
#include <system_error>
#include <vector>

#include "app/formats/arm/arm_numbers.hpp"
#include "app/formats/cell/cell_places.hpp"
#include "app/formats/cell/effects_reader.hpp"
#include "app/formats/cell/uncertainty_reader.hpp"
#include "app/formats/checkpoint/plan_key.hpp"
#include "app/formats/quantities.hpp"
#include "app/formats/sheet/touched_base.hpp"
#include "app/formats/yaml/yaml_edit.hpp"
#include "app/storage/input_error.hpp"
#include "app/storage/origin.hpp"
#include "calibration/estimation/held_out.hpp"
#include "deflection/rotation.hpp"

namespace tubeplan::app {

namespace {

namespace fs = std::filesystem;

std::string covarianceText(const Matrix6d& covariance, const Units& units) {
  const auto scale = [&](int i) { return units.factor(i < 3 ? dimension::kLength : dimension::kAngle); };
  std::vector<std::string> rows;
  for (int i = 0; i < 6; ++i) {
    std::vector<std::string> numbers;
    for (int j = 0; j < 6; ++j) numbers.push_back(formatNumber(covariance(i, j) / scale(i) / scale(j)));
    rows.push_back(fmt::format("[{}]", fmt::join(numbers, ", ")));
  }
  return fmt::format("[{}]", fmt::join(rows, ", "));
}

// Returns roll, pitch and yaw that reproduce R up to rounding, even at a pitch of 90 deg: roll is computed from the
// rotation that remains without yaw.
Eigen::Vector3d rollPitchYaw(const Eigen::Matrix3d& R) {
  const double yaw = std::atan2(R(1, 0), R(0, 0));
  const Eigen::Matrix3d R_without_yaw = deflection::rotationZ(-yaw) * R;
  return {std::atan2(-R_without_yaw(1, 2), R_without_yaw(1, 1)), std::atan2(-R_without_yaw(2, 0), R_without_yaw(0, 0)),
          yaw};
}

std::string withModelError(const std::string& text, const ModelError& error, const Units& units) {
  std::string map = "sigma: " + formatNumber(units.toFile(error.sigma, dimension::kLength));
  if (error.degrees_of_freedom > 0) map += fmt::format(", degrees_of_freedom: {}", error.degrees_of_freedom);
  if (!error.from.empty()) map += ", from: " + error.from;
  return withYamlValue(text, "model_error", "{" + map + "}");
}

/// Returns the model error found by a fit. If chi-square shows no lack of fit, it is the largest model error that this
/// number of measurements would not detect: the mean square of residuals has a relative uncertainty of sqrt(2 / degrees
/// of freedom).
std::optional<ModelError> modelErrorOf(const calibration::Identification& result) {
  if (result.degrees_of_freedom <= 0) return std::nullopt;
  const double freedom = result.degrees_of_freedom;
  const double unseen = result.noise_floor / std::sqrt(3.) * std::pow(2 / freedom, 0.25);
  const double sigma = std::max(result.model_error, unseen);
  if (!std::isfinite(sigma)) return std::nullopt;
  return ModelError{sigma, result.degrees_of_freedom, "identify"};
}

std::string withBaseText(std::string text, const Cell& cell, const BaseChange& base) {
  const Eigen::Vector3d rpy = rollPitchYaw(base.X_WB.linear());
  text = withYamlValue(text, "base.position", listText(base.X_WB.translation(), cell.units, dimension::kLength));
  text = withYamlValue(text, "base.rpy", listText(rpy, cell.units, dimension::kAngle));
  text = withYamlValue(text, "base.known", base.known ? "true" : "false");
  const bool is_of_touches = cell.model_error && cell.model_error->from == kByTouches;
  if (base.model_error)
    text = withModelError(text, *base.model_error, cell.units);
  else if (is_of_touches && parseYaml(text, "cell").find("model_error"))
    text = withoutYamlValue(text, "model_error");
  if (base.covariance) text = withYamlValue(text, "base.covariance", covarianceText(*base.covariance, cell.units));
  return base.arm ? withTouched(text, cell, base.touches, *base.arm) : withoutTouched(text);
}

// Returns the text with the file name at `key` changed to be relative to the folder of `out`, the cell's new path.
std::string moved(const std::string& text, const Cell& cell, std::string_view key, const fs::path& out) {
  const YamlNode* node = findNode(cell.source.root, key);
  if (!node || node->kind != YamlNode::Kind::kScalar || fs::path(node->scalar).is_absolute()) return text;
  const fs::path from = fs::weakly_canonical(fs::absolute(cell.path)).parent_path();
  const fs::path to = fs::weakly_canonical(fs::absolute(out)).parent_path();
  if (from == to) return text;
  const std::string name = fs::weakly_canonical(from / node->scalar).lexically_relative(to).generic_string();
  return withYamlValue(text, key, '"' + name + '"');
}

/// Returns the parameters that any stage of the fit changed, compared with the arm's file.
std::vector<std::pair<std::string, double>> foundNumbers(const Cell& cell, const calibration::Identification& result) {
  std::vector<std::pair<std::string, double>> numbers;
  for (const auto& parameter : deflection::parametersOf(result.fitted.arm)) {
    if (parameter.path.effect >= 0) continue;
    const auto before = deflection::findParameter(cell.filedArm(), parameter.name);
    if (!before || before->value != parameter.value) numbers.emplace_back(parameter.name, parameter.value);
  }
  return numbers;
}

/// Returns the stiffnesses of the cell's arm that the fit replaced by rigid joints or beams.
std::vector<std::string> givenUp(const Cell& cell, const calibration::Identification& result) {
  std::vector<std::string> names;
  for (const auto& parameter : deflection::parametersOf(cell.arm))
    if (parameter.path.effect < 0 && !deflection::findParameter(result.fitted.arm, parameter.name))
      names.push_back(parameter.name);
  return names;
}

std::string identifyList(const std::vector<std::string>& names) {
  std::vector<std::string> quoted;
  for (const auto& name : names) quoted.push_back('"' + name + '"');
  return fmt::format("[{}]", fmt::join(quoted, ", "));
}

/// Returns the text with the stiffnesses in `given_up` removed from the list `identify`.
std::string withoutIdentifying(const std::string& text, const Cell& cell, const std::vector<std::string>& given_up) {
  const auto is_given_up = [&](const std::string& name) {
    return std::find(given_up.begin(), given_up.end(), name) != given_up.end();
  };
  std::vector<std::string> remaining;
  std::remove_copy_if(cell.identify.begin(), cell.identify.end(), std::back_inserter(remaining), is_given_up);
  return remaining.size() == cell.identify.size() ? text : withYamlValue(text, "identify", identifyList(remaining));
}

std::optional<Matrix6d> baseCovariance(const calibration::Identification& result, int base_pose) {
  Matrix6d covariance = Matrix6d::Zero();
  int found = 0;
  for (std::size_t i = 0; i < result.numbers.size(); ++i)
    for (std::size_t j = 0; j < result.numbers.size(); ++j) {
      const auto &a = result.numbers[i].unknown, &b = result.numbers[j].unknown;
      const auto is_its = [&](const calibration::Unknown& unknown) {
        return unknown.owner == calibration::Unknown::Owner::kBase && unknown.base_pose == base_pose;
      };
      if (!is_its(a) || !is_its(b)) continue;
      covariance(a.component, b.component) =
          result.covariance(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
      ++found;
    }
  return found == 36 ? std::optional(covariance) : std::nullopt;
}

/// Returns a string for use in file names, unique to each set-up: the set-up's name, or its number if the name has
/// unsuitable characters.
std::string fileNamePart(const calibration::PlacedArm& placed, std::size_t base_pose) {
  const std::string& part = placed.base_poses[base_pose].setup;
  const bool is_plain = !part.empty() && std::all_of(part.begin(), part.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '-' || c == '_';
  });
  return is_plain ? part : std::to_string(base_pose + 1) + "-of-" + std::to_string(placed.base_poses.size());
}

/// Returns one cell file for each set-up with an identified base, because a cell has only one base; all these cells
/// have the same arm.
std::vector<TextFile> cellsOfSetups(const std::string& text, const Cell& cell,
                                    const calibration::Identification& result, const fs::path& out) {
  std::vector<TextFile> files;
  const auto& base_poses = result.fitted.base_poses;
  for (std::size_t k = 0; k < base_poses.size(); ++k) {
    if (base_poses[k].is_known) continue;
    fs::path path = out;
    path.replace_filename(out.stem().string() + "-setup-" + fileNamePart(result.fitted, k) + out.extension().string());
    const auto covariance = baseCovariance(result, static_cast<int>(k));
    files.push_back({path, withBaseText(text, cell, {base_poses[k].X_WB, covariance, cell.base_known})});
  }
  return files;
}

/// Returns the arm and every base pose of the fit as read back from the new files.
calibration::PlacedArm rereadBasePoses(const CellFiles& files, const calibration::PlacedArm& fitted) {
  const Cell cell = files.reread();
  calibration::PlacedArm placed{cell.arm, fitted.base_poses};
  std::size_t next = 0;
  for (auto& base_pose : placed.base_poses)
    base_pose.X_WB =
        base_pose.is_known || files.of_setups.empty() ? cell.X_WB : files.reread(files.of_setups[next++]).X_WB;
  return placed;
}

void requireReproduced(const CellFiles& files, const calibration::Identification& result,
                       const std::vector<calibration::Measurement>& measurements, const Units& units) {
  constexpr double kAlike = 0.01, kLeast = 1e-9;  // relative tolerance of the error, and minimum tolerance [m]
  std::vector<calibration::Measurement> used;
  for (const int k : result.used) used.push_back(measurements.at(static_cast<std::size_t>(k)));
  const double rms = calibration::judge(rereadBasePoses(files, result.fitted), used).rms;
  if (std::abs(rms - result.after.rms) <= kAlike * result.after.rms + kLeast) return;
  if (!std::isfinite(rms))
    throw InputError::problem(files.cell.path.string(),
                              "the fitted arm is too compliant for its deflected shape to converge at every reading",
                              "nothing was written; check the readings");
  const auto length = [&](double metres) {
    return fmt::format("{:.6g} {}", metres / units.factor(dimension::kLength), units.length().name);
  };
  throw InputError(files.cell.path.string(), "an error of " + length(rms) + " with the cell as it would be written",
                   "the reported error of " + length(result.after.rms),
                   "nothing was written; please report this fault");
}

}  // namespace

void makePair(std::string& cell, TextFile& arm) {
  // The pair identifier is a function of the arm's text, so that equal arms have equal identifiers.
  const std::string pair = '"' + fingerprintOf(withYamlValue(arm.text, "pair", "\"\"")) + '"';
  cell = withYamlValue(cell, "arm", '"' + arm.path.filename().string() + '"');
  cell = withYamlValue(cell, "pair", pair);
  arm.text = withYamlValue(arm.text, "pair", pair);
}

namespace {

/// Returns the files of the identified cell, before the check that the files reproduce the reported error.
CellFiles filesOf(const Cell& cell, const calibration::Identification& result, const fs::path& out) {
  const auto numbers = foundNumbers(cell, result);
  const auto rigid = givenUp(cell, result);
  const bool is_inline = cell.arm_source.text.empty();
  const YamlNode& arm_node = is_inline ? cell.source.root.at("arm") : cell.arm_source.root;
  ArmSource source;
  source.arm = result.fitted.arm;
  source.units = cell.units;
  std::string text = withoutTouched(withoutIdentifying(cellTextAt(cell, out), cell, rigid));
  CellFiles files;
  if (is_inline) {
    text = withoutArmParameters(withArmParameters(text, arm_node, source, numbers), arm_node, rigid);
  } else {
    const fs::path arm_path = armPathFor(out);
    const std::string found = withArmParameters(cell.arm_source.text, arm_node, source, numbers);
    files.arm = {arm_path, withoutArmParameters(found, arm_node, rigid)};
    makePair(text, *files.arm);
  }
  if (!result.fitted.arm.effects.empty())
    text = withYamlValue(text, "effects", effectsText(result.fitted.arm, cell.units));
  if (const auto error = modelErrorOf(result)) text = withModelError(text, *error, cell.units);
  if (result.uncertainty)
    text = withYamlValue(text, "uncertainty", uncertaintyText(*result.uncertainty, result.fitted.arm, cell.units));
  if (result.fitted.base_poses.size() > 1)
    files.of_setups = cellsOfSetups(text, cell, result, out);
  else if (!result.fitted.base_poses.front().is_known)
    text =
        withBaseText(text, cell, {result.fitted.base_poses.front().X_WB, baseCovariance(result, 0), cell.base_known});
  files.cell = {out, text};
  return files;
}

}  // namespace

std::vector<TextFile> CellFiles::inOrder() const {
  std::vector<TextFile> files = of_setups;
  files.push_back(cell);
  if (arm) files.push_back(*arm);
  return files;
}

Cell CellFiles::reread(const TextFile& of) const {
  return parseCell(of.text, of.path.string(), arm ? std::optional(arm->text) : std::nullopt);
}

CellFiles identifiedCell(const Cell& cell, const calibration::Identification& result,
                         const std::vector<calibration::Measurement>& measurements, const fs::path& out) {
  CellFiles files = filesOf(cell, result, out);
  requireReproduced(files, result, measurements, cell.units);
  return files;
}

std::vector<std::string> freedNames(const deflection::Arm& arm, const deflection::Effect& effect) {
  std::vector<std::string> names;
  for (const auto& parameter : deflection::numbersOf(effect))
    if (parameter.quantity != deflection::Quantity::kTime)
      names.push_back(deflection::textOf(arm, effect) + "." + parameter.name);
  return names;
}

std::string cellTextWithEffects(const Cell& cell, const deflection::Arm& arm, const std::vector<std::string>& freed,
                                const fs::path& out) {
  std::vector<std::string> identify = cell.identify;
  identify.insert(identify.end(), freed.begin(), freed.end());
  std::string text = withYamlValue(cellTextAt(cell, out), "effects", effectsText(arm, cell.units));
  if (const auto known = knownOf(cell.uncertainty, arm); known.determined.size() < cell.uncertainty.determined.size())
    text = withYamlValue(text, "uncertainty", uncertaintyText(known, arm, cell.units));
  return withYamlValue(text, "identify", identifyList(identify));
}

CellFiles improvedCell(const Cell& original, const CellModel& improved, const calibration::Identification& result,
                       const std::vector<calibration::Measurement>& measurements, const fs::path& out) {
  CellFiles files = filesOf(original, result, out);
  if (!improved.identify.empty()) {
    files.cell.text = withYamlValue(files.cell.text, "identify", identifyList(improved.identify));
    for (auto& file : files.of_setups)
      file.text = withYamlValue(file.text, "identify", identifyList(improved.identify));
  }
  requireReproduced(files, result, measurements, original.units);
  return files;
}

std::string cellTextAt(const Cell& cell, const fs::path& out) {
  std::string text = moved(moved(cell.source.text, cell, "arm", out), cell, "tubesheet.map", out);
  for (const SceneMesh& mesh : cell.meshes) text = moved(text, cell, mesh.key, out);
  return text;
}

std::vector<TextFile> cellFiles(const Cell& cell, const fs::path& out) {
  std::string text = cellTextAt(cell, out);
  if (cell.arm_source.text.empty()) return {{out, text}};
  TextFile arm{armPathFor(out), cell.arm_source.text};
  makePair(text, arm);
  return {{out, text}, arm};
}

std::string cellTextWithBase(const Cell& cell, const BaseChange& base, const fs::path& out) {
  return withBaseText(cellTextAt(cell, out), cell, base);
}

}  // namespace tubeplan::app
