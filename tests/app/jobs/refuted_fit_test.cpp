// A fit that the measurements refute is reported as falling short, for all options of the fit and even if it does not
// converge.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "app/formats/measurements/measurements_writer.hpp"
#include "app/jobs/identification.hpp"
#include "tests/app/program.hpp"

namespace tubeplan::app {
namespace {

constexpr double kTiny = 1e-6;  // p-value below which a misfit is not due to chance
constexpr const char* kOptions[] = {"--folds 0",
                                    "--folds 3",
                                    "--folds 0 --robust huber",
                                    "--folds 0 --robust cauchy",
                                    "--folds 0 --starts 2",
                                    "--folds 0 --drop 0.05",
                                    "--folds 0 --assume as-is",
                                    "--folds 0 --method levenberg-marquardt",
                                    "--folds 0 --method in-turn",
                                    "--folds 0 --free tool.joint_stiffness.z",
                                    "--folds 0 --stage tool.joint_stiffness.z --stage forearm.joint_stiffness.z"};

class RefutedFits : public ProgramTest {
 protected:
  /// Writes m.csv: the simulated measurements of a cell, each altered by `change`.
  void simulate(const std::string& words, const std::function<void(std::size_t, calibration::Measurement&)>& change) {
    cell_ = shipped(words.substr(0, words.find(' ')));
    const auto made = run("simulate " + cell_ + words.substr(words.find(' ')) + " --seed 3 --out made");
    ASSERT_EQ(made.exit_code, 0) << made.err;
    const Cell cell = readCell((shippedCells() / words.substr(0, words.find(' '))).string());
    auto measurements = parseMeasurementText(contentOf(folder / "made/measurements.csv"), "made", cell);
    for (std::size_t k = 0; k < measurements.size(); ++k) change(k, measurements[k]);
    write("m.csv", measurementsCsv(measurements, cell.arm, cell.units));
  }

  [[nodiscard]] nlohmann::json identified(const std::string& options) const {
    const auto outcome = run("identify " + cell_ + " m.csv " + options + " --json -");
    return nlohmann::json::parse(outcome.out, nullptr, false);
  }

  void expectRefuted(const std::string& options) const {
    SCOPED_TRACE(options);
    const auto figures = identified(options);
    ASSERT_TRUE(figures.is_object());
    ASSERT_TRUE(figures["p_value"].is_number()) << figures["reason"];
    EXPECT_LT(figures["p_value"].get<double>(), kTiny);
    EXPECT_EQ(figures["adequacy"], "falls-short");
    EXPECT_FALSE(figures["warnings"].empty());
  }

  std::string cell_;
};

TEST_F(RefutedFits, FallShortByAnyOption) {
  simulate("bench.yaml --design bench --readings 16",
           [](std::size_t k, auto& measurement) { measurement.p_W->z() += 0.01 * (static_cast<double>(k % 3) - 1); });
  for (const char* options : kOptions) expectRefuted(options);
}

/// If all touches record the second joint value of the first, the fit ends at the iteration limit and still falls
/// short.
TEST_F(RefutedFits, FallShortWhereTheFitDoesNotConverge) {
  double stale = 0;
  simulate("bowl.yaml --design touch --readings 18", [&](std::size_t k, auto& measurement) {
    if (k == 0) stale = measurement.q[1];
    measurement.q[1] = stale;
  });
  const std::string options = "--folds 0 --method levenberg-marquardt --assume as-is";
  EXPECT_EQ(identified(options)["status"], "not-converged");
  expectRefuted(options);
}

TEST_F(RefutedFits, DoNotComeOfMeasurementsThatFit) {
  simulate("bench.yaml --design bench --readings 40", [](std::size_t, auto&) {});
  for (const char* options : kOptions) {
    SCOPED_TRACE(options);
    const auto figures = identified(options);
    ASSERT_TRUE(figures.is_object());
    EXPECT_GT(figures["p_value"].get<double>(), kTiny);
    EXPECT_EQ(figures["adequacy"], "adequate");
  }
}

}  // namespace
}  // namespace tubeplan::app
