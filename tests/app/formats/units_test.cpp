#include "app/formats/units.hpp"

#include <cmath>
#include <numbers>
#include <random>

#include "app/documents/figures.hpp"
#include "app/formats/yaml/strict_yaml.hpp"
#include "tests/app/test_files.hpp"

namespace tubeplan::app {
namespace {

Units unitsOf(const std::string& text) { return Units(parseYaml("units: " + text + "\n", "f.yaml").at("units")); }

Units cobraUnits() { return unitsOf("{length: in, angle: deg, force: lbf, temperature: degF, time: min}"); }

TEST(Units, convertsByExactFactors) {
  const Units units = cobraUnits();
  EXPECT_DOUBLE_EQ(units.toInternal(1, dimension::kLength), 0.0254);
  EXPECT_DOUBLE_EQ(units.toInternal(180, dimension::kAngle), std::numbers::pi);
  EXPECT_DOUBLE_EQ(units.toInternal(1, dimension::kForce), 4.4482216152605);
  EXPECT_NEAR(units.toInternal(1, dimension::kPressure), 6894.757293168, 1e-8);
  EXPECT_NEAR(units.toInternal(1, dimension::kTorquePerAngle), 4.4482216152605 * 0.0254 * 180 / std::numbers::pi,
              1e-13);
  EXPECT_NEAR(units.toInternal(1, dimension::kLengthToTheFourth), 4.162314256e-7, 1e-20);
  EXPECT_NEAR(units.toInternal(1, dimension::kForcePerLength), 175.126835246, 1e-8);
}

TEST(Units, showLengthsToATenThousandthOfAnInch) {
  for (const auto& [unit, decimals] : {std::pair("in", 4), {"mm", 4}, {"cm", 4}, {"ft", 6}, {"m", 6}})
    EXPECT_EQ(lengthDecimals(*findUnit(UnitKind::kLength, unit)), decimals) << unit;
}

TEST(Units, convertsTemperatures) {
  const deflection::ValueUnit absolute{deflection::Quantity::kTemperature};
  EXPECT_NEAR(cobraUnits().toInternal(68, absolute), 293.15, 1e-12);
  EXPECT_NEAR(cobraUnits().toInternal(32, absolute), 273.15, 1e-12);
  EXPECT_EQ(cobraUnits().toFile(293.15, absolute), 68);
  EXPECT_EQ(unitsOf("{length: m, angle: rad, force: N}").toInternal(20, absolute), 293.15);
}

TEST(Units, LeaveNumbersOfAUnitOfTheirOwn) {
  const deflection::ValueUnit percent{deflection::Quantity::kNone, "percent"};
  EXPECT_EQ(cobraUnits().toInternal(45, percent), 45);
  EXPECT_EQ(cobraUnits().toFile(45, percent), 45);
  EXPECT_EQ(cobraUnits().nameOf(percent), "percent");
  EXPECT_EQ(cobraUnits().nameOf(deflection::ValueUnit{deflection::Quantity::kTemperature}), "degF");
}

TEST(Units, namesQuantities) {
  EXPECT_EQ(cobraUnits().nameOf(dimension::kTorquePerAngle), "lbf*in/deg");
  EXPECT_EQ(cobraUnits().nameOf(dimension::kPressure), "lbf/in^2");
  EXPECT_EQ(cobraUnits().nameOf(dimension::kLengthToTheFourth), "in^4");
  EXPECT_EQ(cobraUnits().nameOf(dimension::kAnglePerTorque), "deg/(lbf*in)");
  EXPECT_EQ(cobraUnits().nameOf(dimension::kNone), "1");
}

TEST(Units, returnEveryDecimalOfTwelveDigits) {
  std::mt19937_64 random(7);
  for (const char* block : {"{length: in, angle: deg, force: lbf}", "{length: mm, angle: deg, force: N}",
                            "{length: ft, angle: rad, force: kgf}"}) {
    const Units units = unitsOf(block);
    for (const Dimension d : {dimension::kLength, dimension::kAngle, dimension::kTorquePerAngle, dimension::kPressure,
                              dimension::kLengthToTheFourth})
      for (int i = 0; i < 1000; ++i) {
        const double value = rounded((static_cast<double>(random() >> 11) * 0x1p-53 - 0.5) *
                                     std::pow(10.0, static_cast<int>(random() % 9) - 2));
        EXPECT_EQ(units.toFile(units.toInternal(value, d), d), value);
      }
  }
}

TEST(Units, refusesUnknownUnitsWithTheKnownOnes) {
  const std::string message = messageOf([] { (void)unitsOf("{length: inch, angle: deg, force: lbf}"); });
  expectSays(message, "units.length");
  expectSays(message, "'inch'");
  expectSays(message, "in, mm, cm, m or ft");
  expectSays(messageOf([] { (void)unitsOf("{length: in, angle: deg}"); }), "'force'");
  expectSays(messageOf([] { (void)unitsOf("{length: in, angle: deg, force: lbf, tim: s}"); }), "did you mean 'time'?");
}

TEST(Units, writesNumbersShortly) {
  EXPECT_EQ(formatNumber(0.1 + 0.2), "0.3");
  EXPECT_EQ(formatNumber(-0.0), "0");
  EXPECT_EQ(formatNumber(272000), "272000");
}

}  // namespace
}  // namespace tubeplan::app
