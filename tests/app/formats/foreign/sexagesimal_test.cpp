// Tests of sexagesimal angles: their notations in hours and in degrees, and strings that are refused.
#include "app/formats/foreign/sexagesimal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "app/formats/cell/cell_reader.hpp"
#include "app/formats/foreign/foreign_heading.hpp"
#include "app/formats/foreign/foreign_measurements.hpp"
#include "app/formats/measurements/measurements_reader.hpp"
#include "tests/app/test_files.hpp"

namespace tubeplan::app {
namespace {

TEST(Sexagesimal, ReadsEveryForm) {
  constexpr double kWhole = 12 + 34 / 60. + 56.7 / 3600;
  struct Row {
    const char* text;
    double value;
    SixtiethForm form;
  };
  for (const Row& row :
       {Row{"12:34:56.7", kWhole, SixtiethForm::kColons}, Row{"+12:34:56.7", kWhole, SixtiethForm::kColons},
        Row{"-12 34 56.7", -kWhole, SixtiethForm::kBlanks}, Row{"12h34m56.7s", kWhole, SixtiethForm::kHours},
        Row{"-12h 34m 56.7s", -kWhole, SixtiethForm::kHours}, Row{"12d34'56.7\"", kWhole, SixtiethForm::kDegrees},
        Row{"12d34m56.7s", kWhole, SixtiethForm::kDegrees}, Row{"12°34'56.7\"", kWhole, SixtiethForm::kDegrees},
        Row{"-12° 34′ 56.7″", -kWhole, SixtiethForm::kDegrees}, Row{"12:34:56,7", kWhole, SixtiethForm::kColons},
        Row{"-0:30:00", -0.5, SixtiethForm::kColons}, Row{"-00 00 36", -0.01, SixtiethForm::kBlanks},
        Row{"12:34.5", 12.575, SixtiethForm::kColons}, Row{"12h34m", 12 + 34 / 60., SixtiethForm::kHours},
        Row{"0:59:60", 1, SixtiethForm::kColons}, Row{"359:00:00", 359, SixtiethForm::kColons}}) {
    const auto angle = parseSexagesimal(row.text);
    ASSERT_TRUE(angle) << row.text;
    EXPECT_NEAR(angle->value, row.value, 1e-12) << row.text;
    EXPECT_EQ(angle->form, row.form) << row.text;
  }
}

TEST(Sexagesimal, RefusesWhatIsNone) {
  for (const char* text : {"",           "-",         "12",         "12.5",       "12h",          "12d",
                           "12:75:00",   "12:34:75",  "12h75m00s",  "12d34'75\"", "--12:34:56",   "+-12:34:56",
                           "12:-34:56",  "12:34:-56", "12 -34 56",  "12.5:34:56", "12:34.5:56",   "12h34.5m56s",
                           "12:34:56:7", "12:34:",    ":34:56",     "12::56",     "12h34'56s5",   "12h34d56s",
                           "12m34h56s",  "12d34h",    "12:34h56",   "1e1:00:00",  "12:34:56.7.8", "12:34:5,6,7",
                           "12:34:56 W", "nan:00:00", "2026-11-28", "R10C20",     "1 234 567"})
    EXPECT_FALSE(parseSexagesimal(text)) << text;
}

class SixtiethColumns : public ::testing::Test {
 protected:
  const Cell cell = readCell((shippedCells() / "bench.yaml").string());  // joints theta1 to theta4

