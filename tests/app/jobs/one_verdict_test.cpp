// All commands agree on the same measurements: if one reports a mistake, all report the mistake and end in the same
// way.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "app/documents/measurement_checks_json.hpp"
#include "app/formats/measurements/measurements_writer.hpp"
#include "app/jobs/comparison.hpp"
#include "app/jobs/diagnosis.hpp"
#include "app/jobs/identification.hpp"
#include "tests/app/program.hpp"
#include "tests/calibration/measurement_faults.hpp"

namespace tubeplan::app {
namespace {

using calibration::Measurement;

/// Returns simulated measurements with one or two deliberate mistakes `of`, as the program reads them from a table.
CellMeasurements measurementsWithFaults(const std::vector<calibration::MeasurementFault>& of) {
  Cell cell = readCell((shippedCells() / "bench.yaml").string());
  auto measurements = calibration::campaignWithFault(cell.arm, 3, of.front());
  std::mt19937_64 random(4);
  for (std::size_t k = 1; k < of.size(); ++k) of[k].apply(measurements, random);
  const std::string name = "spoilt.csv", table = measurementsCsv(measurements, cell.arm, cell.units);
  CellMeasurements input{cell, name, {}};
  auto [read, checks] = parseAndCheck(table, name, input.cell, {});
  input.measurements = std::move(read);
  input.checks = std::move(checks);
  return input;
}

/// Expects all commands to agree; returns true if they named a mistake.
bool expectAgreement(const CellMeasurements& input) {
  const auto diagnosed = diagnoseModel(input, {});
  const auto compared = compareModel(input, {.folds = 0});
  IdentificationRequest request;
  request.folds = 0;
  const auto identified = identifyModel(input, request);
  const std::string mistake = mistakeText(input.checks, input.cell.units);
  if (mistake.empty()) {
    EXPECT_NE(identified.fit.status, calibration::IdentificationStatus::kNotRun);
    EXPECT_FALSE(identified.figures["parameters"].empty());
    EXPECT_EQ(identified.set_aside, compared.set_aside);
    EXPECT_EQ(identified.figures["adequacy"], compared.figures["after_refit"]["verdict"]);
    return false;
  }
  EXPECT_EQ(diagnosed.figures["verdict"], "inconclusive");
  EXPECT_EQ(diagnosed.figures["sentence"], noVerdictSentence(mistake));
  EXPECT_EQ(compared.figures["verdict"], "inconclusive");
  EXPECT_EQ(compared.figures["grounds"], nlohmann::json::array({mistake}));
  EXPECT_EQ(compared.figures["verdict_words"], diagnosed.figures["verdict_words"]);
  EXPECT_EQ(compared.figures["verdict_words"].dump().find("more readings"), std::string::npos);
  for (const char* model : {"as_it_stands", "after_refit"})
    EXPECT_EQ(compared.figures[model]["verdict"], "inconclusive") << model;
  EXPECT_EQ(identified.figures["status"], "not-run");
  EXPECT_EQ(identified.figures["adequacy"], compared.figures["verdict"]);
  EXPECT_EQ(identified.figures["reason"], mistake);
  EXPECT_TRUE(identified.figures["parameters"].empty());
  EXPECT_TRUE(identified.set_aside.empty() && compared.set_aside.empty()) << "readings are no outliers of a mistake";
  return true;
}

class OneVerdict : public testing::TestWithParam<std::size_t> {};

TEST_P(OneVerdict, OfAllWhoJudge) {
  const auto& fault = calibration::measurementFaults()[GetParam()];
  SCOPED_TRACE(fault.name);
  const bool is_named = expectAgreement(measurementsWithFaults({fault}));
  if (std::string(fault.name).starts_with("nothing")) {
    EXPECT_FALSE(is_named);
  }
  for (const char* gross : {"a joint's sign", "the joints of the row before"})
    if (fault.name == std::string(gross)) {
      EXPECT_TRUE(is_named);
    }
}

TEST_P(OneVerdict, OfTwoMistakesAtOnce) {
  const auto sign = std::ranges::find(calibration::measurementFaults(), std::string("a joint's sign"),
                                      &calibration::MeasurementFault::name);
  ASSERT_NE(sign, calibration::measurementFaults().end());
  const auto& fault = calibration::measurementFaults()[GetParam()];
  SCOPED_TRACE(fault.name);
  (void)expectAgreement(measurementsWithFaults({fault, *sign}));
}

INSTANTIATE_TEST_SUITE_P(OfEveryFault, OneVerdict,
                         testing::Range<std::size_t>(0, calibration::measurementFaults().size()));

/// A command on m.csv, the JSON pointer to the verdict in its figures (empty if it gives none), and the verdict that is
/// expected if the measurements contain a mistake.
struct ExpectedVerdict {
  const char *command, *where, *over_a_mistake;
};
constexpr ExpectedVerdict kOfBench[] = {
    {"compare bench.yaml m.csv --folds 0", "/verdict", "inconclusive"},
    {"diagnose bench.yaml m.csv --effects 1", "/verdict", "inconclusive"},
    {"identify bench.yaml m.csv --folds 0", "/adequacy", "inconclusive"},
    {"identify bench.yaml m.csv --folds 0 --out written", "/adequacy", "inconclusive"},
    {"improve bench.yaml m.csv --steps 1 --out written", "/end", "mistake"},
    {"ladder m.csv bench.yaml", "", ""},
    {"touches bench.yaml --readings m.csv --candidates 20 --count 2 --csv written", "", ""},
    {"sensitivity bench.yaml --readings m.csv --postures 10", "", ""}};
constexpr ExpectedVerdict kOfMockup[] = {
    {"compare mockup.yaml m.csv --folds 0", "/verdict", "inconclusive"},
    {"calibrate mockup.yaml m.csv --out written", "", ""},
    {"touches mockup.yaml --readings m.csv --goal base --tubes spread:5 --candidates 10 --csv written", "", ""}};

class OneAnswer : public ProgramTest {
 protected:
  OneAnswer() {
    for (const char* file : {"bench.yaml", "mockup.yaml", "cobra-arm.yaml"})
      write(file, contentOf(shippedCells() / file));
  }

