// Tests of files with random damage: each must be read, or refused with a message of one line.
#include <random>

#include "app/formats/arm/arm_reader.hpp"
#include "app/formats/cell/cell_reader.hpp"
#include "app/formats/foreign/foreign_measurements.hpp"
#include "app/formats/measurements/measurements_reader.hpp"
#include "app/formats/plan/plan_reader.hpp"
#include "app/formats/yaml/strict_yaml.hpp"
#include "tests/app/test_files.hpp"

namespace tubeplan::app {
namespace {

// Fragments that are likely to upset a parser, inserted at random positions.
constexpr const char* kPieces[] = {
    "",      "{",  "}", "[", "]",  ":",   ": ", "- ",  "'",     "\"", "#", "\n",   "\n\n  ", "nan",  ".inf",
    "1e999", "-1", "0", ",", ",,", "&a ", "*a", "!t ", "---\n", "|",  ">", "\xC3", "? ",     "name", "99999999999"};

std::string damaged(std::string text, std::mt19937_64& random) {
  const int hits = 1 + static_cast<int>(random() % 3);
  for (int i = 0; i < hits && !text.empty(); ++i) {
    const std::size_t at = random() % text.size();
    const std::size_t length = random() % 4 == 0 ? random() % 40 : random() % 3;
    text.replace(at, std::min(length, text.size() - at), kPieces[random() % std::size(kPieces)]);
  }
  return text;
}

template <class Read>
void expectReadOrRefused(const std::string& text, int times, Read&& read) {
  std::mt19937_64 random(2024);
  int refused = 0;
  for (int i = 0; i < times; ++i) {
    const std::string bad = damaged(text, random);
    try {
      read(bad);
    } catch (const InputError& error) {
      ++refused;
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
      EXPECT_LT(std::string(error.what()).size(), 2000u);
    } catch (const std::exception& error) {
      ADD_FAILURE() << error.what() << "\n" << bad;
    }
  }
  EXPECT_GT(refused, times / 10);
  EXPECT_LT(refused, times);
}

TEST(MutatedFiles, armsAreReadOrRefused) {
  expectReadOrRefused(contentOf(shippedCells() / "cobra-arm.yaml"), 2000,
                      [](const std::string& text) { (void)readArm(parseYaml(text, "arm.yaml")); });
}

class MutatedCell : public FolderTest {};

TEST_F(MutatedCell, cellsAreReadOrRefused) {
  std::filesystem::copy_file(shippedCells() / "cobra-arm.yaml", folder / "cobra-arm.yaml");
  expectReadOrRefused(contentOf(shippedCells() / "mockup.yaml"), 200,
                      [&](const std::string& text) { (void)readCell(write("cell.yaml", text)); });
}

TEST_F(MutatedCell, plansAreReadOrRefused) {
  const Cell cell = readCell((shippedCells() / "mockup.yaml").string());
  const std::string both = contentOf(std::filesystem::path(TUBEPLAN_SOURCE_DIR) / "tests/fuzz/corpus/plan/two_tubes");
  const std::string plan = both.substr(0, both.find("time_s,")), path = both.substr(plan.size());
  const auto read = [&](const std::string& one, const std::string& other) {
    (void)write("plan.json", one);
    (void)write("path.csv", other);
    (void)readPlanFiles(folder, cell);
  };
  expectReadOrRefused(plan, 2000, [&](const std::string& bad) { read(bad, path); });
  expectReadOrRefused(path, 2000, [&](const std::string& bad) { read(plan, bad); });
}

TEST(MutatedFiles, measurementsAreReadOrRefused) {
  const Cell cell = readCell((shippedCells() / "mockup.yaml").string());
  const std::string text =
      "id,kind,point,load_lbf,theta1_deg,theta2_deg,theta3_deg,theta4_deg,x_in,y_in,z_in,sigma_in,time_min\n"
      "a,position,P1,20,10,90,-20,5,1,2,3,0.003,1\nb,touch,R1C57,20,10,90,-20,5,,,,0.003,2\n";
  expectReadOrRefused(text, 5000,
                      [&](const std::string& bad) { (void)parseMeasurements(bad, "m.csv", cell.arm, &*cell.sheet); });
}

TEST(MutatedFiles, tablesOfOtherProgramsAreReadOrRefused) {
  const Cell cell = readCell((shippedCells() / "bench.yaml").string());
  const std::string points = "Units: mm\nJob::Arm::P1 1.5 2 3\nJob::Arm::P2 4 5 6\nJob::Arm::P3 7 8 9\n";
  const std::string log =
      "Point;J1 [deg];J2 [deg];J3 [deg];J4 [deg];Payload [kg]\nP1;10;45;-35;12,5;1\nP2;20;45;-35;12;2\nP3;1;2;3;4;0\n";
  const ColumnChoice millimetres{{}, {{UnitKind::kLength, findUnit(UnitKind::kLength, "mm")}}};
  const auto read = [&](const std::string& one, const std::string& other) {
    const ForeignRequest request{{parseForeignTable(one, "a"), parseForeignTable(other, "b")}, millimetres, ""};
    (void)parseMeasurementTable(readForeign(request, cell.arm).text, "readings", cell.arm);
  };
  expectReadOrRefused(log, 3000, [&](const std::string& bad) { read(points, bad); });
  expectReadOrRefused(points, 3000, [&](const std::string& bad) { read(bad, log); });
}

}  // namespace
}  // namespace tubeplan::app
