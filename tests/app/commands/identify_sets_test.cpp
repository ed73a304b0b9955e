// `tubeplan identify` on sets of measurements that are not part of the repository: fits to simulated sets pass the
// chi-square test, and models of measured robots predict held-out poses.
#include <fmt/format.h>

#include <map>
#include <nlohmann/json.hpp>

#include "app/formats/cell/cell_reader.hpp"
#include "app/formats/measurements/measurements_reader.hpp"
#include "app/formats/measurements/measurements_writer.hpp"
#include "tests/app/program.hpp"

namespace tubeplan::app {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

using calibration::Measurement;

/// Appends a measurement of the known distance for each pair of touches of two sockets 50 mm apart, separately for
/// fitted and held-out touches.
std::vector<Measurement> withSpacings(std::vector<Measurement> measurements) {
  std::map<std::pair<std::string, bool>, std::vector<Measurement>> touches;
  for (const auto& measurement : measurements)
    touches[{measurement.point, measurement.is_held_out}].push_back(measurement);
  for (const auto& [socket, first] : touches) {
    if (!socket.first.ends_with("-0")) continue;
    const std::string other = socket.first.substr(0, socket.first.size() - 1) + "1";
    const auto& second = touches[{other, socket.second}];
    for (std::size_t k = 0; k < std::min(first.size(), second.size()); ++k) {
      Measurement spacing = first[k];
      spacing.id += "-spacing";
      spacing.point.clear();
      spacing.kind = calibration::MeasurementKind::kRelative;
      spacing.kind_values[0] = 0.05;
      spacing.reference = std::make_shared<Measurement>(second[k]);
      measurements.push_back(std::move(spacing));
    }
  }
  return measurements;
}

/// Returns the mean absolute difference between 50 mm and the distance of two sockets as located by the touches [mm].
double socketsOff(const json& measurements) {
  std::map<std::string, std::pair<Eigen::Vector3d, int>> sockets;
  for (const auto& measurement : measurements) {
    if (measurement["kind"] != "touch") continue;
    auto& [sum, count] = sockets.try_emplace(measurement["point"], Eigen::Vector3d::Zero(), 0).first->second;
    for (int k = 0; k < 3; ++k) sum[k] += measurement["position_before"][static_cast<std::size_t>(k)].get<double>();
    ++count;
  }
  double off = 0;
  int pairs = 0;
  for (const auto& [name, first] : sockets) {
    if (!name.ends_with("-0")) continue;
    const auto& second = sockets.at(name.substr(0, name.size() - 1) + "1");
    off += std::abs((first.first / first.second - second.first / second.second).norm() - 50);
    ++pairs;
  }
  return off / pairs;
}

class IdentifySets : public ProgramTest {
 protected:
  static fs::path shared(const std::string& name) { return fs::path(TUBEPLAN_SOURCE_DIR) / "../shared" / name; }
  static std::string real(const std::string& name) { return "'" + shared("real/" + name).string() + "'"; }

  [[nodiscard]] json identified(const std::string& arguments) const {
    const Outcome outcome = run("identify " + arguments + " --folds 0 --json -");
    EXPECT_EQ(outcome.exit_code, 0) << arguments << "\n" << outcome.err;
    return json::parse(outcome.out, nullptr, false);
  }