  /// Writes turned0.csv, turned1.csv and turned2.csv: the measurements with the signs of 0, 1 and 2 joints inverted.
  void simulate(const std::string& words) const {
    const auto made = run("simulate " + words + " --seed 7 --out made");
    ASSERT_EQ(made.exit_code, 0) << made.err;
    Cell cell = readCell((folder / words.substr(0, words.find(' '))).string());
    const std::string table = contentOf(folder / "made/measurements.csv");
    for (const int turned : {0, 1, 2}) {
      auto measurements = parseMeasurementText(table, "made", cell, 0);
      for (auto& measurement : measurements)
        for (int joint = 2; joint < 2 + turned; ++joint) measurement.q[joint] = -measurement.q[joint];
      write("turned" + std::to_string(turned) + ".csv", measurementsCsv(measurements, cell.arm, cell.units));
    }
  }

  void expectOneAnswer(std::span<const ExpectedVerdict> questions, int turned) const {
    SCOPED_TRACE(std::to_string(turned) + " signs turned");
    write("m.csv", contentOf(folder / ("turned" + std::to_string(turned) + ".csv")));
    nlohmann::json checks;
    for (const auto& expected : questions) {
      SCOPED_TRACE(expected.command);
      const auto outcome = run(std::string(expected.command) + " --json -");
      EXPECT_EQ(outcome.exit_code, turned > 0 ? 1 : 0) << outcome.err;
      const auto figures = nlohmann::json::parse(outcome.out, nullptr, false);
      ASSERT_TRUE(figures.is_object()) << outcome.out;
      if (checks.is_null()) checks = figures["checks"];
      EXPECT_EQ(figures["checks"], checks);
      if (turned > 0) {
        ASSERT_FALSE(checks.empty());
        EXPECT_EQ(checks[0]["severity"], "mistake");
        if (*expected.where) {
          EXPECT_EQ(figures[nlohmann::json::json_pointer(expected.where)], expected.over_a_mistake);
        }
      }
      const bool writes = std::string(expected.command).ends_with("written");
      EXPECT_EQ(std::filesystem::exists(folder / "written"), writes && turned == 0);
      std::filesystem::remove(folder / "written");
      std::filesystem::remove(folder / "written-arm.yaml");
    }
  }
};

TEST_F(OneAnswer, OfAllWhoTakeMeasurementsOfABench) {
  ASSERT_NO_FATAL_FAILURE(simulate("bench.yaml --design bench --readings 40 --spread 0.1"));
  for (const int turned : {0, 1, 2}) expectOneAnswer(kOfBench, turned);
}

TEST_F(OneAnswer, OfAllWhoTakeTouchesOfHoles) {
  ASSERT_NO_FATAL_FAILURE(simulate("mockup.yaml --design bowl --readings 8 --loads 0"));
  for (const int turned : {0, 2}) expectOneAnswer(kOfMockup, turned);
}

}  // namespace
}  // namespace tubeplan::app
