#include "app/formats/checkpoint/plan_key.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <vector>

#include "app/formats/plan/plan_conditions.hpp"
#include "app/version.hpp"
#include "planner/reach/compensation.hpp"
#include "tubesheets/fingerprint.hpp"

namespace tubeplan::app {

namespace {

// Keys of a cell that modelFingerprint() omits, because proved motions and postures do not depend on them or because
// planKeyOf() has separate parts for them. Such parts are the sheet, the base, the tilt that the tool allows and, if
// the tool enters tubes, the tool's play at the insertion depth.
constexpr std::array<std::string_view, 10> kOtherKeys{
    "name", "base",        "identify", "tubesheet",   "calibration_tool",
    "park", "model_error", "pair",     "uncertainty", "touched"};
constexpr std::array<std::string_view, 10> kModelParts{"program",   "arm and scene", "base",      "load",
                                                       "clearance", "compensation",  "insertion", "tilt allowed",
                                                       "travel",    "sheet"};

/// Appends the values of a node, without their line numbers and comments; mesh files are represented by the fingerprint
/// of their content.
void append(const YamlNode& node, const std::vector<SceneMesh>& meshes, std::string& text) {
  const auto mesh = std::find_if(meshes.begin(), meshes.end(), [&](const SceneMesh& m) { return m.key == node.path; });
  const std::string& scalar = mesh == meshes.end() ? node.scalar : mesh->fingerprint;
  if (node.kind == YamlNode::Kind::kScalar) text += fmt::format("{}:{}", scalar.size(), scalar);
  if (node.kind == YamlNode::Kind::kNull) text += '~';
  if (node.items.empty()) return;
  text += node.keys.empty() ? '[' : '{';
  for (std::size_t k = 0; k < node.items.size(); ++k) {
    if (!node.keys.empty()) text += node.keys[k] + "=";
    append(node.items[k], meshes, text);
    text += ',';
  }
  text += ']';
}

std::string modelText(const Cell& cell) {
  std::string text;
  const YamlNode& root = cell.source.root;
  for (std::size_t k = 0; k < root.items.size(); ++k) {
    if (std::find(kOtherKeys.begin(), kOtherKeys.end(), root.keys[k]) != kOtherKeys.end()) continue;
    // An arm file is represented by its content, so that a copy in another folder is the same arm.
    text += root.keys[k] + "=";
    const bool is_arm_file = root.keys[k] == "arm" && !cell.arm_source.text.empty();
    append(is_arm_file ? cell.arm_source.root : root.items[k], cell.meshes, text);
    text += '\n';
  }
  return text;
}

std::vector<std::string> differencesIn(const PlanKey& before, const PlanKey& now, const auto& counts) {
  std::vector<std::string> differences;
  for (const auto& [name, value] : now)
    if (const std::string was = partOf(before, name); counts(name) && was != value)
      differences.push_back(fmt::format("{}{} ({}, now {})", name.starts_with("other ") ? "" : "another ", name,
                                        was.empty() ? "none" : was, value.empty() ? "none" : value));
  return differences;
}

std::string clearanceText(const PlanKeyInputs& inputs) {
  const std::string clearance = fmt::format("{} m", inputs.model.scene.clearance);
  return inputs.padding == 0 ? clearance
                             : fmt::format("{} and {} sigmas of {} and {}", clearance, inputs.padding,
                                           numbersFingerprint(inputs.model.base_covariance),
                                           numbersFingerprint(Eigen::Map<const Eigen::VectorXd>(
                                               inputs.model.row_deviations.data(),
                                               static_cast<Eigen::Index>(inputs.model.row_deviations.size()))));
}

/// Returns a fingerprint of the program's executable, eight bytes at a time: a fingerprint byte by byte of so large a
/// file takes as long as the plan of a few tubes.
std::string executableFingerprint() {
  constexpr std::uint64_t kPrime = 0x100000001b3;
  std::ifstream stream("/proc/self/exe", std::ios::binary);
  std::vector<std::uint64_t> words(1 << 15);
  std::uint64_t hash = 0xcbf29ce484222325;
  while (stream) {
    std::ranges::fill(words, 0);
    stream.read(reinterpret_cast<char*>(words.data()), static_cast<std::streamsize>(words.size() * sizeof(words[0])));
    const auto read = static_cast<std::size_t>(stream.gcount());
    for (std::size_t k = 0; k * sizeof(words[0]) < read; ++k) {
      hash = (hash ^ words[k]) * kPrime;
      hash ^= hash >> 29;  // the product carries bits only upwards
    }
    hash = (hash ^ read) * kPrime;
  }
  return fmt::format("{:016x}", hash);
}

}  // namespace

std::string fingerprintOf(std::string_view bytes) {
  tubesheets::Fingerprint fingerprint;
  fingerprint.addBytes(bytes);
  return fingerprint.text();
}

std::string programText() {
  static const std::string kText = std::string(kVersion) + " " + executableFingerprint();
  return kText;
}

std::string modelFingerprint(const Cell& cell) { return fingerprintOf(modelText(cell)); }

std::string numbersFingerprint(const Eigen::Ref<const Eigen::MatrixXd>& numbers) {
  std::string text;
  for (const double number : numbers.reshaped()) text += fmt::format("{:a} ", number);
  return fingerprintOf(text);
}

/// Returns the insertion depth, and those dimensions of the tool that determine the tool's play at this depth; "none"
/// if the tool does not enter tubes.
std::string insertionText(const planner::Workcell& model) {
  if (!(model.insertion > 0)) return "none";
  std::string text = fmt::format("{} m by steps of", model.insertion);
  for (const auto& step : model.tool.steps) text += fmt::format(" {}", step.tolerance);
  text += " m over";
  for (const double length : model.tool.lengths) text += fmt::format(" {}", length);
  return text + " m";
}

/// Returns the fingerprint of the base pose and of the arm's parameters, which may have been fitted to the touches that
/// determined the base.
std::string baseFingerprint(const planner::Workcell& model) {
  const auto parameters = deflection::parametersOf(model.arm);
  Eigen::VectorXd numbers(16 + static_cast<Eigen::Index>(parameters.size()));
  numbers.head<16>() = model.X_WB.matrix().reshaped();
  for (std::size_t k = 0; k < parameters.size(); ++k) numbers[16 + static_cast<Eigen::Index>(k)] = parameters[k].value;
  return numbersFingerprint(numbers);
}

PlanKey planKeyOf(const PlanKeyInputs& inputs, const std::vector<int>& tubes) {
  std::string tubes_text;
  for (const int tube : tubes) tubes_text += fmt::format("{} ", tube);
  return {{"program", programText()},
          {"arm and scene", modelFingerprint(inputs.cell)},
          {"base", baseFingerprint(inputs.model)},
          {"load", fmt::format("{} N", inputs.model.load)},
          {"clearance", clearanceText(inputs)},
          {"compensation", fmt::format("{}, standoff {}{} m", inputs.compensation,
                                       inputs.has_least_standoff ? "up to " : "", inputs.standoff)},
          {"insertion", insertionText(inputs.model)},
          {"tilt allowed", fmt::format("{} rad", tubesheets::toleratedTilt(inputs.model.tool))},
          {"travel", std::string(planner::nameOf(inputs.travel))},
          {"sheet", inputs.model.sheet.fingerprint()},
          {"seed", std::to_string(inputs.seed)},
          {"list of tubes", fmt::format("{} tubes, {}", tubes.size(), fingerprintOf(tubes_text))},
          {kEndsPart, endsText(inputs.conditions)},
          {"other conditions", conditionsText(inputs.conditions)},
          {"plan to start from", inputs.from}};
}

std::vector<std::string> findDifferences(const PlanKey& before, const PlanKey& now) {
  return differencesIn(before, now, [](const std::string&) { return true; });
}

std::vector<std::string> findModelDifferences(const PlanKey& before, const PlanKey& now) {
  return differencesIn(before, now, [](const std::string& name) {
    return std::find(kModelParts.begin(), kModelParts.end(), name) != kModelParts.end();
  });
}

std::string partOf(const PlanKey& question, std::string_view name) {
  const auto found =
      std::find_if(question.begin(), question.end(), [&](const auto& part) { return part.first == name; });
  return found == question.end() ? "" : found->second;
}

}  // namespace tubeplan::app
