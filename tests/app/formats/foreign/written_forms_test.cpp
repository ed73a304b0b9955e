// Tests that every form of the table, written by independent code, is read back as the same orientation or point.
#include "app/formats/foreign/written_forms.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <set>

#include "app/formats/cell/cell_reader.hpp"
#include "app/formats/foreign/foreign_heading.hpp"
#include "app/formats/foreign/foreign_measurements.hpp"
#include "app/formats/measurements/measurements_reader.hpp"
#include "deflection/rotation.hpp"
#include "tests/app/test_files.hpp"

namespace tubeplan::app {
namespace {

using std::numbers::pi;
using FormWriter = std::vector<double> (*)(const Eigen::Matrix3d&);

/// Returns angles about three axes that move with the preceding rotations. If the first and third axes differ, the
/// middle angle is within pi / 2.
std::vector<double> eulerOf(const Eigen::Matrix3d& R, int first, int second, int third) {
  Eigen::Vector3d angles = R.eulerAngles(first, second, third);
  const bool is_beyond = std::abs(angles[1]) > pi / 2;
  if (first != third && is_beyond) angles = {angles[0] + pi, (angles[1] > 0 ? pi : -pi) - angles[1], angles[2] + pi};
  for (double& angle : angles) angle = std::remainder(angle, 2 * pi);
  return {angles[0], angles[1], angles[2]};
}

const std::map<std::string, FormWriter>& formWriters() {
  static const std::map<std::string, FormWriter> kWriters{
      {"fixed-angles",
       [](const Eigen::Matrix3d& R) {
         const auto zyx = eulerOf(R, 2, 1, 0);
         return std::vector<double>{zyx[2], zyx[1], zyx[0]};
       }},
      {"euler-zyx", [](const Eigen::Matrix3d& R) { return eulerOf(R, 2, 1, 0); }},
      {"euler-xyz", [](const Eigen::Matrix3d& R) { return eulerOf(R, 0, 1, 2); }},
      {"euler-zyz", [](const Eigen::Matrix3d& R) { return eulerOf(R, 2, 1, 2); }},
      {"rotation-vector",
       [](const Eigen::Matrix3d& R) {
         const Eigen::AngleAxisd turn(R);
         const Eigen::Vector3d vector = turn.angle() * turn.axis();
         return std::vector<double>{vector.x(), vector.y(), vector.z()};
       }},
      {"quaternion", [](const Eigen::Matrix3d& R) {
         const Eigen::Quaterniond q(R);
         return std::vector<double>{q.w(), q.x(), q.y(), q.z()};
       }}};
  return kWriters;
}

/// Returns random orientations, and orientations whose angles are not unique.
std::vector<Eigen::Matrix3d> someTurns() {
  std::vector<Eigen::Matrix3d> turns{Eigen::Matrix3d::Identity()};
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  for (int k = 0; k < 200; ++k)
    turns.push_back(Eigen::Quaterniond(normal(random), normal(random), normal(random), normal(random))
                        .normalized()
                        .toRotationMatrix());
  for (const double middle : {pi / 2, -pi / 2, pi, pi / 2 - 1e-9, 1e-9})
    for (const double first : {0.0, 0.7, -2.9, pi})
      for (const Eigen::Vector3d& axis : {Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0, 1, 0), Eigen::Vector3d(0, 0, 1)})
        turns.push_back((Eigen::AngleAxisd(first, Eigen::Vector3d::UnitZ()) * Eigen::AngleAxisd(middle, axis) *
                         Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitX()))
                            .toRotationMatrix());
  return turns;
}

class WrittenFormsTest : public ::testing::Test {
 protected:
  const Cell cell = readCell((shippedCells() / "bench.yaml").string());  // joints theta1 to theta4

  [[nodiscard]] ForeignMeasurements read(const std::string& text, ColumnChoice choice, const std::string& kind) const {
    return readForeign({{parseForeignTable(text, "t")}, std::move(choice), kind}, cell.arm);
  }
  [[nodiscard]] static ColumnChoice inUnits(const char* angle) {
    ColumnChoice choice;
    for (const char* unit : {"mm", angle}) choice.units.emplace(findUnitWord(unit)->kind, findUnitWord(unit));
    return choice;
  }
  [[nodiscard]] std::string refusal(const std::string& text, const ColumnChoice& choice,
                                    const std::string& kind) const {
    return messageOf([&] { (void)read(text, choice, kind); });
  }
};