  /// Reads a table with `fields` of the first joint under `heading`, the other joints at 0, 45 and -35 deg, and x, y, z
  /// in mm.
  [[nodiscard]] ForeignMeasurements read(const std::string& heading, const std::vector<std::string>& fields,
                                         const std::vector<std::string>& columns = {}) const {
    std::string text = "id;" + heading + ";theta2_deg;theta3_deg;theta4_deg;x_mm;y_mm;z_mm\n";
    for (std::size_t k = 0; k < fields.size(); ++k)
      text += fmt::format("P{};{};0;45;-35;{};2;3\n", k + 1, fields[k], k + 1);
    ForeignRequest request{{}, {columns, {{UnitKind::kAngle, findUnitWord("deg")}}}, ""};
    request.tables.push_back(parseForeignTable(text, "log.csv"));
    return readForeign(request, cell.arm);
  }
  [[nodiscard]] std::vector<double> degrees(const std::string& heading, const std::vector<std::string>& fields,
                                            const std::vector<std::string>& columns = {}) const {
    const auto table = parseMeasurementTable(read(heading, fields, columns).text, "t", cell.arm, nullptr);
    std::vector<double> all;
    for (const auto& measurement : table.measurements) all.push_back(measurement.q[0] * 180 / std::numbers::pi);
    return all;
  }
  [[nodiscard]] std::string refusal(const std::string& heading, const std::vector<std::string>& fields,
                                    const std::vector<std::string>& columns = {}) const {
    return messageOf([&] { (void)read(heading, fields, columns); });
  }
};

TEST_F(SixtiethColumns, AreHoursOrDegreesAsHeadingOrSignsSay) {
  constexpr std::array kNumbers{1.5, -0.5, 2.01};
  const std::vector<std::string> colons{"1:30:00", "-0:30:00", "+2:00:36"};
  const std::vector<std::string> hours{"1h30m00s", "-0h30m00s", "2h00m36s"};
  const std::vector<std::string> marks{"1d30'00\"", "-0°30'00\"", "2° 00′ 36″"};
  const std::vector<std::string> blanks{"1 30 00", "-0 30 00", "2 00 36"}, plain{"1.5", "-0.5", "2.01"};
  struct Row {
    std::string heading;
    std::vector<std::string> fields, columns;
    double factor;
  };
  for (const Row& row :
       {Row{"theta1 [hms]", colons, {}, 15}, Row{"theta1_hms", blanks, {}, 15}, Row{"theta1 [h]", colons, {}, 15},
        Row{"theta1 (hours)", plain, {}, 15}, Row{"theta1", hours, {}, 15}, Row{"theta1 [h]", hours, {}, 15},
        Row{"theta1 [dms]", colons, {}, 1}, Row{"theta1_dms", marks, {}, 1}, Row{"theta1 [deg]", blanks, {}, 1},
        Row{"theta1 [°]", marks, {}, 1}, Row{"theta1", marks, {}, 1}, Row{"ha", colons, {"theta1_hms=ha"}, 15},
        Row{"ha", plain, {"theta1_h=ha"}, 15}, Row{"ha", colons, {"theta1_deg=ha"}, 1},
        Row{"ha", colons, {"theta1_hms=ha*-1"}, -15}}) {
    const auto found = degrees(row.heading, row.fields, row.columns);
    ASSERT_EQ(found.size(), 3U) << row.heading;
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_NEAR(found[k], row.factor * kNumbers[k], 1e-9) << row.heading << " " << row.fields[k];
  }
}

/// Tests with a mount whose first joint measures the hour angle.
struct HourAngles : SixtiethColumns {
  deflection::Arm mount = cell.arm;
  HourAngles() {
    for (auto& row : mount.rows)
      if (row.joint.name == "theta1") row.joint.name = "ha";
  }

