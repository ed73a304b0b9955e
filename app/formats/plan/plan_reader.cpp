#include "app/formats/plan/plan_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>

#include "app/formats/arm/joint_units.hpp"
#include "app/formats/plan/path_numbers.hpp"
#include "app/formats/units_json.hpp"
#include "app/storage/input_error.hpp"
#include "app/storage/json_value.hpp"
#include "app/storage/text_file.hpp"
#include "planner/reach/compensation.hpp"
#include "tubesheets/csv_table.hpp"

namespace tubeplan::app {

namespace {

using nlohmann::json;
using planner::SegmentKind;
using tubesheets::CsvRow;

constexpr int kMost = std::numeric_limits<int>::max();
constexpr const char* kPlanAgain = "plan again";

Eigen::VectorXd jointsOf(const JsonValue& measurements, const Cell& cell) {
  return measurements.numbers(cell.arm.jointCount()).cwiseProduct(jointFactors(cell.arm, cell.units));
}

planner::StatedTube tubeOf(const JsonValue& tube, const Cell& cell) {
  const double length = cell.units.factor(dimension::kLength);
  return {tube.at("row").integer(1, kMost),
          tube.at("column").integer(1, kMost),
          tube.at("hole").numbers(3) * length,
          jointsOf(tube.at("joints"), cell),
          tube.at("predicted_tip").numbers(3) * length,
          tube.has("dwell_s") ? tube.at("dwell_s").number(0) : 0,
          tube.has("zone") ? tube.at("zone").integer(0, kMost) : 0,
          tube.has("centring_error") ? std::optional(tube.at("centring_error").number(0) * length) : std::nullopt,
          tube.has("tilt") ? std::optional(cell.units.toInternal(tube.at("tilt").number(0), dimension::kAngle))
                           : std::nullopt};
}

void readTubesOf(const JsonValue& document, const Cell& cell, PlanFiles& files) {
  const JsonValue tubes = document.at("tubes");
  for (const auto& tube : tubes.items()) {
    if (tube.has("leg")) files.tube_legs.push_back(tube.at("leg").text());
    files.plan.tubes.push_back(tubeOf(tube, cell));
  }
  if (!files.tube_legs.empty() && files.tube_legs.size() != files.plan.tubes.size())
    tubes.refuse("a leg for every tube, or for none");
  for (const auto& tube : document.at("unreachable").items())
    files.plan.unreachable.push_back({tube.at("row").integer(1, kMost), tube.at("column").integer(1, kMost)});
}

void readConditionsOf(const JsonValue& document, const Cell& cell, PlanFiles& files) {
  if (document.has("start")) files.plan.start = jointsOf(document.at("start"), cell);
  if (document.has("start_at"))
    files.start_at = TubeEcho{files.leg, document.at("start_at").at("row").integer(1, kMost),
                              document.at("start_at").at("column").integer(1, kMost)};
  if (document.has("end")) files.plan.end = jointsOf(document.at("end"), cell);
  if (document.has("padding")) files.padding_sigmas = document.at("padding").at("sigmas").number(0);
  files.compensation = document.at("compensation").text();
  if (!planner::findCompensation(files.compensation))
    document.at("compensation").refuse("none, goal-point or via-point");
  files.load = cell.units.toInternal(document.at("load").number(0), dimension::kForce);
  if (document.has("insertion"))
    files.insertion = cell.units.toInternal(document.at("insertion").number(0), dimension::kLength);
}

void readFiguresOf(const JsonValue& document, const Cell& cell, PlanFiles& files) {
  const auto numberOf = [&](const char* key, double factor) {
    return document.has(key) && !document.at(key).json().is_null() ? std::optional(document.at(key).number() * factor)
                                                                   : std::nullopt;
  };
  files.plan.travel_time = numberOf("travel_time_s", 1);
  files.plan.total_time = numberOf("total_time_s", 1);
  files.plan.least_clearance = numberOf("min_clearance", cell.units.factor(dimension::kLength));
}

/// Reader of the rows of path.csv.
class PathReader {
 public:
  PathReader(const std::string& path, const Cell& cell)
      : path_(path), factors_(jointFactors(cell.arm, cell.units)), table_(tubesheets::parseCsv(readTextFile(path))) {
    if (table_.problem) {
      table_.problem->advice = kPlanAgain;
      refuseText(path, *table_.problem);
    }
    std::vector<std::string> columns{"time_s", "segment", "kind"};
    for (const auto& joint : cell.arm.joints()) columns.push_back(jointColumn(joint, cell.units));
    if (table_.columns == columns) return;
    columns.insert(columns.end(), {"leg", "row", "column"});
    has_echo_ = table_.columns == columns;
    if (!has_echo_)
      throw InputError(fmt::format("{}:{}", path, table_.header_line),
                       inQuotes(fmt::format("{}", fmt::join(table_.columns, ","))),
                       fmt::format("{}", fmt::join(columns, ",")), kPlanAgain);
  }

