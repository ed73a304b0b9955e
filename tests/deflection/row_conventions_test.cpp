#include "deflection/row_conventions.hpp"

#include <gtest/gtest.h>

#include "deflection/parameters.hpp"
#include "tests/deflection/drawn_rows.hpp"

namespace tubeplan::deflection {
namespace {

using testing::DrawnRows;

TEST(RowConventions, writeTheSameArm) {
  DrawnRows draw(1);
  for (int n = 0; n < 600; ++n) {
    Arm arm = draw.arm(2 + n % 7);
    for (auto& row : arm.rows)
      if (n % 2) row.weight.lumps.push_back({3, draw.vector(0.3)});
    for (const auto convention : {RowConvention::kModified, RowConvention::kStandard, RowConvention::kOrigin}) {
      const ConvertedArm written = convertRows(arm, convention);
      ASSERT_TRUE(written.is_converted) << written.row << ": " << written.reason;
      for (int k = 0; k < 3; ++k) EXPECT_LE(testing::formDifference(arm, written.arm, draw.readings(arm)), 1e-12) << n;
      EXPECT_LT(testing::longestRow(written.arm), 12) << n;
      EXPECT_NEAR(reachOf(written.arm), reachOf(arm), 1e-8 * reachOf(arm));
    }
  }
}

TEST(RowConventions, readWhatTheStandardTableSays) {
  DrawnRows draw(2);
  for (int n = 0; n < 200; ++n) {
    const Arm arm = draw.arm(2 + n % 7);
    const Arm standard = convertRows(arm, RowConvention::kStandard).arm;
    ASSERT_TRUE(isStandard(standard.rows));
    Arm again = standard;
    for (std::size_t k = 0; k < again.rows.size(); ++k) {
      again.rows[k].placement = standardNumbers(standard.rows, k);
      again.rows[k].placed_by.reset();
    }
    readAsStandard(again.rows);
    EXPECT_EQ(again.rows.size(), standard.rows.size());
    EXPECT_LE(testing::formDifference(arm, again, draw.readings(arm)), 1e-12) << n;
  }
}

/// Returns the pose from a standard Denavit-Hartenberg row to the next, as the product of its rotations and
/// translations.
Eigen::Isometry3d standardStep(const DenavitHartenberg<double>& dh, double reading) {
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  X.rotate(Eigen::AngleAxisd(dh.theta + reading, Eigen::Vector3d::UnitZ()));
  X.translate(Eigen::Vector3d(0, 0, dh.d));
  X.translate(Eigen::Vector3d(dh.a, 0, 0));
  X.rotate(Eigen::AngleAxisd(dh.alpha, Eigen::Vector3d::UnitX()));
  X.rotate(Eigen::AngleAxisd(dh.beta, Eigen::Vector3d::UnitY()));
  return X;
}

TEST(RowConventions, standardTablesMeanWhatTextbooksMean) {
  DrawnRows draw(3);
  for (int n = 0; n < 100; ++n) {
    Arm arm = draw.arm(6, true);
    std::vector<DenavitHartenberg<double>> table;
    for (auto& row : arm.rows) {
      table.push_back({draw.between(-3, 3), draw.between(-1, 1), draw.between(-1, 1), draw.between(-3, 3),
                       n % 2 ? draw.between(-0.1, 0.1) : 0});
      row.placement = table.back();
      row.joint.offset = 0;
    }
    if (n % 4 == 0) {
      table.back().alpha = table.back().a = table.back().beta = 0;
      arm.rows.back().placement = table.back();
    }
    readAsStandard(arm.rows);
    EXPECT_EQ(arm.rows.size(), n % 4 == 0 ? 6u : 7u);
    const Eigen::VectorXd q = draw.readings(arm);
    Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
    for (std::size_t k = 0; k < table.size(); ++k) X = X * standardStep(table[k], q[static_cast<Eigen::Index>(k)]);
    EXPECT_LE((rigidFramesOf<double>(arm, q).tip - X * arm.p_LT).norm(), 1e-12);
  }
}

TEST(RowConventions, parametersStandWhereTheStandardFileHasThem) {
  DrawnRows draw(4);
  Arm arm = draw.arm(3, true);
  for (auto& row : arm.rows) row.placement = DenavitHartenberg<double>{0.5, 0.2, 0.1, 0.3};
  std::get<DenavitHartenberg<double>>(arm.rows[0].placement).a = 0.7;
  readAsStandard(arm.rows);
  const auto first = findParameter(arm, "row0.dh.a");
  ASSERT_TRUE(first.has_value());
  EXPECT_EQ(first->value, 0.7);
  EXPECT_EQ(first->path.row, 1);
  EXPECT_EQ(findParameter(arm, "row0.dh.d")->path.row, 0);
  EXPECT_EQ(findParameter(arm, "row2.dh.alpha")->path.row, 3);
  EXPECT_EQ(findParameter(arm, "row0.axis.alpha")->path.row, 0);
  int placements = 0, of_first_axis = 0;
  for (const auto& parameter : parametersOf(arm)) {
    EXPECT_FALSE(parameter.name.starts_with(".")) << parameter.name;
    EXPECT_FALSE(parameter.name.starts_with("row2-end")) << parameter.name;
    placements += parameter.name.find(".dh.") != std::string::npos;
    of_first_axis += parameter.name.starts_with("row0.axis.");
  }
  EXPECT_EQ(placements, 3 * 4);  // alpha, a, beta and d of each row; the joint's offset replaces theta
  EXPECT_EQ(of_first_axis, 4);   // alpha, a, beta and b of the first axis
  const Arm copy = castArm<double>(castArm<Dual>(arm));
  EXPECT_TRUE(findParameter(copy, "row2.dh.alpha").has_value());
}

struct HeldRow {
  const char* what;
  void (*hold)(Row<double>&);
};

TEST(RowConventions, aRowThatWouldBeAnotherIsRefused) {
  const HeldRow held[] = {
      {"beam",
       [](Row<double>& row) {
         row.beam = Beam<double>{.E = 7e10, .I = {1e-6, 1e-6, 1e-6}};
       }},
      {"weight", [](Row<double>& row) { row.weight.distributed = 10; }},
      {"joint_stiffness", [](Row<double>& row) { row.joint_stiffness.x() = 1e5; }},
  };
  for (const auto& [what, hold] : held) {
    DrawnRows draw(5);
    Arm arm = draw.arm(4, true);
    hold(arm.rows[1]);
    const ConvertedArm refused = convertRows(arm, RowConvention::kStandard);
    EXPECT_FALSE(refused.is_converted) << what;
    EXPECT_NE(refused.reason.find(what), std::string::npos) << refused.reason;
    EXPECT_TRUE(convertRows(arm, RowConvention::kOrigin).is_converted);
  }
}

TEST(RowConventions, followersAndSideChainsGoWithTheirRows) {
  DrawnRows draw(6);
  Arm arm = draw.arm(4, true);
  arm.rows[2].joint = {.name = "linked", .type = JointType::kPassive, .follows = {{1, -0.5}}};
  const ConvertedArm written = convertRows(arm, RowConvention::kStandard);
  ASSERT_TRUE(written.is_converted) << written.reason;
  ASSERT_EQ(written.arm.rows.size(), 5u);
  EXPECT_EQ(written.arm.rows[3].joint.follows.at(0).row, 2);
  for (int k = 0; k < 5; ++k) EXPECT_LE(testing::formDifference(arm, written.arm, draw.readings(arm)), 1e-12);
}

}  // namespace
}  // namespace tubeplan::deflection
