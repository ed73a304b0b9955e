#include "app/formats/foreign/foreign_measurements.hpp"

#include <algorithm>
#include <cmath>

#include "app/formats/cell/cell_reader.hpp"
#include "app/formats/foreign/foreign_heading.hpp"
#include "app/formats/measurements/measurements_reader.hpp"
#include "app/formats/measurements/measurements_writer.hpp"
#include "tests/app/test_files.hpp"

namespace tubeplan::app {
namespace {

class ForeignMeasurementsTest : public ::testing::Test {
 protected:
  const Cell cell = readCell((shippedCells() / "bench.yaml").string());  // joints theta1 to theta4

  struct Text {
    std::string name, text;
  };

  [[nodiscard]] ForeignMeasurements read(const std::vector<Text>& texts, const std::vector<std::string>& columns = {},
                                         const std::vector<std::string>& units = {},
                                         const std::string& kind = "") const {
    ForeignRequest request{{}, {columns, {}}, kind};
    for (const auto& unit : units) request.choice.units.emplace(findUnitWord(unit)->kind, findUnitWord(unit));
    for (const auto& [name, text] : texts) request.tables.push_back(parseForeignTable(text, name));
    return readForeign(request, cell.arm);
  }
  [[nodiscard]] std::string refusal(const std::vector<Text>& texts, const std::vector<std::string>& columns = {},
                                    const std::vector<std::string>& units = {}) const {
    return messageOf([&] { (void)read(texts, columns, units); });
  }
};

TEST(ForeignHeading, findsTheUnitWhereverItStands) {
  for (const char* text : {"X [mm]", "X (mm)", "x_mm", "X mm", "X/mm", " X , mm ", "x (Millimeters)"}) {
    const auto heading = parseHeading(text);
    EXPECT_EQ(heading.name, "x") << text;
    ASSERT_NE(heading.unit, nullptr) << text;
    EXPECT_EQ(heading.unit->name, "mm") << text;
  }
  EXPECT_EQ(parseHeading("Joint 1 [°]").name, "joint1");
  EXPECT_EQ(parseHeading("Joint 1 [°]").unit->name, "deg");
  EXPECT_EQ(parseHeading("J1").unit, nullptr);
  EXPECT_EQ(parseHeading("tool_x").unit, nullptr);
  EXPECT_EQ(parseHeading("Mass (kg)").unit->name, "kgf");
}

TEST(ForeignTable, knowsItsSeparatorAndItsDecimalComma) {
  for (const char* text :
       {"a,b\n1.5,2\n3,4\n", "a;b\n1,5;2\n3;4\n", "a\tb\n1.5\t2\n3\t4\n", "a   b\n 1,5 2\n3   4\n"}) {
    const auto table = parseForeignTable(text, "t");
    EXPECT_EQ(table.columns, (std::vector<std::string>{"a", "b"})) << text;
    ASSERT_EQ(table.rows.size(), 2u) << text;
    EXPECT_EQ(table.rows[0].fields, (std::vector<std::string>{"1.5", "2"})) << text;
    EXPECT_EQ(table.rows[1].line, 3) << text;
  }
}

TEST(ForeignTable, beginsWhereTheRowsDo) {
  const auto table = parseForeignTable("// exported\nJob 7\nUnits: mm\n\nName,X,Y,Z\r\nP1,1,2,3\r\nP2,4,5,6\r\n", "t");
  EXPECT_EQ(table.lines_before, (std::vector<std::string>{"// exported", "Job 7", "Units: mm"}));
  EXPECT_TRUE(table.has_heading);
  EXPECT_EQ(table.heading_line, 5);
  ASSERT_EQ(table.rows.size(), 2u);
  EXPECT_EQ(table.columns.back(), "Z");
  EXPECT_EQ(table.rows[0].fields.back(), "3");
}

TEST(ForeignTable, takesUnitsBelowTheHeadings) {
  const auto table = parseForeignTable("Name;X;Y;J1\n;mm;[mm];deg\nP1;1,5;2;3\nP2;4;5;6\n", "t");
  EXPECT_EQ(table.columns, (std::vector<std::string>{"Name", "X [mm]", "Y [mm]", "J1 [deg]"}));
  EXPECT_EQ(table.rows.size(), 2u);
  const auto other = parseForeignTable("A;B\nX;Y\n1;2\n3;4\n", "t");
  EXPECT_EQ(other.columns, (std::vector<std::string>{"X", "Y"}));
}

TEST(ForeignTable, takesHeadingsOutOfTheCommentAboveTheRows) {
  for (const char* text : {"# made by hand\n# x_mm,y_mm,q0\n1,2,3\n4,5,6\n", "%x_mm,y_mm,q0\n1,2,3\n4,5,6\n"}) {
    const auto table = parseForeignTable(text, "t");
    EXPECT_TRUE(table.has_heading) << text;
    EXPECT_EQ(table.columns, (std::vector<std::string>{"x_mm", "y_mm", "q0"})) << text;
  }
  EXPECT_FALSE(parseForeignTable("# one, two\n1,2,3\n4,5,6\n", "t").has_heading);
  EXPECT_FALSE(parseForeignTable("#\n1,2,3\n4,5,6\n", "t").has_heading);
}

TEST(ForeignTable, refusesThousandsThatCouldBeDecimals) {
  for (const char* text : {"a;b\n1.190;12,5\n297;3\n", "a;b\n1,190;12.5\n297;3\n", "a\tb\n-1.190\t12,55\n2\t3\n"})
    EXPECT_NE(messageOf([&] { (void)parseForeignTable(text, "t"); }).find("t:2"), std::string::npos) << text;
  for (const char* text : {"a;b\n1,190;12,5\n297;3\n", "a;b\n1.190;12.5\n297;3\n", "a;b\n1.190;2\n297;3\n"})
    EXPECT_EQ(parseForeignTable(text, "t").rows[0].fields[0], "1.190") << text;
}

TEST(ForeignTable, refusesWhatIsNoTable) {
  EXPECT_NE(messageOf([] { (void)parseForeignTable("Hello there.\nThis is a letter, and no table.\n", "t"); }), "");
  EXPECT_NE(messageOf([] { (void)parseForeignTable("a,b,c\nd,e,f\n", "t"); }).find("no row has a number"),
            std::string::npos);
  EXPECT_NE(messageOf([] { (void)parseForeignTable("a,b,c\n1,2,3\n1,2\n4,5,6\n", "t"); }).find("t:3"),
            std::string::npos);
  EXPECT_NE(messageOf([] { (void)parseForeignTable("a,b,c\n1,2,\"3\n4,5,6\n7,8,9\n", "t"); }).find("quote"),
            std::string::npos);
}

TEST_F(ForeignMeasurementsTest, takesOneTableWithJointsAndPlaces) {
  const auto measurements = read({{"log.csv",
                                   "No;J1 [deg];J2 [deg];J3 [deg];J4 [deg];X [mm];Y [mm];Z [mm];Remark 1\n"
                                   "1;10;45;-35;12,5;1,5;2;3;7\n2;20;45;-35;12;4;5;6;8\n"}});
  EXPECT_EQ(measurements.text,
            "id,kind,theta1_deg,theta2_deg,theta3_deg,theta4_deg,x_mm,y_mm,z_mm\n"
            "1,position,10,45,-35,12.5,1.5,2,3\n2,position,20,45,-35,12,4,5,6\n");
  EXPECT_EQ(measurements.origins, (std::vector<std::string>{"log.csv:2", "log.csv:3"}));
  ASSERT_EQ(measurements.left_out.size(), 1u);
  EXPECT_NE(measurements.left_out[0].find("Remark 1"), std::string::npos);
  EXPECT_EQ(parseMeasurementTable(measurements.text, "r", cell.arm).measurements.size(), 2u);
}

// For an arm with joints slide, A1, A2 and A3, columns must be assigned by the joints' own names, or by numbers that
// count only the joints after the slide.
TEST_F(ForeignMeasurementsTest, aJointsOwnNameGoesBeforeItsNumber) {
  Cell shifted = cell;
  const char* kNames[] = {"slide", "A1", "A2", "A3"};
  int k = 0;
  for (auto& row : shifted.arm.rows)
    if (row.joint.type != deflection::JointType::kPassive) row.joint.name = kNames[k++];
  for (const char* heading : {"slide_deg,A1_deg,A2_deg,A3_deg", "slide_deg,J1_deg,J2_deg,J3_deg"}) {
    const ForeignRequest request{
        {parseForeignTable(std::string(heading) + ",x_mm,y_mm,z_mm\n10,45,-35,12,1,2,3\n", "t")}, {{}, {}}, ""};
    const auto measurements = readForeign(request, shifted.arm);
    EXPECT_NE(measurements.text.find("slide_deg,A1_deg,A2_deg,A3_deg"), std::string::npos) << measurements.text;
    EXPECT_NE(measurements.text.find(",10,45,-35,12,1,2,3"), std::string::npos) << measurements.text;
  }
}

TEST_F(ForeignMeasurementsTest, takesATrackersPointsBesideALogByName) {
  const auto measurements =
      read({{"points.txt", "Job::Arm::P2 4 5 6\nJob::Arm::P1 1 2 3\nJob::Arm::P9 7 8 9\n"},
            {"joints.csv", "Name,A1,A2,A3,A4\nP1,10,45,-35,12\nP2,20,45,-35,12\nP3,30,45,-35,12\n"}},
           {}, {"mm", "deg"});
  EXPECT_EQ(measurements.text,
            "id,kind,point,theta1_deg,theta2_deg,theta3_deg,theta4_deg,x_mm,y_mm,z_mm\n"
            "P1,position,P1,10,45,-35,12,1,2,3\nP2,position,P2,20,45,-35,12,4,5,6\n");
  EXPECT_EQ(measurements.left_out.size(), 2u);  // P9 of the points and P3 of the log have no match
}

TEST_F(ForeignMeasurementsTest, takesTablesWithoutNamesRowByRow) {
  const auto measurements =
      read({{"joints.txt", "10 45 -35 12\n20 45 -35 12\n"}, {"points.txt", "1 2 3\n4 5 6\n"}}, {}, {"in", "deg"});
  EXPECT_NE(measurements.text.find("\n2,position,20,45,-35,12,4,5,6\n"), std::string::npos) << measurements.text;
  EXPECT_NE(refusal({{"joints.txt", "10 45 -35 12\n20 45 -35 12\n"}, {"points.txt", "1 2 3\n4 5 6\n7 8 9\n"}}, {},
                    {"in", "deg"})
                .find("3 rows"),
            std::string::npos);
}

// Every column of a measurement table must be known to the reader of foreign tables, because others would be lost.
TEST_F(ForeignMeasurementsTest, aMeasurementTableComesOutAsItIs) {
  const std::string text =
      contentOf(std::filesystem::path(TUBEPLAN_SOURCE_DIR) / "tests/fuzz/corpus/measurements/all.csv");
  const auto through = read({{"all.csv", text}});
  EXPECT_TRUE(through.left_out.empty()) << through.left_out.front();
  const Cell mockup = readCell((shippedCells() / "mockup.yaml").string());
  const auto csvOf = [&](const std::string& table) {
    return measurementsCsv(parseMeasurements(table, "all.csv", mockup.arm, &*mockup.sheet), mockup.arm, mockup.units);
  };
  EXPECT_EQ(csvOf(through.text), csvOf(text));
}

TEST_F(ForeignMeasurementsTest, aChoiceGoesBeforeWhatHeadingsSay) {
  const std::string log = "Turret,J2,J3,J4,X,Y,Z,MX,MY,MZ\n10,45,-35,12,0,0,0,1,2,3\n10,45,-35,12,0,0,0,4,5,6\n";
  const auto measurements =
      read({{"log.csv", log}}, {"theta1_deg=Turret", "x_mm=MX", "y_mm=log.csv:MY", "z_mm=MZ"}, {"deg"});
  EXPECT_NE(measurements.text.find(
                "theta1_deg,theta2_deg,theta3_deg,theta4_deg,x_mm,y_mm,z_mm\n1,position,10,45,-35,12,1,2,3\n"),
            std::string::npos)
      << measurements.text;
}

TEST_F(ForeignMeasurementsTest, neverGuessesAUnit) {
  const std::string log = "J1,J2,J3,J4,X,Y,Z\n10,45,-35,12,1,2,3\n";
  EXPECT_NE(refusal({{"log.csv", log}}).find("the unit of"), std::string::npos);
  EXPECT_NE(refusal({{"log.csv", log}}, {}, {"deg"}).find("'X'"), std::string::npos)
      << refusal({{"log.csv", log}}, {}, {"deg"});
  EXPECT_EQ(read({{"log.csv", log}}, {}, {"deg", "mm"}).origins.size(), 1u);
}

TEST_F(ForeignMeasurementsTest, neverGuessesBetweenTwoColumns) {
  const std::string message =
      refusal({{"log.csv", "J1 [deg],J2 [deg],J3 [deg],J4 [deg],X [mm],Y [mm],Z [mm]\n1,45,-35,12,0,0,0\n"},
               {"points.csv", "X [mm],Y [mm],Z [mm]\n1,2,3\n"}});
  EXPECT_NE(message.find("could each be x"), std::string::npos) << message;
  EXPECT_NE(message.find("--column x=log.csv:X [mm]"), std::string::npos) << message;
}

TEST_F(ForeignMeasurementsTest, saysWhereANumberIsNone) {
  const std::string log =
      "J1 [deg],J2 [deg],J3 [deg],J4 [deg],X [mm],Y [mm],Z [mm]\n1,45,-35,12,0,0,0\n2,45,-35,12,abc,0,0\n";
  EXPECT_NE(refusal({{"log.csv", log}}).find("log.csv:3"), std::string::npos);
  EXPECT_NE(refusal({{"log.csv", "J1,J2,J3,X,Y,Z\n1,45,-35,0,0,0\n"}}, {}, {"deg", "mm"}).find("theta4"),
            std::string::npos);
}

TEST_F(ForeignMeasurementsTest, withoutCoordinatesMeasurementsAreTouches) {
  const auto measurements =
      read({{"log.csv", "Hole,J1,J2,J3,J4\nR1C1,10,45,-35,12\nR1C1,11,45,-35,12\n"}}, {}, {"deg"});
  EXPECT_EQ(measurements.text,
            "id,kind,point,theta1_deg,theta2_deg,theta3_deg,theta4_deg\n1,touch,R1C1,10,45,-35,12\n"
            "2,touch,R1C1,11,45,-35,12\n");
}

const char* const kLog = "Name,A1,A2,A3,A4\nP1,10,45,-35,12\nP2,20,45,-35,12\n";

// Points must be read however trackers and surveyors export them: with no, one or several names in front, and with
// other axis names.
TEST_F(ForeignMeasurementsTest, takesPlacesHoweverTheyAreExported) {
  for (const char* points : {
           "P1 1 2 3\nP2 4 5 6\n",
           "// Working frame: A::World\n// X Y Z\nA Robot P1 1 2 3\nA Robot P2 4 5 6\n",
           "A,Robot,P1,1,2,3\nA,Robot,P2,4,5,6\n",
           "A;Robot;Arm;P1;1,0;2,0;3,0\nA;Robot;Arm;P2;4,0;5,0;6,0\n",
           "P1,Robot,1,2,3\nP2,Robot,4,5,6\n",
           "A\tP1\t1\t2\t3\nA\tP2\t4\t5\t6\n",
           "Point,East,North,Elev\nP1,1,2,3\nP2,4,5,6\n",
           "Point,Northing [mm],Easting [mm],Height [mm]\nP1,2,1,3\nP2,5,4,6\n",
           "Point;E;N;H\nP1;1;2;3\nP2;4;5;6\n",
       }) {
    const auto measurements = read({{"points", points}, {"log", kLog}}, {}, {"mm", "deg"});
    const auto table = parseMeasurementTable(measurements.text, "r", cell.arm).measurements;
    ASSERT_EQ(table.size(), 2u) << points;
    for (int k = 0; k < 2; ++k) {
      const auto& measurement = table[static_cast<std::size_t>(k)];
      EXPECT_EQ(measurement.kind, calibration::MeasurementKind::kPosition) << points;
      ASSERT_TRUE(measurement.p_W) << points;
      const Eigen::Vector3d place = Eigen::Vector3d(1, 2, 3).array() + 3 * k;
      EXPECT_LT((*measurement.p_W - place / 1000).norm(), 1e-12) << points;
      EXPECT_EQ(measurement.point, k == 0 ? "P1" : "P2") << points;
    }
  }
}

// Points may be named by running numbers: four numbers in a row cannot be the joints of an arm with six.
TEST_F(ForeignMeasurementsTest, takesRunningNumbersForNames) {
  const Cell puma = readCell((shippedCells() / "puma.yaml").string());
  const std::string log = "Name,J1,J2,J3,J4,J5,J6\n7,1,2,3,4,5,6\n8,2,3,4,5,6,7\n";
  for (const char* points : {"7 1 2 3\n8 4 5 6\n", "A Robot 8 4 5 6\nA Robot 7 1 2 3\n"}) {
    ForeignRequest request{{parseForeignTable(points, "points"), parseForeignTable(log, "log")}, {{}, {}}, ""};
    for (const char* unit : {"mm", "deg"}) request.choice.units.emplace(findUnitWord(unit)->kind, findUnitWord(unit));
    const auto measurements = readForeign(request, puma.arm);
    EXPECT_NE(measurements.text.find("position"), std::string::npos) << points;
    EXPECT_NE(measurements.text.find("1,2,3,4,5,6,1,2,3\n"), std::string::npos) << measurements.text;
  }
}

// Measurements with unrecognised columns of numbers must be refused, not taken for touches of unknown points.
TEST_F(ForeignMeasurementsTest, NumbersThatNobodyKnowsMakeNoTouches) {
  for (const char* points : {
           "Point;HZ [gon];V [gon];Q [mm]\nP1;170,87;95,14;1315,2\nP2;118,76;124,58;1272,4\n",
           "Point,Easting,Northing,Depth\nP1,1,2,3\nP2,4,5,6\n",
           "Point,u,v,w\nP1,1,2,3\nP2,4,5,6\n",
           "A,Robot,1,1,2,3\nA,Robot,2,4,5,6\n",  // a running number and a position, or four joints
           "P1 1 2 3 0.01 0.02\nP2 4 5 6 0.01 0.02\n",
           "P1 1 2\nP2 4 5\n",
       }) {
    const std::vector<Text> texts = {{"points", points}, {"log", kLog}};
    const std::string message = refusal(texts, {}, {"mm", "deg"});
    EXPECT_NE(message.find("recognised"), std::string::npos) << points << message;
    EXPECT_NE(message.find("--column"), std::string::npos) << message;
  }
  const std::vector<Text> named = {{"points", "Point,u,v,w\nP1,1,2,3\nP2,4,5,6\n"}, {"log", kLog}};
  EXPECT_EQ(read(named, {"x_mm=u", "y_mm=v", "z_mm=w"}, {"deg"}).origins.size(), 2u);
  ForeignRequest touches{
      {parseForeignTable(named[0].text, "points"), parseForeignTable(kLog, "log")}, {{}, {}}, "touch"};
  touches.choice.units.emplace(UnitKind::kAngle, findUnitWord("deg"));
  EXPECT_EQ(readForeign(touches, cell.arm).origins.size(), 2u);
  // The positions of holes are known, so measurements at holes must be touches, even if the table has an unknown
  // column.
  EXPECT_EQ(read({{"log", "Hole,J1,J2,J3,J4,Probe\nR1C1,10,45,-35,12,3\n"}}, {}, {"deg"}).origins.size(), 1u);
}

TEST_F(ForeignMeasurementsTest, AFileOfWhichNothingIsKnownIsRefused) {
  const std::string log = "Name,A1,A2,A3,A4,X,Y,Z\nP1,10,45,-35,12,1,2,3\n";
  EXPECT_NE(refusal({{"log", log}, {"other", "a,b\n1,2\n"}}, {}, {"mm", "deg"}).find("other"), std::string::npos);
}

TEST_F(ForeignMeasurementsTest, JointsMayBeCountedFromZero) {
  const auto measurements =
      read({{"log.csv", "q3,q2,q1,q0,x,y,z\n12,-35,45,10,1,2,3\n12,-35,45,20,4,5,6\n"}}, {}, {"mm", "deg"});
  EXPECT_NE(measurements.text.find("\n1,position,10,45,-35,12,1,2,3\n"), std::string::npos) << measurements.text;
  // For four joints, headings q1 to q3 must be refused: they are numbered neither from zero nor from one.
  EXPECT_NE(refusal({{"log.csv", "q1,q2,q3,x,y,z\n1,2,3,4,5,6\n1,2,3,4,5,6\n"}}, {}, {"mm", "deg"}), "");
}

TEST_F(ForeignMeasurementsTest, TablesWithOtherNamesAreNotMatchedByOrder) {
  const std::string log = "Name,A1,A2,A3,A4\nP24,10,45,-35,12\nP23,20,45,-35,12\n";
  EXPECT_NE(refusal({{"log.csv", log}, {"points.csv", "Name,X,Y,Z\np1,1,2,3\np2,4,5,6\n"}}, {}, {"mm", "deg"})
                .find("same names"),
            std::string::npos);
  const auto numbered = read({{"log.csv", log}, {"points.csv", "Name,X,Y,Z\n1,1,2,3\n2,4,5,6\n"}}, {}, {"mm", "deg"});
  EXPECT_NE(numbered.text.find("12,1,2,3"), std::string::npos) << numbered.text;
}

TEST_F(ForeignMeasurementsTest, ClockTimesAreSecondsFromTheFirst) {
  const auto with = [&](const std::string& first, const std::string& second) {
    return read({{"log.csv", "J1,J2,J3,J4,x,y,z,Timestamp\n10,45,-35,12,1,2,3," + first + "\n10,45,-35,12,1,2,3," +
                                 second + "\n"}},
                {}, {"mm", "deg"});
  };
  EXPECT_NE(with("2026-11-01 23:59:58.5", "2026-11-02T00:00:03").text.find(",4.5\n"), std::string::npos);
  EXPECT_NE(with("10:00:00", "10:01:00").text.find(",60\n"), std::string::npos);
  const auto unknown = with("about ten", "later");
  EXPECT_EQ(unknown.text.find("time"), std::string::npos) << unknown.text;
  EXPECT_NE(unknown.left_out.at(0).find("Timestamp"), std::string::npos);
  EXPECT_NE(messageOf([&] { (void)with("10:00:00", "noon"); }).find("noon"), std::string::npos);
}

// A time without a date that is earlier than the previous one by half a day or more must belong to the next day; every
// midnight must give one remark.
TEST_F(ForeignMeasurementsTest, ClocksPassMidnight) {
  struct Shift {
    std::vector<std::string> clock;
    std::vector<double> seconds;
    std::size_t midnights;
  };
  for (const Shift& shift :
       {Shift{{"23:50:00", "23:59:59", "00:00:01", "00:14:00"}, {0, 599, 601, 1440}, 1},
        Shift{{"18:00:00", "06:00:00", "18:00:00", "05:00:00"}, {0, 43200, 86400, 126000}, 2},
        Shift{{"10:00:00", "09:30:00", "11:00:00"}, {0, -1800, 3600}, 0},  // the second row is earlier than the first
        Shift{{"00:10:00", "23:50:00"}, {0, 85200}, 0}, Shift{{"", "23:50:00", "", "00:10:00"}, {NAN, 0, NAN, 1200}, 1},
        Shift{{"2026-11-02 00:00:05", "2026-11-01 00:00:00"}, {0, -86405}, 0}}) {
    std::string log = "J1,J2,J3,J4,x,y,z,Time\n";
    if (shift.clock[0].empty()) log = "J1,J2,J3,J4,x,y,z,time_s\n";
    for (const auto& clock : shift.clock) log += "10,45,-35,12,1,2,3," + clock + "\n";
    const auto measurements = read({{"log.csv", log}}, {}, {"mm", "deg"});
    const auto table = parseMeasurementTable(measurements.text, "r", cell.arm).measurements;
    ASSERT_EQ(table.size(), shift.seconds.size());
    for (std::size_t k = 0; k < table.size(); ++k) {
      if (std::isnan(shift.seconds[k]))
        EXPECT_TRUE(std::isnan(table[k].conditions[deflection::Condition::kTime])) << log;
      else
        EXPECT_EQ(table[k].conditions[deflection::Condition::kTime], shift.seconds[k]) << log;
    }
    const auto said = std::count_if(measurements.taken.begin(), measurements.taken.end(),
                                    [](const std::string& line) { return line.find("midnight") != std::string::npos; });
    EXPECT_EQ(static_cast<std::size_t>(said), shift.midnights) << log;
  }
}

// Dates must be refused if both orders of day and month give valid but different times, unless the user chooses.
TEST_F(ForeignMeasurementsTest, DatesAreReadWhereTheyAreClear) {
  struct Dates {
    std::vector<std::string> clock;
    double seconds;  ///< from the first to the last time [s]; NaN if ambiguous
    std::string order = {};
  };
  for (const Dates& dates : {
           Dates{{"11/23/2024 11:50:00 AM", "11/24/2024 12:10:00 PM"}, 86400 + 1200},
           Dates{{"23/11/2024 23:50:00", "1/12/2024 00:10"}, 7 * 86400 + 1200},
           Dates{{"3.5.2024 11:50:00", "4.5.2024 11:50:00"}, 86400},
           Dates{{"2024/05/03 11:59:00 PM", "2024/05/04 12:01:00 AM"}, 120},
           Dates{{"3/5/2024 11:50:00 AM", "3/5/2024 1:50:00 PM"}, 7200},  // the same day in both orders
           Dates{{"5/5/2024 11:50", "6/6/2024 11:50"}, 32 * 86400},       // the same days in both orders
           Dates{{"3/5/2024 11:50:00 AM", "4/5/2024 11:50:00 AM"}, NAN},
           Dates{{"3/5/2024 11:50:00 AM", "4/5/2024 11:50:00 AM"}, 86400, "day-first"},
           Dates{{"3/5/2024 11:50:00 AM", "4/5/2024 11:50:00 AM"}, 31 * 86400, "month-first"},
           Dates{{"11:50:00 PM", "12:10:00 AM"}, 1200},
       }) {
    std::string log = "J1 [deg],J2 [deg],J3 [deg],J4 [deg],x [mm],y [mm],z [mm],Timestamp\n";
    for (const auto& clock : dates.clock) log += "10,45,-35,12,1,2,3," + clock + "\n";
    ForeignRequest request{{parseForeignTable(log, "log")}, {}, ""};
    request.choice.dates = dates.order;
    if (std::isnan(dates.seconds)) {
      const std::string message = messageOf([&] { (void)readForeign(request, cell.arm); });
      EXPECT_NE(message.find("--dates day-first or --dates month-first"), std::string::npos) << message;
      continue;
    }
    const auto table = parseMeasurementTable(readForeign(request, cell.arm).text, "r", cell.arm).measurements;
    const auto timeOf = [](const auto& measurement) { return measurement.conditions[deflection::Condition::kTime]; };
    EXPECT_EQ(timeOf(table.back()) - timeOf(table.front()), dates.seconds) << log;
  }
}

TEST_F(ForeignMeasurementsTest, JointsMayBePulses) {
  const std::string log = "J1,J2,J3,J4,X,Y,Z\n100000,-50000,20000,0,1,2,3\n-300,50,7,9,4,5,6\n";
  EXPECT_NE(refusal({{"log", log}}, {}, {"mm", "deg"}).find("pulse"), std::string::npos);
  const auto measurements =
      read({{"log", log}}, {"theta1_deg=J1*0.0001", "theta2_deg=J2*-0.0001", "theta3_deg=log:J3/1000", "theta4=J4*2"},
           {"mm", "deg"});
  EXPECT_NE(measurements.text.find(",10,5,20,0,1,2,3\n"), std::string::npos) << measurements.text;
  EXPECT_NE(measurements.text.find(",-0.03,-0.005,0.007,18,4,5,6\n"), std::string::npos) << measurements.text;
  // Columns whose headings state pulses must never be read as angles, whatever the values.
  const std::string named = "J1 [pulse],J2_deg,J3_deg,J4_deg,X,Y,Z\n3,45,-35,12,1,2,3\n";
  EXPECT_NE(refusal({{"log", named}}, {}, {"mm", "deg"}).find("pulses"), std::string::npos);
  EXPECT_EQ(read({{"log", named}}, {"theta1_deg=J1 [pulse]*0.5"}, {"mm"}).origins.size(), 1u);
  EXPECT_NE(refusal({{"log", log}}, {"theta1_deg=J1*0"}, {"mm", "deg"}), "");
  EXPECT_NE(refusal({{"log", log}}, {"point=J1*2"}, {"mm", "deg"}), "");
  // Whole degrees must not be mistaken for pulses.
  EXPECT_EQ(read({{"log", "J1,J2,J3,J4,X,Y,Z\n10,45,-35,720,1,2,3\n"}}, {}, {"mm", "deg"}).origins.size(), 1u);
}

// Letters and names of robot controllers must be read as joints; the T of Yaskawa is the last joint, not a time.
TEST_F(ForeignMeasurementsTest, JointsMayBeLetters) {
  const Cell puma = readCell((shippedCells() / "puma.yaml").string());
  for (const char* log : {"Name,S,L,U,R,B,T,X,Y,Z\nP1,1,2,3,4,5,6,7,8,9\n", "T,B,R,U,L,S,X,Y,Z\n6,5,4,3,2,1,7,8,9\n",
                          "Base,Shoulder,Elbow,Wrist 1,Wrist 2,Wrist 3,X,Y,Z\n1,2,3,4,5,6,7,8,9\n"}) {
    ForeignRequest request{{parseForeignTable(log, "log")}, {}, ""};
    for (const char* unit : {"mm", "deg"}) request.choice.units.emplace(findUnitWord(unit)->kind, findUnitWord(unit));
    const auto measurements = readForeign(request, puma.arm);
    EXPECT_NE(measurements.text.find("1,2,3,4,5,6,7,8,9\n"), std::string::npos) << measurements.text;
  }
  const auto timed = read({{"log", "J1,J2,J3,J4,X,Y,Z,T\n1,2,3,4,7,8,9,10:00:00\n"}}, {}, {"mm", "deg"});
  EXPECT_NE(timed.text.find("time_s"), std::string::npos) << timed.text;
}

// Lines above the table must give units to columns that state none; --units must not contradict such a line.
TEST_F(ForeignMeasurementsTest, LinesAboveTheRowsStateUnits) {
  for (const char* line : {"// Units: Inches", "# units = in", "Length unit: inch, angle: rad", "Units: in and deg"}) {
    const std::string points = std::string(line) + "\n// X Y Z\nP1 1 2 3\nP2 4 5 6\n";
    const auto measurements = read({{"points", points}, {"log", kLog}}, {}, {"deg"});
    EXPECT_NE(measurements.text.find("x_in"), std::string::npos) << measurements.text;
    const std::string message = refusal({{"points", points}, {"log", kLog}}, {}, {"mm", "deg"});
    EXPECT_NE(message.find("states the unit in"), std::string::npos) << message;
    EXPECT_NE(message.find("mm"), std::string::npos) << message;
    EXPECT_EQ(read({{"points", points}, {"log", kLog}}, {}, {"in", "deg"}).origins.size(), 2u);
  }
  for (const char* line : {"// Units: as in the drawing", "// United: mm", "// Units mm", "// Units: 2 mm"}) {
    const std::string points = std::string(line) + "\nP1 1 2 3\nP2 4 5 6\n";
    EXPECT_NE(refusal({{"points", points}, {"log", kLog}}, {}, {"deg"}).find("the unit of"), std::string::npos) << line;
  }
  const std::string both = "// Units: mm\n// Units: Inches\nP1 1 2 3\nP2 4 5 6\n";
  EXPECT_NE(refusal({{"points", both}, {"log", kLog}}, {}, {"deg"}).find("state different units"), std::string::npos);
  // A unit in a heading must take precedence over a line above the table.
  const std::string own = "// Units: mm\nName,X [in],Y [in],Z [in]\nP1,1,2,3\nP2,4,5,6\n";
  EXPECT_NE(read({{"points", own}, {"log", kLog}}, {}, {"deg"}).text.find("x_in"), std::string::npos);
}

TEST_F(ForeignMeasurementsTest, LostPointsAreLeftOut) {
  const auto measurements =
      read({{"log.csv", "J1,J2,J3,J4,x,y,z\n10,45,-35,12,1,2,3\n20,45,-35,12,,,\n30,45,-35,12,-,N/A,\n"}}, {},
           {"mm", "deg"});
  EXPECT_EQ(measurements.origins, (std::vector<std::string>{"log.csv:2"}));
  EXPECT_EQ(measurements.left_out, (std::vector<std::string>{"2 rows without coordinates"}));
}

}  // namespace
}  // namespace tubeplan::app