const char* const kJointHeadings = "J1 [deg],J2 [deg],J3 [deg],J4 [deg]";

std::string tableOf(const std::vector<std::string>& names, const std::vector<std::vector<double>>& rows) {
  std::string text = kJointHeadings;
  for (const auto& name : names) text += "," + name;
  for (const auto& row : rows) {
    text += "\n10,45,-35,12";
    for (const double number : row) text += fmt::format(",{:.17g}", number);
  }
  return text + "\n";
}

TEST_F(WrittenFormsTest, EveryTurnComesBackAsItWas) {
  const auto turns = someTurns();
  for (const auto& form : writtenForms()) {
    if (form.stated != Stated::kTurn) continue;
    ASSERT_TRUE(formWriters().contains(form.name)) << form.name;
    const FormWriter write = formWriters().at(form.name);
    for (const auto& headings : form.headings)
      for (const char* unit : {"deg", "rad"}) {
        const double factor = form.numbers.front().unit ? findUnitWord(unit)->factor : 1;
        std::vector<std::vector<double>> rows;
        for (const auto& turn : turns) {
          rows.push_back(write(turn));
          for (double& number : rows.back()) number /= factor;
        }
        ColumnChoice choice = inUnits(unit);
        choice.orientation = form.name;
        const auto measurements = read(tableOf(headings.names, rows), choice, "orientation");
        const auto table = parseMeasurementTable(measurements.text, "r", cell.arm).measurements;
        ASSERT_EQ(table.size(), turns.size());
        for (std::size_t k = 0; k < turns.size(); ++k) {
          const Eigen::Matrix3d back = deflection::rotationFromFixedAngles<double>(table[k].kind_values);
          EXPECT_LT((back - turns[k]).cwiseAbs().maxCoeff(), 1e-9) << form.name << " " << unit << " row " << k;
        }
      }
  }
}

// The columns of a form may be chosen one by one under headings without meaning; a missing one must be refused.
TEST_F(WrittenFormsTest, NumbersMayBeChosenOneByOne) {
  const Eigen::Matrix3d turn = someTurns()[5];
  for (const auto& form : writtenForms()) {
    if (form.stated != Stated::kTurn) continue;
    ColumnChoice choice = inUnits("rad");
    std::vector<std::string> names;
    for (const auto& number : form.numbers) {
      names.push_back(fmt::format("U{}", names.size() + 1));
      choice.columns.push_back(
          fmt::format("{}.{}{}={}", form.name, number.name, number.unit ? "_rad" : "", names.back()));
    }
    const std::string text = tableOf(names, {formWriters().at(form.name)(turn)});
    const auto table = parseMeasurementTable(read(text, choice, "").text, "r", cell.arm).measurements;
    ASSERT_EQ(table.size(), 1u) << form.name;
    EXPECT_EQ(table[0].kind, calibration::MeasurementKind::kOrientation);
    EXPECT_LT((deflection::rotationFromFixedAngles<double>(table[0].kind_values) - turn).cwiseAbs().maxCoeff(), 1e-9);
    choice.columns.pop_back();
    EXPECT_NE(refusal(text, choice, "").find("numbers from one table"), std::string::npos) << form.name;
  }
}

// Headings shared by two forms, with numbers valid in both, must be refused with the names and options of both forms.
TEST_F(WrittenFormsTest, WhatMayBeTwoTurnsIsNotGuessed) {
  std::map<std::vector<std::string>, std::set<std::string>> meanings;
  for (const auto& form : writtenForms())
    if (form.stated == Stated::kTurn)
      for (const auto& headings : form.headings) meanings[headings.names].insert(form.name);
  int several = 0;
  for (const auto& [names, forms] : meanings) {
    if (names.size() != 3) continue;
    const std::string text = tableOf(names, {{20, 30, 40}, {-10, 50, 70}});
    if (forms.size() == 1) {
      EXPECT_EQ(read(text, inUnits("deg"), "orientation").origins.size(), 2u) << names.front();
      continue;
    }
    ++several;
    const std::string message = refusal(text, inUnits("deg"), "orientation");
    for (const auto& form : forms)
      EXPECT_NE(message.find("--orientation " + form), std::string::npos) << names.front() << ": " << message;
  }
  EXPECT_GE(several, 2);
}

