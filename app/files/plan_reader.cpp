#include "app/files/plan_reader.hpp"

#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/files/input_error.hpp"
#include "app/files/joint_units.hpp"
#include "app/files/path_numbers.hpp"
#include "app/files/text_file.hpp"
#include "app/files/units_json.hpp"

namespace tubeplan::app {

namespace {

using nlohmann::json;
using planner::SegmentKind;

json parseJson(const std::string& path) {
  try {
    return json::parse(readTextFile(path));
  } catch (const json::exception& error) {
    throw InputError(path, error.what(), "JSON written by tubeplan plan", "plan again");
  }
}

const json& at(const json& object, const char* key, const std::string& where) {
  if (!object.is_object() || !object.contains(key))
    throw InputError(where, std::string("no key ") + key, "it", "plan again");
  return object[key];
}

template <class T>
T valueAt(const json& object, const char* key, const std::string& where) {
  try {
    return at(object, key, where).get<T>();
  } catch (const json::exception&) {
    throw InputError(where + " " + key, inQuotes(object[key].dump()), "another type of value", "plan again");
  }
}

Eigen::VectorXd vectorAt(const json& object, const char* key, const std::string& where, double factor) {
  const auto values = valueAt<std::vector<double>>(object, key, where);
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size())) * factor;
}

Eigen::Vector3d pointAt(const json& object, const char* key, const std::string& where, double factor) {
  const Eigen::VectorXd v = vectorAt(object, key, where, factor);
  if (v.size() != 3) throw InputError(where + " " + key, std::to_string(v.size()) + " numbers", "3", "plan again");
  return v;
}

Eigen::VectorXd jointsAt(const json& object, const char* key, const std::string& where,
                         const Eigen::VectorXd& factors) {
  const Eigen::VectorXd joints = vectorAt(object, key, where, 1);
  if (joints.size() != factors.size())
    throw InputError(where + " " + key, std::to_string(joints.size()) + " numbers", std::to_string(factors.size()),
                     "plan again");
  return joints.cwiseProduct(factors);
}

void readTubesOf(const json& document, const std::string& path, const Cell& cell, PlanFiles& files) {
  const Units& units = cell.units;
  const Eigen::VectorXd joint_factors = jointFactors(cell.arm, units);
  const double length = units.factor(dimension::kLength);
  for (const auto& tube : at(document, "tubes", path)) {
    if (tube.is_object() && tube.contains("leg")) files.tube_legs.push_back(valueAt<std::string>(tube, "leg", path));
    files.plan.tubes.push_back({valueAt<int>(tube, "row", path), valueAt<int>(tube, "column", path),
                                pointAt(tube, "hole", path, length), jointsAt(tube, "joints", path, joint_factors),
                                pointAt(tube, "predicted_tip", path, length),
                                tube.contains("dwell_s") ? valueAt<double>(tube, "dwell_s", path) : 0,
                                tube.contains("zone") ? valueAt<int>(tube, "zone", path) : 0});
  }
  if (!files.tube_legs.empty() && files.tube_legs.size() != files.plan.tubes.size())
    throw InputError(path + " tubes", "tubes with and without a leg", "the leg of every tube", "plan again");
  for (const auto& tube : at(document, "unreachable", path))
    files.plan.unreachable.emplace_back(valueAt<int>(tube, "row", path), valueAt<int>(tube, "column", path));
}

SegmentKind segmentKindOf(const std::string& name, const std::string& where) {
  for (SegmentKind kind : {SegmentKind::kTravel, SegmentKind::kApproach, SegmentKind::kRetreat})
    if (planner::nameOf(kind) == name) return kind;
  throw InputError(where, inQuotes(name), "travel, approach or retreat");
}

double cellNumber(const std::string& text, const std::string& where) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
    throw InputError(where, inQuotes(text), "a finite number");
  return value;
}

std::vector<std::string> cellsOf(const std::string& line) {
  std::vector<std::string> cells;
  std::stringstream stream(line);
  for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
  return cells;
}

void readPath(const std::string& path, const Cell& cell, PlanFiles& files) {
  std::stringstream text(readTextFile(path));
  const std::string echo = ",leg,row,column";
  std::string header = "time_s,segment,kind", line;
  for (const auto& joint : cell.arm.joints()) header += "," + jointColumn(joint, cell.units);
  std::getline(text, line);
  const bool has_echo = line == header + echo;
  if (line != header && !has_echo) throw InputError(path + ":1", inQuotes(line), header + echo, "plan again");
  const std::size_t columns = 3 + static_cast<std::size_t>(cell.arm.jointCount()) + (has_echo ? 3 : 0);
  const Eigen::VectorXd factors = jointFactors(cell.arm, cell.units);
  PathNumbers numbers;
  for (int number = 2; std::getline(text, line); ++number) {
    const std::string where = path + ":" + std::to_string(number);
    const auto cells = cellsOf(line);
    if (cells.size() != columns)
      throw InputError(where, std::to_string(cells.size()) + " columns", std::to_string(columns));
    planner::PathRow row{cellNumber(cells[0], where),
                         static_cast<int>(cellNumber(cells[1], where)) - 1,
                         segmentKindOf(cells[2], where),
                         {}};
    row.q.resize(cell.arm.jointCount());
    for (Eigen::Index k = 0; k < cell.arm.jointCount(); ++k)
      row.q[k] = cellNumber(cells[3 + static_cast<std::size_t>(k)], where);
    numbers.add(row.time, row.segment + 1, row.q);
    row.q.array() *= factors.array();
    files.plan.path.push_back(std::move(row));
    if (has_echo)
      files.path_echoes.push_back({cells[columns - 3], static_cast<int>(cellNumber(cells[columns - 2], where)),
                                   static_cast<int>(cellNumber(cells[columns - 1], where))});
  }
  files.path_fingerprint = numbers.fingerprint();
}

}  // namespace

PlanFiles readPlanFiles(const std::filesystem::path& folder, const Cell& cell) {
  const std::string path = (folder / "plan.json").string();
  const json document = parseJson(path);
  if (at(document, "units", path) != unitsJson(cell.units))
    throw InputError(path + " units", document["units"].dump(), unitsJson(cell.units).dump(),
                     "verify it with the cell it was planned for");
  PlanFiles files;
  readTubesOf(document, path, cell, files);
  const Eigen::VectorXd factors = jointFactors(cell.arm, cell.units);
  if (document.contains("start")) files.plan.start = jointsAt(document, "start", path, factors);
  if (document.contains("end")) files.plan.end = jointsAt(document, "end", path, factors);
  if (document.contains("padding")) files.padding_sigmas = valueAt<double>(document["padding"], "sigmas", path);
  files.compensation = valueAt<std::string>(document, "compensation", path);
  const json& sheet = at(document, "sheet", path);
  files.fingerprint = valueAt<std::string>(sheet, "fingerprint", path);
  files.leg = valueAt<std::string>(sheet, "leg", path);
  files.viewed_from = valueAt<std::string>(sheet, "viewed_from", path);
  files.load = valueAt<double>(document, "load", path) * cell.units.factor(dimension::kForce);
  if (document.contains("insertion"))
    files.insertion = valueAt<double>(document, "insertion", path) * cell.units.factor(dimension::kLength);
  readPath((folder / "path.csv").string(), cell, files);
  if (document.contains("path_fingerprint"))
    files.stated_path = valueAt<std::string>(document, "path_fingerprint", path);
  return files;
}

}  // namespace tubeplan::app