  [[nodiscard]] static ForeignRequest request(const std::string& heading, const std::vector<std::string>& fields,
                                              const std::vector<std::string>& columns = {}) {
    std::string text = "id;" + heading + ";theta2_deg;theta3_deg;theta4_deg;x_mm;y_mm;z_mm\n";
    for (std::size_t k = 0; k < fields.size(); ++k) text += fmt::format("P{};{};0;45;-35;1;2;3\n", k + 1, fields[k]);
    return {{parseForeignTable(text, "log.csv")}, {columns, {{UnitKind::kAngle, findUnitWord("deg")}}}, ""};
  }
  [[nodiscard]] double lastDegrees(const ForeignRequest& foreign) const {
    const auto table = parseMeasurementTable(readForeign(foreign, mount).text, "t", mount, nullptr);
    return table.measurements.back().q[0] * 180 / std::numbers::pi;
  }
};

// Hour angles in degrees that could all be hours must be refused with both interpretations and their options.
TEST_F(HourAngles, AreRefusedWhereTheirDegreesMayBeHours) {
  const std::vector<std::vector<std::string>> all_fields{
      {"1.5", "-2.25", "11"}, {"0.5", "23.75"}, {"-11.9", "0", "+3.5"}, {"6.25"}, {"-12", "12"}};
  for (const char* heading : {"ha", "ha_deg", "ha [deg]", "HA (degrees)"})
    for (const auto& fields : all_fields) {
      SCOPED_TRACE(testing::Message() << heading << " " << fields.front());
      const auto message = messageOf([&] { (void)readForeign(request(heading, fields), mount); });
      for (const std::string& part : {fmt::format("--column ha_h='{}'", heading),
                                      fmt::format("--column ha_deg='{}'", heading), std::string("hours")})
        EXPECT_NE(message.find(part), std::string::npos) << message;
      const double last = std::stod(fields.back());
      EXPECT_NEAR(lastDegrees(request(heading, fields, {std::string("ha_h=") + heading})), 15 * last, 1e-9);
      EXPECT_NEAR(lastDegrees(request(heading, fields, {std::string("ha_deg=") + heading})), last, 1e-9);
      const auto guesses = guessColumns(request(heading, fields).tables, columnTargets(mount),
                                        {{}, {{UnitKind::kAngle, findUnitWord("deg")}}});
      EXPECT_TRUE(
          std::ranges::none_of(guesses, [](const auto& guess) { return guess && guess->column == 1 && guess->unit; }));
    }
}

TEST_F(HourAngles, AreTakenWhereTheyCanOnlyBeOne) {
  struct Row {
    const char* heading;
    std::vector<std::string> fields, columns;
    double last;  // last hour angle [deg]
  };
  for (const Row& row :
       {Row{"ha_deg", {"1.5", "-2.25", "37.5"}, {}, 37.5}, Row{"ha_deg", {"-3", "20"}, {}, 20},
        Row{"ha_deg", {"-12.5", "3"}, {}, 3}, Row{"ha_h", {"1.5", "11"}, {}, 165},
        Row{"ha (hours)", {"1.5", "11"}, {}, 165}, Row{"ha_rad", {"1.5", "0.5"}, {}, 90 / std::numbers::pi},
        Row{"ha_deg", {"1.5", "11"}, {"ha=ha_deg*15"}, 165}}) {
    SCOPED_TRACE(testing::Message() << row.heading << " " << row.fields.front());
    EXPECT_NEAR(lastDegrees(request(row.heading, row.fields, row.columns)), row.last, 1e-9);
  }
}

// A factor of -1 does not state a unit, so hour angles that may be hours or degrees must also be refused with this
// factor.
TEST_F(HourAngles, AreRefusedWithAnotherSignToo) {
  const auto turned = request("ha_deg", {"1.5", "11"}, {"ha=ha_deg*-1"});
  EXPECT_NE(messageOf([&] { (void)readForeign(turned, mount); }).find("--column ha_h="), std::string::npos);
}

TEST_F(SixtiethColumns, AreRefusedWhereNothingSaysOfWhat) {
  for (const char* text : {"1:30:00", "1 30 00"}) {
    const auto message = refusal("theta1", {text, text});
    for (const char* part : {"22.5 deg", "1.5 deg", "theta1 [hms]", "theta1 [dms]"})
      EXPECT_NE(message.find(part), std::string::npos) << message;
  }
}

TEST_F(SixtiethColumns, AreRefusedWithTheLineWhereTheyAreWrong) {
  struct Row {
    std::string heading;
    std::vector<std::string> fields;
    const char* line;
  };
  for (const Row& row :
       {Row{"theta1 [hms]", {"1:30:00", "1:75:00"}, "log.csv:3"},
        Row{"theta1 [hms]", {"1:30:00", "--1:30:00"}, "log.csv:3"},
        Row{"theta1 [hms]", {"1:30:00", "1.5"}, "log.csv:3"}, Row{"theta1 [hms]", {"1.5", "1.5"}, "log.csv:2"},
        Row{"theta1 [deg]", {"1.5", "1:30:00"}, "log.csv:3"},
        Row{"theta1 [deg]", {"1h30m00s", "1h30m00s"}, "log.csv:2"},
        Row{"theta1 [hms]", {"1d30m00s", "1d30m00s"}, "log.csv:2"},
        Row{"theta1 [rad]", {"1:30:00", "1:30:00"}, "log.csv:2"},
        Row{"theta1 [hms]", {"1:30:00", "1 30 00"}, "log.csv:3"},
        Row{"theta1", {"1h30m00s", "1d30m00s"}, "log.csv:3"}}) {
    const auto message = refusal(row.heading, row.fields);
    EXPECT_NE(message.find(row.line), std::string::npos) << row.heading << " " << row.fields[1] << ": " << message;
  }
}

// Times of day, and point names that look like hours, must be left unchanged.
TEST_F(SixtiethColumns, AreNotSeenInOtherColumns) {
  ForeignRequest request;
  request.tables.push_back(
      parseForeignTable("name,time,J1 [deg],J2 [deg],J3 [deg],J4 [deg],x_mm,y_mm,z_mm\n"
                        "5h,10:00:00,10,45,-35,0,1,2,3\n6h,10:00:30,10,45,-35,0,1,2,3\n",
                        "log.csv"));
  const auto table = parseMeasurementTable(readForeign(request, cell.arm).text, "t", cell.arm, nullptr);
  ASSERT_EQ(table.measurements.size(), 2U);
  EXPECT_EQ(table.measurements[1].id, "6h");
  const auto timeOf = [&](std::size_t k) { return table.measurements[k].conditions[deflection::Condition::kTime]; };
  EXPECT_DOUBLE_EQ(timeOf(1) - timeOf(0), 30);
}

// Horizontal and zenith angles of a total station may be sexagesimal; colons without a stated unit must be refused.
TEST_F(SixtiethColumns, ArePartOfForms) {
  ForeignRequest request;
  request.choice.points = "polar-clockwise";
  request.tables.push_back(
      parseForeignTable("J1 [deg];J2 [deg];J3 [deg];J4 [deg];Hz [dms];V [dms];SD [m]\n"
                        "10;45;-35;0;90°00'00\";89°59'60\";2\n10;45;-35;0;0°00'00\";30°00'00\";1\n",
                        "log.csv"));
  const auto table = parseMeasurementTable(readForeign(request, cell.arm).text, "t", cell.arm, nullptr);
  ASSERT_EQ(table.measurements.size(), 2U);
  EXPECT_TRUE(table.measurements[0].p_W->isApprox(Eigen::Vector3d(2, 0, 0), 1e-9))
      << table.measurements[0].p_W->transpose();
  EXPECT_TRUE(table.measurements[1].p_W->isApprox(Eigen::Vector3d(0, 0.5, std::sqrt(0.75)), 1e-9));
  request.tables = {
      parseForeignTable("J1 [deg];J2 [deg];J3 [deg];J4 [deg];Hz;V;SD [m]\n"
                        "10;45;-35;0;90:00:00;90:00:00;2\n10;45;-35;0;0:00:00;30:00:00;1\n",
                        "log.csv")};
  request.choice.units = {{UnitKind::kAngle, findUnitWord("deg")}};
  EXPECT_NE(messageOf([&] { (void)readForeign(request, cell.arm); }).find("Hz [dms]"), std::string::npos);
}

}  // namespace
}  // namespace tubeplan::app