TEST_F(WrittenFormsTest, NumbersAndNeighboursDecide) {
  const auto as = [&](const std::string& text, const std::string& form) {
    const auto measurements = read(text, inUnits("deg"), "orientation");
    const std::string& said =
        *std::ranges::find_if(measurements.taken, [](const auto& line) { return line.starts_with("roll"); });
    EXPECT_NE(said.find("as " + form), std::string::npos) << said;
  };
  // No controller writes Euler angles with a middle angle beyond 90 deg, so these numbers are a rotation vector.
  as(tableOf({"Rx", "Ry", "Rz"}, {{20, 30, 40}, {10, 120, 20}}), "rotation-vector");
  // A rotation about a single axis is the same in all forms, so the first form is taken.
  as(tableOf({"Rx", "Ry", "Rz"}, {{0, 0, 40}, {0, 0, 170}}), "fixed-angles");
  // A rotation vector cannot be longer than half a turn, so only two kinds of angles must be offered.
  const std::string message = refusal(tableOf({"Rx", "Ry", "Rz"}, {{170, 30, 160}}), inUnits("deg"), "orientation");
  EXPECT_EQ(message.find("--orientation rotation-vector"), std::string::npos) << message;
  EXPECT_NE(message.find("--orientation euler-xyz"), std::string::npos) << message;
  // Joint names of KUKA with A, B, C show that these are Euler angles; joint names of the Universal Robots pendant with
  // Rx, Ry, Rz show that these are a rotation vector.
  as("A1 [deg],A2 [deg],A3 [deg],A4 [deg],A,B,C\n10,45,-35,12,20,30,40\n", "euler-zyx");
  as(tableOf({"Wrist 1", "Rx", "Ry", "Rz"}, {{5, 20, 30, 40}}), "rotation-vector");
  // Columns q1 to q4 are a quaternion if there are other joint columns; alone they are joints, so no orientation is
  // found.
  as(tableOf({"q1", "q2", "q3", "q4"}, {{0.5, 0.5, 0.5, 0.5}}), "quaternion");
  EXPECT_NE(refusal("q1,q2,q3,q4\n0.5,0.5,0.5,0.5\n", inUnits("rad"), "orientation").find("orientation"),
            std::string::npos);
  // Roll, pitch and yaw must take precedence over all other forms.
  const auto own = read(tableOf({"roll_deg", "pitch_deg", "yaw_deg", "Rx", "Ry", "Rz"}, {{1, 2, 3, 4, 5, 6}}),
                        inUnits("deg"), "orientation");
  EXPECT_NE(own.text.find(",1,2,3\n"), std::string::npos) << own.text;
}

TEST_F(WrittenFormsTest, QuaternionsAreOfLengthOne) {
  const auto angleOf = [&](const std::vector<double>& numbers) {
    const auto measurements = read(tableOf({"qw", "qx", "qy", "qz"}, {numbers}), inUnits("deg"), "orientation");
    return parseMeasurementTable(measurements.text, "r", cell.arm).measurements.at(0).kind_values[0];
  };
  EXPECT_NEAR(angleOf({0.7071, 0.7071, 0, 0}), pi / 2, 1e-9);
  EXPECT_NEAR(angleOf({0.708, 0.708, 0, 0}), pi / 2, 1e-9);  // rounded to three decimals
  const std::string message =
      refusal(tableOf({"qw", "qx", "qy", "qz"}, {{1, 0, 0, 0}, {0.9, 0.1, 0, 0}}), inUnits("deg"), "orientation");
  EXPECT_NE(message.find("t:3"), std::string::npos) << message;
  EXPECT_NE(message.find("quaternion"), std::string::npos) << message;
}

TEST_F(WrittenFormsTest, TheOrderOfAQuaternionIsSaidWhereItsHeadingsDoNot) {
  const auto saysOrder = [&](const std::vector<std::string>& headings) {
    const auto taken = read(tableOf(headings, {{0.5, 0.5, 0.5, 0.5}}), inUnits("deg"), "orientation").taken;
    return std::ranges::any_of(taken, [](const auto& line) { return line.find("w first") != std::string::npos; });
  };
  EXPECT_TRUE(saysOrder({"q1", "q2", "q3", "q4"}));
  EXPECT_FALSE(saysOrder({"qw", "qx", "qy", "qz"}));
}