  void read(PlanFiles& files) const {
    PathNumbers numbers;
    for (const auto& row : table_.rows) {
      planner::PathRow read{number(row, 0), integer(row, 1) - 1, kindOf(row), Eigen::VectorXd(factors_.size())};
      for (Eigen::Index k = 0; k < factors_.size(); ++k) read.q[k] = number(row, 3 + static_cast<std::size_t>(k));
      numbers.add(read.time, read.segment + 1, read.q);
      read.q.array() *= factors_.array();
      files.plan.path.push_back(std::move(read));
      const std::size_t echo = 3 + static_cast<std::size_t>(factors_.size());
      if (has_echo_) files.path_echoes.push_back({row.fields[echo], integer(row, echo + 1), integer(row, echo + 2)});
    }
    files.path_fingerprint = numbers.fingerprint();
  }

 private:
  [[noreturn]] void refuse(const CsvRow& row, std::size_t column, const std::string& expected) const {
    throw InputError(fmt::format("{}:{} ({})", path_, row.line, table_.columns[column]), inQuotes(row.fields[column]),
                     expected, kPlanAgain);
  }

  [[nodiscard]] double number(const CsvRow& row, std::size_t column) const {
    const auto number = tubesheets::parseNumber(row.fields[column]);
    if (!number) refuse(row, column, "a finite number");
    return *number;
  }

  [[nodiscard]] int integer(const CsvRow& row, std::size_t column) const {
    const auto number = tubesheets::parseInteger(row.fields[column]);
    if (!number || *number < 1) refuse(row, column, "a whole number, at least 1");
    return *number;
  }

  [[nodiscard]] SegmentKind kindOf(const CsvRow& row) const {
    for (const SegmentKind kind : {SegmentKind::kTravel, SegmentKind::kApproach, SegmentKind::kRetreat})
      if (planner::nameOf(kind) == row.fields[2]) return kind;
    refuse(row, 2, "travel, approach or retreat");
  }

  const std::string& path_;
  Eigen::VectorXd factors_;
  tubesheets::CsvTable table_;
  bool has_echo_ = false;
};

}  // namespace

PlanFiles readPlanFiles(const std::filesystem::path& folder, const Cell& cell) {
  const std::string path = (folder / "plan.json").string();
  const json text = parseJson(readTextFile(path), path, "JSON written by tubeplan plan", kPlanAgain);
  const JsonValue document(text, path, kPlanAgain);
  if (document.at("units").json() != unitsJson(cell.units))
    throw InputError(path + " units", text["units"].dump(), unitsJson(cell.units).dump(),
                     "verify the plan with the cell for which it was made");
  PlanFiles files;
  const JsonValue sheet = document.at("sheet");
  files.fingerprint = sheet.at("fingerprint").text();
  files.leg = sheet.at("leg").text();
  files.viewed_from = sheet.at("viewed_from").text();
  readTubesOf(document, cell, files);
  readConditionsOf(document, cell, files);
  readFiguresOf(document, cell, files);
  if (document.has("path_fingerprint")) files.stated_path = document.at("path_fingerprint").text();
  const std::string path_csv = (folder / "path.csv").string();
  PathReader(path_csv, cell).read(files);
  return files;
}

}  // namespace tubeplan::app
