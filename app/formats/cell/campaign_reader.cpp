#include "app/formats/cell/campaign_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include "app/formats/quantities.hpp"
#include "app/formats/yaml/strict_yaml.hpp"
#include "app/storage/named_entry.hpp"
#include "app/storage/suggestion.hpp"
#include "calibration/measurements/measurement_kinds.hpp"

namespace tubeplan::app {

namespace {

using calibration::CampaignDesign, calibration::CampaignPlace, calibration::MeasurementKind;

struct PlaceRow {
  const char* name;
  CampaignPlace place;
};
constexpr std::array<PlaceRow, 3> kPlaces{
    {{"anywhere", CampaignPlace::kAnywhere}, {"plane", CampaignPlace::kPlane}, {"holes", CampaignPlace::kHoles}}};

[[noreturn]] void refuseWord(const YamlNode& node, const std::vector<std::string>& words) {
  throw unknownName(node.where(), node.text(), words);
}

MeasurementKind readKind(const YamlNode& node) {
  if (const auto* row = calibration::findMeasurementKind(node.text())) return row->kind;
  refuseWord(node, calibration::measurementKindNames());
}

CampaignPlace readPlace(const YamlNode& node) { return entryNamed(kPlaces, node.text(), node.where()).place; }

bool readPointsKnown(const YamlNode& node) {
  if (node.text() != "known" && node.text() != "unknown") refuseWord(node, {"known", "unknown"});
  return node.text() == "known";
}

std::vector<double> readLoads(const YamlNode& node, const Units& units) {
  std::vector<double> loads;
  for (const YamlNode& item : node.list()) {
    loads.push_back(readQuantity(item, units, dimension::kForce));
    if (loads.back() < 0) item.fail("a weight of zero or more");
  }
  if (loads.empty()) node.fail("one or more loads", "write loads: [0] for none");
  return loads;
}

Eigen::AlignedBox3d readRegion(const YamlNode& node, const Units& units) {
  node.expectKeys({"from", "to"}, {});
  const Eigen::Vector3d from = readVector(node.at("from"), units, dimension::kLength);
  const Eigen::Vector3d to = readVector(node.at("to"), units, dimension::kLength);
  if ((from.array() >= to.array()).any())
    node.at("to").failWithProblem("the corner `to` is not above `from` in all three coordinates",
                                  "correct the corners");
  return {from, to};
}

int rowOfArmNamed(const YamlNode& node, const deflection::Arm& arm) {
  if (const auto row = deflection::findRow(arm, node.text())) return *row;
  refuseWord(node, deflection::rowNames(arm));
}

std::vector<int> readRowList(const YamlNode& node, const deflection::Arm& arm) {
  std::vector<int> rows;
  for (const YamlNode& item : node.list()) {
    rows.push_back(rowOfArmNamed(item, arm));
    if (std::count(rows.begin(), rows.end(), rows.back()) > 1)
      item.failWithProblem("the row " + item.text() + " is listed twice", "list each row only once");
  }
  if (rows.empty()) node.fail("one or more rows of the arm", "leave out the key for readings of the tool");
  return rows;
}

// Throws InputError if a key has no meaning for the kind of measurements of the design, or if a needed key is missing.
void checkBelongs(const YamlNode& root, const CampaignDesign& design) {
  const calibration::MeasurementKindRow& kind = kindOf(design.kind);
  for (const char* key : {"points", "postures_per_point"})
    if (const YamlNode* node = root.find(key);
        node && !kind.is_touch && !(kind.settle && std::string_view(key) == "postures_per_point"))
      node->failWithProblem(fmt::format("`{}` is for readings of kind touch, not {}", key, kind.name), "remove it");
  const auto check = [&](const char* key, bool calibration::MeasurementKindRow::*has, const std::string& what) {
    std::string kinds;
    for (const auto& row : calibration::measurementKinds())
      if (row.*has) kinds += (kinds.empty() ? "" : " or ") + std::string(row.name);
    const YamlNode* node = root.find(key);
    if (node && !(kind.*has))
      node->failWithProblem(fmt::format("{} is for readings of kind {}, not {}", what, kinds, kind.name), "remove it");
    if (!node && kind.*has && !kind.is_from_origin)
      root.at("kind").failWithProblem(fmt::format("readings of kind {} need {}", kind.name, what),
                                      fmt::format("add {}: [x, y, z]", key));
  };
  if (const YamlNode* rows = root.find("rows"); rows && !kind.may_be_of_row)
    rows->failWithProblem(fmt::format("`rows` is for readings of kind {}, not {}",
                                      alternatives(calibration::kindNamesOfRows()), kind.name),
                          "remove it");
  check("anchor", &calibration::MeasurementKindRow::has_anchor, "an anchor");
  check("direction", &calibration::MeasurementKindRow::has_direction, "a direction");
  if (const YamlNode* node = root.find("turn_sigma"); node && kind.turn_rows == 0)
    node->failWithProblem(fmt::format("`turn_sigma` is for readings of angles, but kind {} measures none", kind.name),
                          "remove it");
}

constexpr int kPosturesOfSurface = 12;

// Returns a design with the kind, points and place that the file states, and the defaults for this kind.
CampaignDesign designOfKind(const YamlNode& root, bool has_sheet) {
  CampaignDesign design;
  design.kind = readKind(root.at("kind"));
  const bool is_touch = kindOf(design.kind).is_touch;
  if (const YamlNode* points = root.find("points")) design.points_known = readPointsKnown(*points);
  if (is_touch && design.points_known) design.place = has_sheet ? CampaignPlace::kHoles : CampaignPlace::kPlane;
  if (!is_touch && kindOf(design.kind).names_hole) design.place = CampaignPlace::kHoles;
  if (const YamlNode* place = root.find("at")) design.place = readPlace(*place);
  design.loads = calibration::usualLoads();
  if (!kindOf(design.kind).is_centring && design.place == CampaignPlace::kHoles) design.loads = {0};
  if (kindOf(design.kind).departure && !kindOf(design.kind).is_from_measurement)
    design.loads.erase(design.loads.begin());
  if (kindOf(design.kind).settle) design.postures_per_point = kPosturesOfSurface;
  design.sigma = kindOf(design.kind).usual_sigma;
  if (kindOf(design.kind).turn_rows > 0) design.turn_sigma = calibration::kAngleSigma;
  return design;
}

void readNoiseOfAxes(const YamlNode& node, const Units& units, CampaignDesign& design) {
  design.sigma_W = readVector(node, units, dimension::kLength);
  if (!(design.sigma_W->minCoeff() > 0))
    node.failWithProblem("a sigma of x, y or z is not above zero", "write three lengths above zero");
  if (!kindOf(design.kind).has_coordinates)
    node.failWithProblem(
        fmt::format("`sigmas` is for readings of x, y, z, but kind {} measures none", kindOf(design.kind).name),
        "write one `sigma` instead");
  design.sigma = calibration::meanSigma(*design.sigma_W);
}

void readCorrelationList(const YamlNode& node, CampaignDesign& design) {
  if (!design.sigma_W) node.failWithProblem("`correlations` need the `sigmas` of x, y and z", "add sigmas: [x, y, z]");
  if (node.list().size() != 3) node.fail("three correlations: of x and y, of x and z, of y and z");
  Eigen::Vector3d numbers;
  for (std::size_t k = 0; k < 3; ++k) numbers[static_cast<Eigen::Index>(k)] = node.list()[k].number();
  if (!calibration::isPossibleCorrelation(numbers))
    node.failWithProblem("the correlations do not form a positive definite matrix",
                         "check their order and signs, and that each is between -1 and 1");
  design.correlation_W = numbers;
}

void readShare(const YamlNode& node, double& share) {
  share = node.number();
  if (share < 0 || share >= 1) node.fail("a fraction from 0 to below 1");
}

void readNumbers(const YamlNode& root, const Units& units, CampaignFile& file) {
  CampaignDesign& design = file.design;
  if (const YamlNode* node = root.find("postures")) file.postures = node->integer(1, calibration::kMostMeasurements);
  if (const YamlNode* node = root.find("postures_per_point")) design.postures_per_point = node->integer(1, 100);
  if (const YamlNode* node = root.find("setups")) design.setups = node->integer(1, 1000);
  if (const YamlNode* node = root.find("loads")) design.loads = readLoads(*node, units);
  if (const YamlNode* node = root.find("anchor")) design.anchor_W = readVector(*node, units, dimension::kLength);
  if (const YamlNode* node = root.find("direction")) design.direction_W = readDirection(*node);
  if (const YamlNode* node = root.find("region")) design.region_W = readRegion(*node, units);
  if (const YamlNode* node = root.find("split")) readShare(*node, design.held_out);
  design.push = readQuantityOr(root, "push", units, dimension::kForce, design.push);
  if (design.push < 0) root.at("push").fail("a number of zero or more");
  design.sigma = readQuantityOr(root, "sigma", units, dimension::kLength, design.sigma);
  if (design.sigma < 0) root.at("sigma").fail("a number of zero or more");
  if (const YamlNode* node = root.find("sigmas")) readNoiseOfAxes(*node, units, design);
  if (const YamlNode* node = root.find("correlations")) readCorrelationList(*node, design);
  design.turn_sigma = readQuantityOr(root, "turn_sigma", units, dimension::kAngle, design.turn_sigma);
  if (design.turn_sigma < 0) root.at("turn_sigma").fail("a number of zero or more");
}

}  // namespace

CampaignFile readCampaignFile(const std::string& path, const deflection::Arm& arm, const Units& units, bool has_sheet) {
  const YamlFile source = readYamlFile(path);
  source.root.expectKeys({"kind"},
                         {"name", "at", "points", "postures", "postures_per_point", "loads", "push", "rows", "anchor",
                          "direction", "region", "setups", "split", "sigma", "sigmas", "correlations", "turn_sigma"});
  CampaignFile file{designOfKind(source.root, has_sheet), std::nullopt};
  file.design.name = std::filesystem::path(path).stem().string();
  if (const YamlNode* name = source.root.find("name")) file.design.name = name->text();
  readNumbers(source.root, units, file);
  if (const YamlNode* rows = source.root.find("rows")) file.design.rows = readRowList(*rows, arm);
  checkBelongs(source.root, file.design);
  return file;
}

}  // namespace tubeplan::app