TEST_F(WrittenFormsTest, PosesHaveBoth) {
  const std::string text = tableOf({"X", "Y", "Z", "W", "P", "R"}, {{1, 2, 3, 20, 30, 40}});
  const auto pose = parseMeasurementTable(read(text, inUnits("deg"), "pose").text, "r", cell.arm).measurements.at(0);
  EXPECT_EQ(pose.kind, calibration::MeasurementKind::kPose);
  EXPECT_LT((*pose.p_W - Eigen::Vector3d(0.001, 0.002, 0.003)).norm(), 1e-12);
  EXPECT_LT((pose.kind_values - Eigen::Vector3d(20, 30, 40) * pi / 180).norm(), 1e-9);
  // Without --kind the measurements must be positions, and a remark must say that the orientation is ignored.
  const auto position = read(text, inUnits("deg"), "");
  EXPECT_NE(position.text.find("position"), std::string::npos);
  EXPECT_TRUE(std::ranges::any_of(position.left_out,
                                  [](const auto& line) { return line.find("--kind pose") != std::string::npos; }));
  EXPECT_NE(refusal(tableOf({"X", "Y", "Z"}, {{1, 2, 3}}), inUnits("deg"), "pose").find("euler-zyx"),
            std::string::npos);
}

// If the rows state their kinds, an orientation must be read only from the row of kind pose.
TEST_F(WrittenFormsTest, RowsMayStateTheirKinds) {
  const std::string text =
      "kind,J1 [deg],J2 [deg],J3 [deg],J4 [deg],X,Y,Z,W,P,R\n"
      "pose,10,45,-35,12,1,2,3,20,30,40\nposition,10,45,-35,12,1,2,3,,,\n";
  const auto table = parseMeasurementTable(read(text, inUnits("deg"), "").text, "r", cell.arm).measurements;
  ASSERT_EQ(table.size(), 2u);
  EXPECT_LT((table[0].kind_values - Eigen::Vector3d(20, 30, 40) * pi / 180).norm(), 1e-9);
}

TEST_F(WrittenFormsTest, PolarPointsBecomePlaces) {
  const Eigen::Vector3d place(0.3, -0.4, 0.25);  // [m]
  const double distance = place.norm(), zenith = std::acos(place.z() / distance);
  for (const auto& [form, horizontal] : {std::pair{"polar", std::atan2(place.y(), place.x())},
                                         std::pair{"polar-clockwise", std::atan2(place.x(), place.y())}})
    for (const auto& [unit, factor] : {std::pair{"gon", pi / 200}, std::pair{"deg", pi / 180}, std::pair{"rad", 1.0}})
      for (const char* distance_name : {"SD [mm]", "Slope distance [mm]", "D [mm]"}) {
        const std::string text = tableOf({fmt::format("Hz [{}]", unit), fmt::format("V [{}]", unit), distance_name},
                                         {{horizontal / factor, zenith / factor, 1000 * distance}, {1, 1, 900}});
        ColumnChoice choice;
        const std::string message = refusal(text, choice, "");
        EXPECT_NE(message.find("--points polar or --points polar-clockwise"), std::string::npos) << message;
        choice.points = form;
        const auto measurement = parseMeasurementTable(read(text, choice, "").text, "r", cell.arm).measurements.at(0);
        EXPECT_EQ(measurement.kind, calibration::MeasurementKind::kPosition);
        EXPECT_LT((*measurement.p_W - place).norm(), 1e-11) << form << " " << unit;
      }
  ColumnChoice choice = inUnits("gon");
  choice.points = "polar";
  EXPECT_NE(refusal(tableOf({"Hz", "V", "SD"}, {{1, 2, -3}}), choice, "").find("above zero"), std::string::npos);
  EXPECT_NE(refusal(tableOf({"u", "v", "w"}, {{1, 2, 3}}), choice, "").find("polar.horizontal"), std::string::npos);
  EXPECT_EQ(read(tableOf({"Hz", "V", "SD"}, {{1, 2, 3}, {NAN, NAN, NAN}}), choice, "").origins.size(), 1u);
}

}  // namespace
}  // namespace tubeplan::app