  /// Returns the mean error of the held-out measurements, in the cell's length unit, and expects that the fit reduces
  /// it.
  [[nodiscard]] double heldOutMean(const std::string& arguments) const {
    const json result = identified(arguments);
    EXPECT_LT(result["errors"]["heldout_after"]["mean"], result["errors"]["heldout_before"]["mean"]);
    EXPECT_GT(result["errors"]["heldout_after"]["readings"], 0);
    return result["errors"]["heldout_after"]["mean"];
  }
};

#define SKIP_WITHOUT(folder) \
  if (!fs::exists(shared(folder))) GTEST_SKIP() << "skipped: no sets at ../shared/" folder

// The fit to simulated measurements without a hidden effect passes the chi-square test: with a correct model, the
// p-value lies outside 0.001 to 0.999 only once in 500 fits.
TEST_F(IdentifySets, PracticeSetsWithoutAHiddenEffectFitWithinChance) {
  SKIP_WITHOUT("hidden-effects");
  for (const auto& [set, cell] :
       {std::pair{"bench-none", "bench.yaml"}, {"bowl-none", "bowl.yaml"}, {"touch-none", "bench.yaml"}}) {
    const std::string measurements =
        "'" + shared(std::string("hidden-effects/") + set + "/measurements.csv").string() + "'";
    const json result = identified(shipped(cell) + " " + measurements);
    EXPECT_GT(result["p_value"], 0.001) << set;
    EXPECT_LT(result["p_value"], 0.999) << set;
    EXPECT_LT(result["rms"]["after"], 1.1 * result["rms"]["noise_floor"].get<double>()) << set;
    EXPECT_LT(result["rms"]["after"], 0.5 * result["rms"]["after_base"].get<double>()) << set;
    EXPECT_TRUE(result["outliers"].empty()) << set << result["outliers"];
    EXPECT_TRUE(result["warnings"].empty()) << set << result["warnings"];
  }
}

TEST_F(IdentifySets, GeometryAlone) {
  SKIP_WITHOUT("real");
  EXPECT_LE(heldOutMean(real("ur5/cell.yaml") + " " + real("ur5/measurements.csv")), 0.105);
  EXPECT_LE(heldOutMean(real("wam/cell.yaml") + " " + real("wam/measurements.csv")), 2.3);
}

TEST_F(IdentifySets, TouchesOfUnknownPoints) {
  SKIP_WITHOUT("real");
  EXPECT_LE(heldOutMean(real("panda-touch/cell.yaml") + " " + real("panda-touch/measurements.csv")), 0.83);
}

TEST_F(IdentifySets, BasesThatStartMetresAway) {
  SKIP_WITHOUT("real");
  EXPECT_LE(heldOutMean(real("motoman/cell.yaml") + " " + real("motoman/measurements.csv")), 0.15);
  EXPECT_LE(heldOutMean(real("motoman/cell-left.yaml") + " " + real("motoman/measurements-left.csv")), 0.15);
}

TEST_F(IdentifySets, ComplianceUnderItsOwnWeight) {
  SKIP_WITHOUT("real");
  const std::string set = real("kuka-iiwa7/cell.yaml") + " " + real("kuka-iiwa7/measurements-allaxes.csv");
  EXPECT_LE(heldOutMean(set), 0.61);
  std::string names = " --free tool.tip,geometry";
  for (int link = 1; link <= 7; ++link) names += fmt::format(",link{}.joint_stiffness.z", link);
  EXPECT_LE(heldOutMean(set + names), 0.32);
}

// Parameters that measurements cannot distinguish are reported as such: only axes 1 and 2 move, so the compliances of
// joints 2, 4 and 6 have the same effect.
TEST_F(IdentifySets, WhatASetCannotTellApartIsSaid) {
  SKIP_WITHOUT("real");
  for (const char* run : {"0kg", "1.25kg", "2.5kg"}) {
    const json result = identified(
        real("kuka-iiwa7/cell-payload.yaml") + " " + real(fmt::format("kuka-iiwa7/measurements-payload-{}.csv", run)) +
        " --free tool.tip,link2.joint_stiffness.z,link4.joint_stiffness.z,link6.joint_stiffness.z");
    for (const auto& number : result["parameters"]) {
      const std::string name = number["name"], identifiable = number["identifiable"];
      if (name.find("joint_stiffness") == std::string::npos) continue;
      EXPECT_NE(identifiable, "yes") << run << " " << number;
      if (name == "link2.joint_stiffness.z") {
        EXPECT_TRUE(identifiable.starts_with("with link4")) << run << " " << number;
      }
    }
  }
}

// A stiffness fitted to the measurements of two payloads predicts those of the third almost as well as a stiffness
// fitted to them. Base and tip are fitted in each case.
TEST_F(IdentifySets, TwoPayloadsForetellTheThird) {
  SKIP_WITHOUT("real");
  std::string both = contentOf(shared("real/kuka-iiwa7/measurements-payload-0kg.csv"));
  const std::string second = contentOf(shared("real/kuka-iiwa7/measurements-payload-1.25kg.csv"));
  both += second.substr(second.find('\n') + 1);
  (void)write("both.csv", both);
  const std::string cell = real("kuka-iiwa7/cell-payload.yaml"),
                    third = real("kuka-iiwa7/measurements-payload-2.5kg.csv");
  (void)identified(cell + " both.csv --free tool.tip,link2.joint_stiffness.z --out found.yaml");
  const double rigid = heldOutMean(cell + " " + third + " --free tool.tip");
  const double predictions = heldOutMean("found.yaml " + third + " --free tool.tip");
  const double own = heldOutMean(cell + " " + third + " --free tool.tip,link2.joint_stiffness.z");
  EXPECT_LT(predictions, 0.5);
  EXPECT_LT(predictions, 1.1 * own);
  EXPECT_LT(predictions, 0.4 * rigid);
}

// Known distances between sockets determine the scale of the arm. A fit to touches alone makes the arm too small, and
// the distance of two sockets is wrong by 27 mm.
TEST_F(IdentifySets, SocketsAKnownDistanceApartTellTheScale) {
  SKIP_WITHOUT("real/panda-touch");
  for (const char* name : {"arm.yaml", "cell.yaml"}) write(name, contentOf(shared("real/panda-touch") / name));
  const Cell cell = readCell((folder / "cell.yaml").string());
  const auto measurements = readMeasurements(shared("real/panda-touch/measurements.csv").string(), cell.arm, nullptr);
  write("spacings.csv", measurementsCsv(withSpacings(measurements), cell.arm, cell.units));
  const Outcome outcome =
      run("identify cell.yaml spacings.csv --free tool.tip,geometry --folds 0 --out fitted.yaml --json -");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const Outcome compared = run("compare fitted.yaml spacings.csv --assume as-is --json -");
  EXPECT_LE(socketsOff(json::parse(compared.out)["readings"]), 0.2);
}

}  // namespace
}  // namespace tubeplan::app
