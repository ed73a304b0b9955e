// Fuzz targets (libFuzzer) of all readers of external files: each must accept the input or refuse it with an error.
#include <nlohmann/json.hpp>
#include <string>

#include "app/formats/arm/arm_reader.hpp"
#include "app/formats/cell/campaign_reader.hpp"
#include "app/formats/cell/cell_reader.hpp"
#include "app/formats/cell/workcell.hpp"
#include "app/formats/checkpoint/checkpoint_file.hpp"
#include "app/formats/checkpoint/plan_cache_json.hpp"
#include "app/formats/checkpoint/tally_checkpoint.hpp"
#include "app/formats/foreign/foreign_measurements.hpp"
#include "app/formats/measurements/measurements_reader.hpp"
#include "app/formats/mesh/mesh_reader.hpp"
#include "app/formats/plan/plan_reader.hpp"
#include "app/formats/urdf/urdf_edit.hpp"
#include "app/formats/urdf/urdf_reader.hpp"
#include "app/formats/yaml/strict_yaml.hpp"
#include "app/formats/yaml/yaml_edit.hpp"
#include "deflection/effects/formula.hpp"
#include "planner/verification/plan_checks.hpp"
#include "tests/fuzz/fuzzed_folder.hpp"
#include "tests/fuzz/fuzzed_reader.hpp"
#include "tubesheets/hole_map_csv.hpp"
#include "tubesheets/work_list.hpp"

namespace {

using namespace tubeplan;
using namespace tubeplan::app;

const Cell& bench() {
  static const Cell kCell = readCell(shippedCell("bench.yaml"));
  return kCell;
}

const Cell& mockup() {
  static const Cell kCell = readCell(shippedCell("mockup.yaml"));
  return kCell;
}

void readArmText(const std::string& text) { (void)readArm(parseYaml(text, "arm")); }
void readCellText(const std::string& text) { (void)readCell(fileOf(text, "cell.yaml")); }
void readMeasurementText(const std::string& text) {
  (void)parseMeasurements(text, "readings", mockup().arm, &*mockup().sheet);
}
void readForeignText(const std::string& text) {
  const ForeignRequest request{{parseForeignTable(text, "table")},
                               {{},
                                {{UnitKind::kLength, findUnit(UnitKind::kLength, "mm")},
                                 {UnitKind::kAngle, findUnit(UnitKind::kAngle, "deg")},
                                 {UnitKind::kForce, findUnit(UnitKind::kForce, "N")}}},
                               ""};
  (void)parseMeasurementTable(readForeign(request, bench().arm).text, "readings", bench().arm);
}
/// Reads a URDF and writes the arm back into it with a changed first joint offset and tool position.
void readUrdfText(const std::string& text) {
  deflection::Arm arm = parseUrdf(text, "robot").arm;
  arm.rows.front().joint.offset += 0.1;
  arm.p_LT.x() += 0.1;
  (void)withArmInUrdf(text, "robot", "", arm);
}
void readHoleMapText(const std::string& text) { (void)tubesheets::parseHoleMap(text); }
void readWorkListText(const std::string& text) {
  (void)tubesheets::selectTubes(*mockup().sheet, tubesheets::parseWorkListCsv(text));
}
/// Reads a selection on a corner of the sheet. All holes are treated the same way, so the whole sheet would test no
/// more and take a hundred times as long.
void readSelectionText(const std::string& text) {
  static const tubesheets::Sheet kCorner = [] {
    tubesheets::Sheet sheet = *mockup().sheet;
    std::erase_if(sheet.tubes, [](const auto& tube) { return tube.row > 15 || tube.column > 15; });
    return sheet;
  }();
  (void)tubesheets::selectTubes(kCorner, text);
}
void readFormulaText(const std::string& text) { (void)deflection::makeFormula(bench().arm, text, {}); }
void readCampaignText(const std::string& text) {
  (void)readCampaignFile(fileOf(text, "campaign.yaml"), bench().arm, bench().units, false);
}
void readObjText(const std::string& text) { (void)readMeshFile(fileOf(text, "mesh.obj")); }
void readPlyText(const std::string& text) { (void)readMeshFile(fileOf(text, "mesh.ply")); }
void readStlText(const std::string& text) { (void)readMeshFile(fileOf(text, "mesh.stl")); }
void readCacheText(const std::string& text) { (void)cacheFrom(nlohmann::json::parse(text)); }
/// Writes the input as a plan: plan.json, followed by path.csv from the first "time_s," on.
void writePlanText(const std::string& text) {
  const auto path = std::min(text.find("time_s,"), text.size());
  fileOf(text.substr(0, path), "plan.json");
  fileOf(text.substr(path), "path.csv");
}
void readPlanText(const std::string& text) {
  writePlanText(text);
  (void)readPlanFiles(fuzzedFolder(), mockup());
}
void verifyPlanText(const std::string& text) {
  writePlanText(text);
  planner::Workcell work = workcellOf(mockup(), "verify a plan on it");
  const PlanFiles files = readPlanFiles(fuzzedFolder(), mockup());
  work.load = files.load;
  work.insertion = files.insertion;
  planner::PlanCheckOptions options;
  options.padding = files.padding_sigmas;
  (void)planner::checkPlan(work, files.plan, options);
}

/// Reads the input as a complete tally file if it begins like one, else as content below a valid first line.
void readTallyText(const std::string& text) {
  static const PlanKey kQuestion{{"seed", "1"}};
  fileOf(text.starts_with("{\"format") ? text : checkpointText(kTallyFormat, kQuestion, text), kTallyFile);
  (void)TallyCheckpoint(fuzzedFolder(), true).begin(kQuestion, 1000);
}

void editText(const std::string& text) {
  (void)parseYaml(text, "text");
  (void)parseYaml(withYamlValue(text, "base.position", "[1, 2, 3]"), "edited");
}

}  // namespace

const std::vector<FuzzedReader>& tubeplan::app::fuzzedReaders() {
  static const std::vector<FuzzedReader> kReaders = {
      {"arm", readArmText},
      {"cell", readCellText, false},
      {"measurements", readMeasurementText},
      {"foreign", readForeignText},
      {"urdf", readUrdfText},
      {"hole-map", readHoleMapText},
      {"work-list", readWorkListText},
      {"selection", readSelectionText},
      {"formula", readFormulaText},
      {"campaign", readCampaignText, false},
      {"obj", readObjText, false},
      {"ply", readPlyText, false},
      {"stl", readStlText, false},
      {"cache", readCacheText},
      {"plan", readPlanText},
      {"verify", verifyPlanText},
      {"tally", readTallyText},
      {"yaml-edit", editText},
  };
  return kReaders;
}
