#include <algorithm>

#include "calibration/measurement_checks/angles_unit.hpp"
#include "calibration/measurement_checks/axes.hpp"
#include "calibration/measurement_checks/base_elsewhere.hpp"
#include "calibration/measurement_checks/clock.hpp"
#include "calibration/measurement_checks/coordinate_scale.hpp"
#include "calibration/measurement_checks/coordinate_unit.hpp"
#include "calibration/measurement_checks/coordinates_unit.hpp"
#include "calibration/measurement_checks/holes_off.hpp"
#include "calibration/measurement_checks/inverse_turns.hpp"
#include "calibration/measurement_checks/joint_coupling.hpp"
#include "calibration/measurement_checks/joint_order.hpp"
#include "calibration/measurement_checks/joint_pair.hpp"
#include "calibration/measurement_checks/joint_scale.hpp"
#include "calibration/measurement_checks/joint_sign.hpp"
#include "calibration/measurement_checks/joint_unit.hpp"
#include "calibration/measurement_checks/joint_zero.hpp"
#include "calibration/measurement_checks/loads_unit.hpp"
#include "calibration/measurement_checks/mirror.hpp"
#include "calibration/measurement_checks/mistake.hpp"
#include "calibration/measurement_checks/one_hole.hpp"
#include "calibration/measurement_checks/part_in_unit.hpp"
#include "calibration/measurement_checks/quaternion_order.hpp"
#include "calibration/measurement_checks/setup_alone.hpp"
#include "calibration/measurement_checks/sheet_mirrored.hpp"
#include "calibration/measurement_checks/shifted_rows.hpp"
#include "calibration/measurement_checks/sigma_unit.hpp"
#include "calibration/measurement_checks/tip_elsewhere.hpp"
#include "calibration/measurement_checks/tool_frame.hpp"
#include "calibration/measurement_checks/turns_as.hpp"
#include "calibration/measurement_checks/without.hpp"
#include "calibration/measurements/measurement_kinds.hpp"
#include "tubesheets/csv_table.hpp"

namespace tubeplan::calibration {

const std::vector<MistakeKind>& mistakeKinds() {
  static const std::vector<MistakeKind> kKinds = {
      mistakes::shifted_rows::kind(),
      mistakes::coordinates_unit::kind(),
      mistakes::loads_unit::kind(),
      mistakes::angles_unit::kind(),
      mistakes::coordinate_unit::kind(),
      mistakes::coordinate_scale::kind(),
      mistakes::joint_unit::kind(),
      mistakes::sigma_unit::kind(),
      mistakes::mirror::kind(),
      mistakes::axes::kind(),
      mistakes::joint_order::kind(),
      mistakes::joint_scale::kind(),
      mistakes::joint_sign::kind(),
      mistakes::joint_coupling::kind(),
      mistakes::joint_pair::kind(),
      mistakes::joint_zero::kind(),
      mistakes::holes_off::kind(),
      mistakes::one_hole::kind(),
      mistakes::sheet_mirrored::kind(),
      mistakes::base_elsewhere::kind(),
      mistakes::tip_elsewhere::kind(),
      mistakes::setup_alone::kind(),
      mistakes::without::kind(),
      mistakes::part_in_unit::coordinates(),
      mistakes::part_in_unit::angles(),
      mistakes::turns_as::kind(),
      mistakes::quaternion_order::kind(),
      mistakes::inverse_turns::kind(),
      mistakes::tool_frame::kind(),
      mistakes::clock::kind(),
  };
  return kKinds;
}

std::vector<std::string> partedAt(char mark, const std::string& text) {
  std::vector<std::string> parts;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t to = std::min(text.find(mark, from), text.size());
    parts.push_back(text.substr(from, to - from));
    from = to + 1;
  }
  return parts;
}

std::vector<int> turningJoints(const deflection::Arm& arm) {
  std::vector<int> joints;
  for (int j = 0; j < arm.jointCount(); ++j)
    if (arm.joint(j).type == deflection::JointType::kRevolute) joints.push_back(j);
  return joints;
}

std::vector<std::string> partedAssumptions(const std::string& text) { return partedAt(',', text); }

const MistakeKind* findMistakeKind(const std::string& name) {
  for (const MistakeKind& kind : mistakeKinds())
    if (kind.name == name) return &kind;
  return nullptr;
}

Correction joined(const std::vector<Correction>& parts) {
  Correction all = parts.front();
  for (std::size_t k = 1; k < parts.size(); ++k) {
    const Correction& part = parts[k];
    all.value += "," + part.mistake + "=" + part.value;
    all.sentence += (k + 1 < parts.size() ? ", " : " and ") + part.sentence;
    all.frees_base = all.frees_base || part.frees_base;
    all.parts_setups = all.parts_setups || part.parts_setups;
    all.is_of_part = all.is_of_part || part.is_of_part;
    all.zeros_of.insert(all.zeros_of.end(), part.zeros_of.begin(), part.zeros_of.end());
    all.numbers_fitted += part.numbers_fitted;
    all.against += part.against;
    if (part.new_setup) all.new_setup = part.new_setup;
  }
  all.change = [parts](std::vector<Measurement>& measurements) {
    for (const Correction& part : parts) part.change(measurements);
  };
  all.change_sigma = {};
  if (std::ranges::any_of(parts, [](const Correction& part) { return static_cast<bool>(part.change_sigma); }))
    all.change_sigma = [parts](std::vector<Measurement>& measurements) {
      for (const Correction& part : parts)
        if (part.change_sigma) part.change_sigma(measurements);
    };
  return all;
}

bool isPlacedBySheet(const CheckedMeasurements& checked, const Measurement& measurement) {
  if (!checked.sheet || !touchesKnownPoint(measurement)) return false;
  const auto hole = tubesheets::parseTubeName(measurement.point);
  const auto* tube = hole ? checked.sheet->find(hole->row, hole->column) : nullptr;
  constexpr double kRounding = 5e-5;  // rounding of coordinates that are written in addition to the hole's name [m]
  return tube && (*measurement.p_W - Eigen::Vector3d(tube->x, tube->y, 0)).norm() < kRounding;
}

int jointNamed(const deflection::Arm& arm, const std::string& name) {
  for (Eigen::Index j = 0; j < arm.jointCount(); ++j)
    if (arm.joint(j).name == name) return static_cast<int>(j);
  return -1;
}

std::pair<std::string, std::string> partedAtColon(const std::string& value) {
  const std::size_t colon = value.rfind(':');
  if (colon == std::string::npos) return {"", ""};
  return {value.substr(0, colon), value.substr(colon + 1)};
}

std::optional<std::vector<double>> numbersAtColons(const std::string& text, std::size_t count) {
  std::vector<double> numbers;
  for (const std::string& part : partedAt(':', text)) {
    const auto number = tubesheets::parseNumber(part);
    if (!number) return std::nullopt;
    numbers.push_back(*number);
  }
  return numbers.size() == count ? std::optional(std::move(numbers)) : std::nullopt;
}

}  // namespace tubeplan::calibration
