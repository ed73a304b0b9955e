// Every reader of files that come from elsewhere, for libFuzzer: what it is given is read or refused, and nothing else.
// TUBEPLAN_READER names the reader. See tests/fuzz/run.sh.
#include <unistd.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "app/files/arm_reader.hpp"
#include "app/files/campaign_reader.hpp"
#include "app/files/cell_reader.hpp"
#include "app/files/checkpoint/plan_cache_json.hpp"
#include "app/files/foreign/foreign_readings.hpp"
#include "app/files/input_error.hpp"
#include "app/files/measurements_reader.hpp"
#include "app/files/mesh_reader.hpp"
#include "app/files/text_file.hpp"
#include "app/files/urdf_reader.hpp"
#include "app/files/yaml/strict_yaml.hpp"
#include "app/files/yaml/yaml_edit.hpp"
#include "app/workbench/project.hpp"
#include "deflection/effects/formula.hpp"
#include "tubesheets/hole_map_csv.hpp"
#include "tubesheets/work_list.hpp"

namespace {

using namespace tubeplan;
using namespace tubeplan::app;

const std::string kCells = TUBEPLAN_SOURCE_DIR "/app/cells/";

const Cell& bench() {
  static const Cell kCell = readCell(kCells + "bench.yaml");
  return kCell;
}

const Cell& mockup() {
  static const Cell kCell = readCell(kCells + "mockup.yaml");
  return kCell;
}

/// In memory, with the shipped files in it: what a text refers to is there.
std::string makeFolder() {
  const std::string folder = "/dev/shm/tubeplan-fuzz-" + std::to_string(::getppid());
  std::filesystem::create_directories(folder);
  std::filesystem::copy(kCells, folder,
                        std::filesystem::copy_options::recursive | std::filesystem::copy_options::overwrite_existing);
  return folder;
}

/// A file of that name with the text in it; for readers of files alone.
std::string fileOf(const std::string& text, const std::string& name) {
  static const std::string kFolder = makeFolder();
  const std::string path = kFolder + "/" + name;
  std::ofstream(path, std::ios::binary) << text;
  return path;
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
void readUrdfText(const std::string& text) { (void)parseUrdf(text, "robot"); }
void readHoleMapText(const std::string& text) { (void)tubesheets::parseHoleMap(text); }
void readWorkListText(const std::string& text) {
  (void)tubesheets::selectTubes(*mockup().sheet, tubesheets::parseWorkListCsv(text));
}
void readSelectionText(const std::string& text) { (void)tubesheets::selectTubes(*mockup().sheet, text); }
void readFormulaText(const std::string& text) { (void)deflection::makeFormula(bench().arm, text, {}); }
void readCampaignText(const std::string& text) {
  (void)readCampaignFile(fileOf(text, "campaign.yaml"), bench().arm, bench().units, false);
}
void readMeshText(const std::string& text) { (void)readMeshFile(fileOf(text, "mesh.obj")); }
void readStlText(const std::string& text) { (void)readMeshFile(fileOf(text, "mesh.stl")); }
void readProjectText(const std::string& text) { (void)readProject(fileOf(text, "mine.tubeplan")); }
void readCacheText(const std::string& text) { (void)cacheFrom(nlohmann::json::parse(text)); }
void editText(const std::string& text) {
  (void)parseYaml(text, "text");
  (void)parseYaml(withYamlValue(text, "base.position", "[1, 2, 3]"), "edited");
}

struct Reader {
  const char* name;
  void (*read)(const std::string& text);
  bool is_text = true;  ///< checked as readTextFile() does before it is read
};

constexpr Reader kReaders[] = {
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
    {"mesh", readMeshText, false},
    {"stl", readStlText, false},
    {"project", readProjectText, false},
    {"cache", readCacheText},
    {"yaml-edit", editText},
};

const Reader& chosenReader() {
  const char* name = std::getenv("TUBEPLAN_READER");
  for (const Reader& reader : kReaders)
    if (name && std::string(name) == reader.name) return reader;
  std::fprintf(stderr, "TUBEPLAN_READER must be one of:");
  for (const Reader& reader : kReaders) std::fprintf(stderr, " %s", reader.name);
  std::fprintf(stderr, "\n");
  std::exit(2);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const Reader& reader = chosenReader();
  const std::string text(reinterpret_cast<const char*>(data), size);
  try {
    if (reader.is_text) checkText("input", text);
    reader.read(text);
  } catch (const InputError&) {
  } catch (const nlohmann::json::exception&) {
  }
  return 0;
}
