// What compare, identify and diagnose say of the same readings agrees: a mistake that one names, all of them name.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "app/documents/measurement_checks_json.hpp"
#include "app/files/measurements_writer.hpp"
#include "app/jobs/comparison.hpp"
#include "app/jobs/diagnosis.hpp"
#include "app/jobs/identification.hpp"
#include "tests/app/test_files.hpp"
#include "tests/calibration/spoils.hpp"

namespace tubeplan::app {
namespace {

using calibration::Measurement;

/// As the program reads the table; `of` names the spoil, and a second one on top of it where there is one.
CellReadings spoiltReadings(const std::vector<calibration::Spoil>& of) {
  Cell cell = readCell((shippedCells() / "bench.yaml").string());
  auto readings = calibration::spoiltCampaign(cell.arm, 3, of.front());
  std::mt19937_64 random(4);
  for (std::size_t k = 1; k < of.size(); ++k) of[k].apply(readings, random);
  const std::string name = "spoilt.csv", table = measurementsCsv(readings, cell.arm, cell.units);
  CellReadings input{cell, name, {}};
  auto [read, checks] = parseAndCheck(table, name, input.cell, {});
  input.readings = std::move(read);
  input.checks = std::move(checks);
  return input;
}

/// Returns whether a mistake was named.
bool expectAgreement(const CellReadings& input) {
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
  EXPECT_EQ(identified.figures["reason"], mistake);
  EXPECT_TRUE(identified.figures["parameters"].empty());
  EXPECT_TRUE(identified.set_aside.empty() && compared.set_aside.empty()) << "readings are no outliers of a mistake";
  return true;
}

class OneVerdict : public testing::TestWithParam<std::size_t> {};

TEST_P(OneVerdict, OfAllWhoJudge) {
  const auto& spoil = calibration::spoils()[GetParam()];
  SCOPED_TRACE(spoil.name);
  const bool is_named = expectAgreement(spoiltReadings({spoil}));
  if (std::string(spoil.name).starts_with("nothing")) {
    EXPECT_FALSE(is_named);
  }
  for (const char* gross : {"a joint's sign", "the joints of the row before"})
    if (spoil.name == std::string(gross)) {
      EXPECT_TRUE(is_named);
    }
}

TEST_P(OneVerdict, OfTwoMistakesAtOnce) {
  const auto sign = std::ranges::find(calibration::spoils(), std::string("a joint's sign"), &calibration::Spoil::name);
  ASSERT_NE(sign, calibration::spoils().end());
  const auto& spoil = calibration::spoils()[GetParam()];
  SCOPED_TRACE(spoil.name);
  (void)expectAgreement(spoiltReadings({spoil, *sign}));
}

INSTANTIATE_TEST_SUITE_P(OfEverySpoil, OneVerdict, testing::Range<std::size_t>(0, calibration::spoils().size()));

}  // namespace
}  // namespace tubeplan::app
