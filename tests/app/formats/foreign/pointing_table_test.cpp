#include "app/formats/foreign/pointing_table.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "app/formats/foreign/sky_directions.hpp"
#include "tests/app/test_files.hpp"

namespace tubeplan::app {
namespace {

constexpr double kSecondOfArc = 1.0 / 3600, kDegree = std::numbers::pi / 180;
const std::string kStars =
    "Hill telescope\n: NODA\n:EQUAT\n! latitude, date, degC, hPa\n+52 30 00 2026 3 1 10.0 0\n"
    "06 00 00.0 +20 00 00  06 00 04.0 +20 01 00  08 00.000\n"
    "10 30 00.0 -00 30 00  10 30 00.0 -00 31 00  08 30.000\nEND\nnot read: 1 2 3\n";

double numberAt(const ForeignTable& table, std::size_t row, std::size_t column) {
  return std::atof(table.rows.at(row).fields.at(column).c_str());
}
std::string refusalOf(const std::string& text) {
  return messageOf([&] { (void)parsePointingData(text, "sky.dat"); });
}
bool says(const ForeignTable& table, const std::string& word) {
  return std::ranges::any_of(table.remarks, [&](const auto& r) { return r.find(word) != std::string::npos; });
}

TEST(SkyDirections, areTheKnownOnes) {
  const auto pole = fromHourAngle(100, 90, 40);
  EXPECT_NEAR(pole.azimuth, 0, 1e-9);
  EXPECT_NEAR(pole.altitude, 40, 1e-9);
  const auto setting = fromHourAngle(90, 0, 40);
  EXPECT_NEAR(setting.azimuth, 90, 1e-9);  // west
  EXPECT_NEAR(setting.altitude, 0, 1e-9);
  const auto south = fromHourAngle(0, 10, 40);
  EXPECT_NEAR(std::abs(south.azimuth), 180, 1e-9);
  EXPECT_NEAR(south.altitude, 60, 1e-9);
  const auto north_of_a_southern_place = fromHourAngle(0, 10, -40);
  EXPECT_NEAR(north_of_a_southern_place.azimuth, 0, 1e-9);
  EXPECT_NEAR(north_of_a_southern_place.altitude, 40, 1e-9);
}

/// Reference values: Meeus, Astronomical Algorithms, example 13.b: Venus seen from Washington, hour angle 64.352133
/// deg, azimuth from south 68.0337 deg.
TEST(SkyDirections, agreeWithATextbook) {
  const auto venus = fromHourAngle(64.352133, -6.719892, 38.0 + 55.0 / 60 + 17.0 / 3600);
  EXPECT_NEAR(180 - venus.azimuth, 68.0337, 1e-3);
  EXPECT_NEAR(venus.altitude, 15.1249, 1e-3);
}

TEST(SkyDirections, refractionIsThatOfTables) {
  EXPECT_NEAR(refractionAt(0, 1010, 10) * 60, 28.9, 0.3);  // in arc minutes, for a true altitude of 0
  EXPECT_NEAR(refractionAt(45, 1010, 10) * 60, 1.0, 0.02);
  EXPECT_NEAR(refractionAt(90, 1010, 10) * 60, 0, 0.01);
  EXPECT_NEAR(refractionAt(45, 505, 10) / refractionAt(45, 1010, 10), 0.5, 1e-12);
}

TEST(PointingTable, readsStarsOfAnEquatorialMount) {
  ASSERT_TRUE(isPointingData(kStars));
  const auto table = parsePointingData(kStars, "sky.dat");
  ASSERT_EQ(table.rows.size(), 2u);
  EXPECT_EQ(table.rows[0].line, 6);
  EXPECT_EQ(table.rows[0].fields[0], "direction");
  const auto star = fromHourAngle(30, 20, 52.5);
  EXPECT_NEAR(numberAt(table, 0, 1), star.azimuth, 1e-6);
  EXPECT_NEAR(numberAt(table, 0, 2), star.altitude, 1e-6);
  EXPECT_NEAR(numberAt(table, 0, 3), -30 + 60 * kSecondOfArc, 1e-6);  // 4 s of time are 60 seconds of arc
  EXPECT_NEAR(numberAt(table, 0, 4), 20 + 60 * kSecondOfArc, 1e-6);
  EXPECT_NEAR(numberAt(table, 1, 4), -0.5 - 60 * kSecondOfArc, 1e-6);  // -00 keeps its sign
  EXPECT_FALSE(says(table, "diurnal"));
}

/// A mount with the joints hour angle and declination, on the base that the remark describes, must point at the star.
TEST(PointingTable, jointsAreThoseOfTheBaseThatIsNamed) {
  using Eigen::AngleAxisd, Eigen::Vector3d;
  for (const double latitude : {52.5, 10.0}) {
    std::string text = kStars;
    text.replace(text.find("+52 30"), 6, latitude > 50 ? "+52 30" : "+10 00");
    const auto table = parsePointingData(text, "sky.dat");
    EXPECT_TRUE(says(table, latitude > 50 ? "rpy 0, -37.500000, 180" : "rpy 0, -80.000000, 180"));
    const Eigen::Matrix3d base =
        (AngleAxisd(std::numbers::pi, Vector3d::UnitZ()) * AngleAxisd((latitude - 90) * kDegree, Vector3d::UnitY()))
            .toRotationMatrix();
    const double polar = -30 * kDegree, declination = 20 * kDegree;
    const Vector3d sight =
        base * AngleAxisd(polar, Vector3d::UnitZ()) * AngleAxisd(-declination, Vector3d::UnitY()) * Vector3d::UnitX();
    EXPECT_NEAR(std::atan2(sight.y(), sight.x()) / kDegree, numberAt(table, 0, 1), 1e-6);
    EXPECT_NEAR(std::asin(sight.z()) / kDegree, numberAt(table, 0, 2), 1e-6);
  }
}

TEST(PointingTable, readsAzimuthsAndElevations) {
  const auto table = parsePointingData(
      "Dish\n: ALTAZ ROTNL\n32 46 49.3\n350.5 40.0 350.6 40.1 12.5\n190 20 -170 20.25 13\n", "sky.dat");
  ASSERT_EQ(table.rows.size(), 2u);
  EXPECT_NEAR(numberAt(table, 0, 1), 9.5, 1e-9);
  EXPECT_NEAR(numberAt(table, 0, 3), 9.4, 1e-9);
  EXPECT_NEAR(numberAt(table, 1, 1), 170, 1e-9);
  EXPECT_NEAR(numberAt(table, 1, 3), 170, 1e-9);
  EXPECT_NEAR(numberAt(table, 1, 4), 20.25, 1e-9);
  EXPECT_TRUE(says(table, "the last 1 of each row are left out"));
}

TEST(PointingTable, readsStarsOfAnAltazimuthMountAsAnglesOfItsAxes) {
  std::string text = kStars;
  text.replace(text.find(":EQUAT"), 6, ":ALTAZ");
  const auto table = parsePointingData(text, "sky.dat");
  const auto read = fromHourAngle(30 - 60 * kSecondOfArc, 20 + 60 * kSecondOfArc, 52.5);
  EXPECT_NEAR(numberAt(table, 0, 3), read.azimuth, 1e-6);
  EXPECT_NEAR(numberAt(table, 0, 4), read.altitude, 1e-6);
}

TEST(PointingTable, refractsByThePressureAndSaysSo) {
  std::string text = kStars;
  text.replace(text.find("10.0 0\n"), 7, "10.0 1010\n");
  const auto with = parsePointingData(text, "sky.dat"), without = parsePointingData(kStars, "sky.dat");
  const double altitude = numberAt(without, 0, 2);
  EXPECT_NEAR(numberAt(with, 0, 2) - altitude, refractionAt(altitude, 1010, 10), 1e-6);
  EXPECT_EQ(numberAt(with, 0, 4), numberAt(without, 0, 4));  // the recorded joints of the mount do not change
  EXPECT_TRUE(says(with, "refraction at 1010 hPa"));
  text.replace(text.find(" 2026 3 1 10.0 1010"), 19, "");
  EXPECT_TRUE(says(parsePointingData(text, "sky.dat"), "no pressure is stated"));
}

TEST(PointingTable, takesTabsColonsCarriageReturnsAndNoOptions) {
  const std::string text =
      "Scope (ASCOM)\r\n-33 10 00  2024 7 14 29.20 0 231.65  0.94 0.5500 0.0065\r\n"
      "06:00:00\t-20:00:00\t06:00:04\t-20:01:00\t08:00.0\r\n";
  ASSERT_TRUE(isPointingData(text));
  const auto table = parsePointingData(text, "sky.dat");
  ASSERT_EQ(table.rows.size(), 1u);
  EXPECT_NEAR(numberAt(table, 0, 2), fromHourAngle(30, -20, -33 - 10.0 / 60).altitude, 1e-6);
  EXPECT_TRUE(says(table, "an equatorial mount is assumed"));
}

TEST(PointingTable, refusesWhatItDoesNotUnderstand) {
  const struct {
    const char* before;
    const char* now;
    const char* said;
  } cases[] = {
      {":EQUAT", ":J2000", "sky.dat:3: found the option 'J2000'"},
      {": NODA", ":ALTAZ", "sky.dat:3: both ALTAZ and EQUAT"},
      {"+52 30 00 2026", "latitude 2026", "sky.dat:5"},
      {"+52 30 00", "+95 30 00", "sky.dat:5: found '+95' as number 1"},
      {"10.0 0\n", "283.15 0\n", "a temperature of 283.15"},
      {"10.0 0\n", "10 101325\n", "a pressure of 101325"},
      {"06 00 00.0 +20", "06 61 00.0 +20", "sky.dat:6: found '61' as number 2"},
      {"06 00 00.0 +20", "06 00 00,0 +20", "'00,0'"},
      {"06 00 00.0 +20", "-6 00 00.0 +20", "'-6' hours"},
      {"08 30.000", "08", "sky.dat:7: found 13 numbers"},
      {"+52 30", "-82 30", "below the horizon"},
      {"08 30.000", "20 30.000", "sky.dat:7: the direction is"},
      {"06 00 00.0 +20 00 00  06", "06 00 00.0 +20 00 00 0 0 2000.0  06", "a mean place of the equinox 2000.0"},
      {"06 00 00.0 +20 00 00  06 00 04.0 +20 01 00  08 00.000", "30 40 30.1 40.1", "no option says ALTAZ"},
      {"06 00 00.0 +20 00 00  06 00 04.0 +20 01 00  08 00.000", "30 40 30 0 40 0 1 2 3", "found 9 numbers"},
  };
  for (const auto& [before, now, said] : cases) {
    std::string text = kStars;
    ASSERT_NE(text.find(before), std::string::npos) << before;
    text.replace(text.find(before), std::string(before).size(), now);
    EXPECT_NE(refusalOf(text).find(said), std::string::npos) << now << ": " << refusalOf(text);
  }
}

TEST(PointingTable, refusesTooFewAndTheFirstOfTwoMistakes) {
  EXPECT_NE(refusalOf("Scope\n:EQUAT\n").find("nothing below the options"), std::string::npos);
  EXPECT_NE(refusalOf("Scope\n:EQUAT\n52 30 00\n").find("no observations"), std::string::npos);
  std::string text = kStars;  // two mistakes: a latitude of the other hemisphere, and 70 minutes
  text.replace(text.find("+52"), 3, "-82");
  text.replace(text.find("10 30 00.0 -00"), 14, "10 70 00.0 -00");
  EXPECT_NE(refusalOf(text).find("sky.dat:6"), std::string::npos);
  EXPECT_NE(refusalOf("Scope\n:EQUAT\n52 30 00\n6 0 0 20 0 0 6 0 4 20 1 0 8 0 30\n").find("whole minutes"),
            std::string::npos);
}

TEST(PointingTable, leavesOtherTablesAlone) {
  for (const char* text : {"a,b\n1,2\n", "Job::Group::P1 1204.3 88.1 310.0\nJob::Group::P2 1 2 3\n",
                           "points\n1 2 3\n4 5 6\n", "! J1 J2\n1 2\n3 4\n", "", ":NODA\n1 2 3\n"})
    EXPECT_FALSE(isPointingData(text)) << text;
}

}  // namespace
}  // namespace tubeplan::app
