// Tests that files of real arms are read. The files are not part of the repository; without them the tests are skipped.
#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "app/formats/cell/cell_reader.hpp"
#include "app/formats/measurements/measurements_reader.hpp"
#include "app/storage/text_file.hpp"
#include "app/studies/model/cell_fit.hpp"
#include "calibration/measurement_checks/measurement_checks.hpp"
#include "tests/app/test_files.hpp"

namespace tubeplan::app {
namespace {

namespace fs = std::filesystem;

struct RealSet {
  const char *cell, *measurement_file;
  std::size_t measurements, joints;
};

constexpr RealSet kSets[] = {
    {"kuka-iiwa7/cell.yaml", "kuka-iiwa7/measurements-allaxes.csv", 304, 7},
    {"kuka-iiwa7/cell-payload.yaml", "kuka-iiwa7/measurements-payload.csv", 594, 7},
    {"motoman/cell.yaml", "motoman/measurements.csv", 212, 7},
    {"motoman/cell-left.yaml", "motoman/measurements-left.csv", 208, 7},
    {"motoman/cell-wide.yaml", "motoman/measurements-wide.csv", 587, 7},
    {"panda-touch/cell.yaml", "panda-touch/measurements.csv", 559, 7},
    {"ur5/cell.yaml", "ur5/measurements.csv", 1020, 6},
    {"wam/cell.yaml", "wam/measurements.csv", 236, 7},
};

TEST(RealData, isReadWhole) {
  const fs::path folder = fs::path(TUBEPLAN_SOURCE_DIR) / "../shared/real";
  if (!fs::exists(folder)) GTEST_SKIP() << "skipped: no real sets at ../shared/real";
  for (const RealSet& set : kSets) {
    const Cell cell = readCell((folder / set.cell).string());
    const auto measurements = readMeasurements((folder / set.measurement_file).string(), cell.arm);
    EXPECT_EQ(measurements.size(), set.measurements) << set.cell;
    EXPECT_EQ(static_cast<std::size_t>(measurements.front().q.size()), set.joints) << set.cell;
    const auto held_out =
        std::count_if(measurements.begin(), measurements.end(), [](const auto& m) { return m.is_held_out; });
    EXPECT_GT(held_out, 0) << set.cell;
    EXPECT_LT(static_cast<std::size_t>(held_out), set.measurements) << set.cell;
  }
}

/// If the last third of the measurements is in metres or radians, under headings in millimetres and degrees, the
/// reported mistake names the first and the last measurement affected.
TEST(RealData, aRunInAnotherUnitIsNamedByItsFirstAndLastMeasurement) {
  const fs::path folder = fs::path(TUBEPLAN_SOURCE_DIR) / "../shared/real";
  if (!fs::exists(folder)) GTEST_SKIP() << "skipped: no real sets at ../shared/real";
  for (const char* robot : {"motoman", "ur5", "wam"}) {
    const Cell cell = readCell((folder / robot / "cell.yaml").string());
    const std::string file = (folder / robot / "measurements.csv").string();
    const MeasurementTable table = parseMeasurementTable(readTextFile(file), file, cell.arm);
    const std::size_t first = table.measurements.size() * 2 / 3;
    const std::string run = table.measurements[first].id + ".." + table.measurements.back().id;
    for (const bool is_of_angles : {false, true}) {
      SCOPED_TRACE(fmt::format("{} {}", robot, is_of_angles));
      auto measurements = table.measurements;
      for (std::size_t k = first; k < measurements.size(); ++k)
        is_of_angles ? void(measurements[k].q *= std::numbers::pi / 180) : void(*measurements[k].p_W *= 1e-3);
      const auto checks = calibration::checkMeasurements(
          {startOf(cell, measurements), measurements, freeNumbersOf(cell), table.units, nullptr});
      const auto* mistake = calibration::firstMistake(checks);
      ASSERT_TRUE(mistake);
      EXPECT_EQ(mistake->assume, is_of_angles ? "angles-of=" + run + ":rad" : "coordinates-of=" + run + ":m");
    }
  }
}

/// Returns the text without the lines that only the shipped mock-up has: the position of the manway and the park
/// posture.
std::string withoutAdditions(std::string text) {
  for (const char* key : {"  manway:", "park:"})
    if (const std::size_t at = text.find(key); at != std::string::npos)
      text = text.substr(0, at) + text.substr(text.find('\n', at) + 1);
  return text;
}

TEST(RealData, contractCellsAreTheShippedOnesButForTheirAdditions) {
  const fs::path folder = fs::path(TUBEPLAN_SOURCE_DIR) / "../shared/contract";
  if (!fs::exists(folder)) GTEST_SKIP() << "skipped: no contract at ../shared/contract";
  for (const char* name : {"bench.yaml", "bowl.yaml", "cobra-arm.yaml", "mockup.yaml"})
    EXPECT_EQ(contentOf(folder / name), withoutAdditions(contentOf(shippedCells() / name))) << name;
  for (const char* name : {"bench.yaml", "bowl.yaml", "mockup.yaml"}) {
    const Cell cell = readCell((folder / name).string());
    EXPECT_FALSE(cell.sheet && cell.sheet->manway) << name;
    EXPECT_FALSE(cell.park.has_value()) << name;
  }
}

TEST(RealData, practiceSetsAreRead) {
  const fs::path folder = fs::path(TUBEPLAN_SOURCE_DIR) / "../shared/hidden-effects";
  if (!fs::exists(folder)) GTEST_SKIP() << "skipped: no practice sets at ../shared/hidden-effects";
  const Cell cell = readCell((shippedCells() / "bench.yaml").string());
  int sets = 0;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const auto measurements = readMeasurements((entry.path() / "measurements.csv").string(), cell.arm);
    EXPECT_GE(measurements.size(), 60u) << entry.path();
    EXPECT_EQ(measurements.front().approach_directions.size(), 4u);
    ++sets;
  }
  EXPECT_GT(sets, 10);
}

}  // namespace
}  // namespace tubeplan::app
