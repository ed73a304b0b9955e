#include "app/formats/measurements/measurements_reader.hpp"

#include <cmath>
#include <numbers>

#include "app/formats/cell/cell_reader.hpp"
#include "app/formats/measurements/measurement_columns.hpp"
#include "app/formats/measurements/measurement_input.hpp"
#include "app/formats/measurements/measurements_writer.hpp"
#include "app/formats/yaml/strict_yaml.hpp"
#include "calibration/measurements/measurement_kinds.hpp"
#include "tests/app/test_files.hpp"
#include "tests/units.hpp"

namespace tubeplan::app {
namespace {

using calibration::MeasurementKind;

const char* const kHeader =
    "id,kind,point,load_lbf,theta1_deg,theta2_deg,theta3_deg,theta4_deg,x_in,y_in,z_in,sigma_in\n";

class MeasurementsReader : public ::testing::Test {
 protected:
  Cell cell = readCell((shippedCells() / "mockup.yaml").string());

  [[nodiscard]] auto read(const std::string& text) const {
    return parseMeasurements(text, "m.csv", cell.arm, &*cell.sheet);
  }
  [[nodiscard]] std::string refusal(const std::string& text) const {
    return messageOf([&] { (void)read(text); });
  }
};

TEST_F(MeasurementsReader, readsAPosition) {
  const auto measurements = read(std::string(kHeader) + "a,position,P1,20,10,90,-20,5,1,2,3,0.003\n");
  ASSERT_EQ(measurements.size(), 1u);
  const auto& m = measurements.front();
  EXPECT_EQ(m.kind, MeasurementKind::kPosition);
  EXPECT_NEAR(m.load, 20 * 4.4482216152605, 1e-12);
  EXPECT_NEAR(m.q[1], 90 * kDegree, 1e-15);
  ASSERT_TRUE(m.p_W.has_value());
  EXPECT_TRUE(m.p_W->isApprox(Eigen::Vector3d(1, 2, 3) * kInch));
  EXPECT_NEAR(m.sigma, 0.003 * kInch, 1e-18);
  EXPECT_EQ(m.line, 2);
  EXPECT_TRUE(m.approach_directions.empty());
  EXPECT_TRUE(std::isnan(m.conditions[deflection::Condition::kTemperature]));
}

TEST_F(MeasurementsReader, takesAHolesCentreFromTheSheet) {
  const auto measurements = read(
      "id,kind,point,theta1_deg,theta2_deg,theta3_deg,theta4_deg\n1,touch,R1C57,0,90,0,0\n2,touch,elsewhere,0,90,0,"
      "0\n");
  ASSERT_TRUE(measurements[0].p_W.has_value());
  EXPECT_TRUE(measurements[0].p_W->isApprox(Eigen::Vector3d(-1.0625 / 2, 2.28, 0) * kInch));
  EXPECT_FALSE(measurements[1].p_W.has_value());
  expectSays(refusal("id,kind,point,theta1_deg,theta2_deg,theta3_deg,theta4_deg\n1,touch,R99C1,0,90,0,0\n"), "R99C1");
}

TEST_F(MeasurementsReader, readsOptionalColumnsAndOtherUnits) {
  const auto measurements = read(
      "time_s,temperature_degC,id,kind,setup,split,distance_mm,theta1_rad,theta2_rad,theta3_deg,theta4_deg,x_m,y_m,z_m,"
      "theta1_dir,theta2_dir,theta3_dir,theta4_dir\n60,20,\"a,b\",distance,s1,held-out,100,0.5,1,0,0,1,2,3,-1,0,1,1\n");
  const auto& m = measurements.at(0);
  EXPECT_EQ(m.id, "a,b");
  EXPECT_EQ(m.setup, "s1");
  EXPECT_TRUE(m.is_held_out);
  EXPECT_EQ(m.conditions[deflection::Condition::kTime], 60);
  EXPECT_EQ(m.conditions[deflection::Condition::kTemperature], 293.15);
  EXPECT_DOUBLE_EQ(m.kind_values[0], 0.1);
  EXPECT_EQ(m.q[0], 0.5);
  EXPECT_EQ(m.p_W->z(), 3);
  EXPECT_EQ(m.approach_directions, (std::vector<int>{-1, 0, 1, 1}));
}

TEST_F(MeasurementsReader, readsEveryConditionInEachOfItsUnits) {
  const std::string joints = "id,kind,theta1_deg,theta2_deg,theta3_deg,theta4_deg,x_in,y_in,z_in";
  for (const char* block : {"{length: in, angle: deg, force: lbf, temperature: degF, time: min}",
                            "{length: mm, angle: rad, force: N, temperature: K, time: h}"}) {
    const Units units(parseYaml(std::string("units: ") + block + "\n", "f.yaml").at("units"));
    for (const auto& kind : deflection::kConditionKinds) {
      const std::string header = joints + "," + conditionColumn(kind, units) + "\n";
      const auto measurements = read(header + "1,position,0,90,0,0,1,2,3,12.5\n2,position,0,90,0,0,1,2,3,\n");
      EXPECT_DOUBLE_EQ(measurements[0].conditions[kind.condition], units.toInternal(12.5, kind.unit)) << kind.name;
      EXPECT_FALSE(measurements[1].conditions.states(kind.condition)) << kind.name;
      if (kind.least > -1e300) {
        const std::string less = formatNumber(units.toFile(kind.least, kind.unit) - 1);
        expectSays(refusal(header + "1,position,0,90,0,0,1,2,3," + less + "\n"), kind.least_words);
      }
    }
  }
}

TEST_F(MeasurementsReader, refusesNumbersBeyondAnyQuantity) {
  for (const char* number : {"1e31", "-1e160", "1e300"})
    expectSays(refusal(std::string(kHeader) + "1,position,,0,0,90,0,0," + number + ",0,0,0.01\n"),
               "within 1e+30 of zero");
}

TEST_F(MeasurementsReader, refusesBadHeaders) {
  expectSays(refusal("id,kind,theta1_deg,theta2_deg,theta3_deg\n"), "no column 'theta4_");
  expectSays(refusal(changed(kHeader, "x_in", "x_inch")), "unknown unit 'inch'");
  expectSays(refusal(changed(kHeader, "point", "pionts")), "'pionts'");
  expectSays(refusal(changed(kHeader, "kind", "sort")), "no column 'kind'");
  expectSays(refusal(changed(kHeader, "y_in", "x_mm")), "both columns 'x_in' and 'x_mm'");
  expectSays(refusal(changed(kHeader, "y_in", "x_in")), "x_in");
  expectSays(refusal(changed(kHeader, "sigma_in", "theta1_dir")), "one for each of the 4 joints");
  expectSays(refusal(kHeader), "no readings");
}

TEST_F(MeasurementsReader, refusesBadRowsWithLineAndColumn) {
  const std::string good = "a,touch,P1,20,10,90,-20,5,1,2,3,0.003\n";
  const auto with = [&](const std::string& from, const std::string& to) {
    return refusal(kHeader + changed(good, from, to));
  };
  ASSERT_EQ(read(kHeader + good).size(), 1u);
  expectSays(with(",90,", ",nan,"), "m.csv:2 (column theta2_deg): found 'nan', expected a finite number");
  expectSays(with(",90,", ",,"), "found nothing");
  expectSays(with(",90,", ",9O,"), "'9O'");
  expectSays(with(",90,", ",inf,"), "'inf'");
  expectSays(with(",90,", ",190,"), "between the joint's limits, 0 and 180 deg");
  expectSays(with("touch", "tuoch"), "did you mean 'touch'?");
  expectSays(with("P1", ""), "the touch has no point");
  expectSays(with("1,2,3", "1,,3"), "some of the coordinates");
  expectSays(with("touch", "distance"), "kind distance has no distance");
  expectSays(with("0.003", "0"), "sigma");
  expectSays(with("0.003", "0.003,7"), "13 fields");
  expectSays(with("P1", "\"P1"), "quote");
  expectSays(with("20,10", "-20,10"), "the load is negative");
  expectSays(refusal(kHeader + changed(changed(good, "touch", "position"), "1,2,3", ",,")), "does not state x, y, z");
  expectSays(refusal(kHeader + good + good), "m.csv:3 (column id): line 2 already has the id 'a'");
}

TEST_F(MeasurementsReader, readsWhatIsSeenAlongADirection) {
  const std::string header =
      "id,kind,theta1_deg,theta2_deg,theta3_deg,theta4_deg,x_in,y_in,z_in,distance_in,dx,dy,dz,sigma_in\n";
  const std::string good = "a,axis,10,90,-20,5,1,2,3,-4,0,3,-4,0.003\n";
  const auto measurements = read(header + good);
  ASSERT_EQ(measurements.size(), 1U);
  EXPECT_EQ(measurements.front().kind, MeasurementKind::kAxis);
  EXPECT_NEAR(measurements.front().kind_values[0], -4 * kInch, 1e-15);
  EXPECT_TRUE(measurements.front().direction_W->isApprox(Eigen::Vector3d(0, 0.6, -0.8)));
  expectSays(refusal(header + changed(good, ",0,3,-4,", ",,,,")), "no direction");
  expectSays(refusal(header + changed(good, ",0,3,-4,", ",0,,-4,")), "some of the direction's");
  expectSays(refusal(header + changed(good, ",0,3,-4,", ",0,0,0,")), "is zero");
  expectSays(refusal(header + changed(good, ",0,3,-4,", ",0,x,-4,")), "column dy");
  expectSays(refusal(header + changed(good, "3,-4,0,3", "3,,0,3")), "does not state its distance");
}

TEST_F(MeasurementsReader, readsTheAnglesOfATool) {
  const std::string header =
      "id,kind,theta1_deg,theta2_deg,theta3_deg,theta4_deg,roll_deg,pitch_deg,yaw_deg,tilt_x_deg,tilt_z_deg,"
      "turn_sigma_deg\n";
  const std::string turned = "a,orientation,10,90,-20,5,30,-40,50,,,0.01\n", tilted = "b,tilt,10,90,-20,5,,,,2,,0.01\n";
  const auto measurements = read(header + turned + tilted);
  ASSERT_EQ(measurements.size(), 2U);
  EXPECT_TRUE(measurements[0].kind_values.isApprox(Eigen::Vector3d(30, -40, 50) * kDegree));
  EXPECT_NEAR(measurements[0].turn_sigma, 0.01 * kDegree, 1e-15);
  EXPECT_NEAR(measurements[1].kind_values[0], 2 * kDegree, 1e-15);
  EXPECT_TRUE(std::isnan(measurements[1].kind_values[1]) && std::isnan(measurements[1].kind_values[2]));
  EXPECT_TRUE(measurements[1].direction_W->isApprox(Eigen::Vector3d::UnitZ()));
  expectSays(refusal(header + changed(turned, ",30,-40,50,", ",30,,50,")), "has no roll, pitch, yaw");
  expectSays(refusal(header + changed(tilted, ",2,,", ",,,")), "does not state its tilt_x, tilt_y, tilt_z");
  expectSays(refusal(header + changed(tilted, "0.01", "-0.01")), "the turn_sigma is not above zero");
  expectSays(refusal(changed(header, "tilt_x_deg", "tilt_x_in") + tilted), "unknown unit 'in'");
}

TEST_F(MeasurementsReader, readsTheNoiseOfEachCoordinate) {
  const std::string header =
      "id,kind,point,theta1_deg,theta2_deg,theta3_deg,theta4_deg,x_in,y_in,z_in,distance_in,sigma_x_in,sigma_y_in,"
      "sigma_z_in\n";
  const std::string good = "a,position,,10,90,-20,5,1,2,3,,0.001,0.002,0.002\n";
  const auto m = read(header + good).at(0);
  EXPECT_NEAR(m.sigma, 0.0254 * std::sqrt(0.000003), 1e-12);
  const auto rows = calibration::rowSigmas(m);
  EXPECT_NEAR(rows[0], 0.001 * 0.0254, 1e-15);
  EXPECT_NEAR(rows[2], 0.002 * 0.0254, 1e-15);
  expectSays(refusal(header + changed(good, "0.001,", ",")), "some of the coordinates' sigma_x");
  expectSays(refusal(header + changed(good, "0.001,", "-0.001,")), "not above zero");
  expectSays(refusal(header + "a,distance,,10,90,-20,5,1,2,3,4,0.001,0.002,0.002\n"),
             "this kind does not measure x, y, z");
}

TEST_F(MeasurementsReader, readsForcesAndMomentsOnTheTip) {
  const std::string header =
      "id,kind,theta1_deg,theta2_deg,theta3_deg,theta4_deg,force_x_lbf,force_y_lbf,force_z_lbf,moment_x_lbfin,"
      "moment_y_lbfin,moment_z_lbfin,x_in,y_in,z_in,sigma_in\n";
  const std::string good = "a,position,10,90,-20,5,1,-2,3,4,5,-6,1,2,3,0.003\n";
  const auto m = read(header + good + "b,position,10,90,-20,5,,,,,,,1,2,3,0.003\n");
  ASSERT_TRUE(m[0].wrench);
  EXPECT_TRUE(m[0].wrench->force_W.isApprox(Eigen::Vector3d(1, -2, 3) * kPound));
  EXPECT_TRUE(m[0].wrench->moment_W.isApprox(Eigen::Vector3d(4, 5, -6) * kPound * kInch));
  EXPECT_FALSE(m[1].wrench);
  const std::string again = measurementsCsv(m, cell.arm, cell.units);
  const auto back = read(again);
  EXPECT_TRUE(back[0].wrench->force_W.isApprox(m[0].wrench->force_W, 1e-11));
  EXPECT_TRUE(back[0].wrench->moment_W.isApprox(m[0].wrench->moment_W, 1e-11));
  EXPECT_FALSE(back[1].wrench);
  expectSays(refusal(header + changed(good, ",1,-2,3,", ",1,,3,")), "some of the forces force_x, force_y, force_z");
  expectSays(refusal(header + changed(good, ",4,5,", ",,5,")), "some of the moments moment_x, moment_y, moment_z");
  expectSays(refusal(header + changed(good, ",-2,", ",nan,")), "column force_y_lbf");
  expectSays(refusal(changed(header, "moment_x_lbfin", "moment_x_lbf") + good), "unknown unit 'lbf'");
}

TEST_F(MeasurementsReader, readsTheJointsOfSideChains) {
  deflection::SideChain<double> chain{0, std::vector<deflection::Row<double>>(1)};
  chain.rows[0].name = "left";
  chain.rows[0].joint = {.name = "left1", .type = deflection::JointType::kRevolute};
  chain.rows[0].weight.end = 10;
  cell.arm.side_chains = {chain};
  const std::string header = "id,kind,theta1_deg,theta2_deg,theta3_deg,theta4_deg,left1_deg,x_in,y_in,z_in,sigma_in\n";
  const std::string good = "a,position,10,90,-20,5,33,1,2,3,0.003\n";
  const auto m = read(header + good);
  ASSERT_EQ(m[0].side_q.size(), 1);
  EXPECT_NEAR(m[0].side_q[0], 33 * kDegree, 1e-15);
  EXPECT_NEAR(read(measurementsCsv(m, cell.arm, cell.units))[0].side_q[0], 33 * kDegree, 1e-12);
  expectSays(refusal(changed(header, "left1_deg,", "") + changed(good, ",33", "")), "no column 'left1_deg'");
}

TEST_F(MeasurementsReader, readsTheTiltsOfARow) {
  const std::string header =
      "id,kind,row,theta1_deg,theta2_deg,theta3_deg,theta4_deg,x_in,y_in,z_in,tool_x_in,tool_y_in,tool_z_in,tilt_x_deg,"
      "sigma_in,turn_sigma_deg\n";
  const std::string of_row = "a,tilt,forearm,10,90,-20,5,,,,,,,2,,0.01\n",
                    of_tool = "b,tilt,,10,90,-20,5,,,,,,,2,,0.01\n";
  const auto measurements = read(header + of_row + of_tool);
  ASSERT_EQ(measurements.size(), 2u);
  ASSERT_TRUE(measurements[0].row);
  EXPECT_EQ(cell.arm.rows.at(static_cast<std::size_t>(*measurements[0].row)).name, "forearm");
  EXPECT_FALSE(measurements[1].row);
  const std::string unknown = refusal(header + changed(of_row, "forearm", "fourarm"));
  expectSays(unknown, "m.csv:2 (column row): found the unknown row 'fourarm'");
  expectSays(unknown, "mezzanine-beam, mezzanine-platform, base-link, latch-link, forearm");
  expectSays(unknown, "did you mean 'forearm'?");
  const std::string position = "c,position,forearm,10,90,-20,5,1,2,3,,,,,0.003,\n";
  expectSays(refusal(header + position), "a reading of kind position cannot be of row 'forearm'");
  expectSays(refusal(header + position), "only readings of kind tilt");
  expectSays(refusal(header + changed(of_row, ",5,,,,,,,2", ",5,,,,1,0,0,2")),
             "both a row of the arm and a point of the tool");
  expectSays(refusal(header + changed(of_row, ",2,,0.01", ",,,0.01")), "does not state its tilt_x, tilt_y, tilt_z");
  expectSays(refusal(header + changed(of_row, ",2,,0.01", ",nan,,0.01")), "finite number");
  expectSays(refusal(header + changed(of_row, "0.01", "-0.01")), "the turn_sigma is not above zero");
}

TEST_F(MeasurementsReader, readsHowTheNoiseOfCoordinatesGoesTogether) {
  const std::string header =
      "id,kind,theta1_deg,theta2_deg,theta3_deg,theta4_deg,x_in,y_in,z_in,sigma_x_in,sigma_y_in,sigma_z_in,rho_xy,"
      "rho_xz,rho_yz,sigma_in\n";
  const std::string good = "a,position,10,90,-20,5,1,2,3,0.001,0.002,0.002,0.9,-0.1,0,\n";
  const auto m = read(header + good).at(0);
  ASSERT_TRUE(m.correlation_W);
  EXPECT_EQ(*m.correlation_W, Eigen::Vector3d(0.9, -0.1, 0));
  EXPECT_NEAR(calibration::statedCovariance(m)(0, 1), 0.9 * 0.001 * 0.002 * kInch * kInch, 1e-20);
  EXPECT_FALSE(read(header + changed(good, "0.9,-0.1,0,", ",,,")).at(0).correlation_W);
  expectSays(refusal(header + changed(good, "0.9,-0.1,", "0.9,,")),
             "m.csv:2: only some of the correlations rho_xy, rho_xz, rho_yz are given; give all three or none");
  for (const char* rho : {"1", "-1", "1.2"})
    expectSays(refusal(header + changed(good, "0.9,", std::string(rho) + ",")),
               std::string("m.csv:2 (column rho_xy): found ") + rho + ", expected a correlation above -1 and below 1");
  expectSays(refusal(header + changed(good, "0.9,", "nan,")), "m.csv:2 (column rho_xy): found 'nan'");
  expectSays(refusal(header + changed(good, "0.9,-0.1,0,", "0.9,0.9,-0.9,")), "positive definite");
  const std::string alone = changed(good, "0.001,0.002,0.002,0.9,-0.1,0,", ",,,0.9,-0.1,0,0.002");
  expectSays(refusal(header + alone), "need sigma_x, sigma_y, sigma_z");
  expectSays(refusal(header + alone), "add those columns");
  const std::string missing =
      "id,kind,theta1_deg,theta2_deg,theta3_deg,theta4_deg,x_in,y_in,z_in,sigma_x_in,"
      "sigma_y_in,sigma_z_in,rho_xy,rho_xz\n";
  expectSays(refusal(missing + "a,position,10,90,-20,5,1,2,3,0.001,0.002,0.002,0.9,-0.1\n"), "all three or none");
}

TEST_F(MeasurementsReader, readsWaysFromOtherMeasurements) {
  const std::string header =
      "id,kind,point,setup,from,theta1_deg,theta2_deg,theta3_deg,theta4_deg,x_in,y_in,z_in,distance_in,sigma_in\n";
  const std::string first = "a,touch,P1,A,,10,90,-20,5,,,,,0.003\n", second = "b,touch,P1,A,,11,90,-20,5,,,,,0.003\n";
  const std::string length = "c,relative,,A,a,20,90,-20,5,,,,2,0.003\n",
                    way = "d,relative,,A,c,30,90,-20,5,1,2,3,,0.003\n";
  const auto measurements = read(header + length + way + first + second);
  ASSERT_EQ(measurements.size(), 4u);
  ASSERT_TRUE(measurements[0].reference && measurements[1].reference && !measurements[2].reference);
  EXPECT_EQ(measurements[0].reference->q, measurements[2].q);
  EXPECT_EQ(measurements[1].reference->id, "c");
  EXPECT_FALSE(measurements[1].reference->reference);
  EXPECT_EQ(calibration::rowsOf(measurements[0]), 1);
  EXPECT_EQ(calibration::rowsOf(measurements[1]), 3);
  const auto with = [&](const std::string& row, const std::string& from, const std::string& to) {
    return refusal(header + first + second + changed(row, from, to));
  };
  expectSays(with(length, ",A,a,", ",A,,"), "the id of that reading in the column 'from'");
  expectSays(with(length, ",A,a,", ",A,z,"), "m.csv:4 (column from): found the unknown id 'z'");
  expectSays(with(length, ",A,a,", ",A,c,"), "own id");
  expectSays(with(length, ",A,a,", ",B,a,"), "of another set-up");
  expectSays(with(length, ",,,2,", ",,,-2,"), "above zero");
  expectSays(with(length, ",,,2,", ",,,,"), "does not state its distance");
  expectSays(with(length, ",,,,2,", ",1,2,3,2,"), "has no distance");
}

TEST_F(MeasurementsReader, readsAnotherPointOfTheTool) {
  const std::string header =
      "id,kind,theta1_deg,theta2_deg,theta3_deg,theta4_deg,x_in,y_in,z_in,tool_x_in,tool_y_in,tool_z_in,sigma_in\n";
  const std::string good = "a,position,10,90,-20,5,1,2,3,0.5,0,-1,0.003\n";
  EXPECT_TRUE(read(header + good).front().p_TQ->isApprox(Eigen::Vector3d(0.5, 0, -1) * kInch));
  expectSays(refusal(header + changed(good, "0.5,0,-1", "0.5,,-1")), "tool_x, tool_y, tool_z");
  expectSays(refusal(header + changed(good, "position", "deflection")), "of the tip itself");
}

TEST_F(MeasurementsReader, stepsSayBetweenWhichTolerancesTheToolStood) {
  const std::string header = "id,kind,point,theta1_deg,theta2_deg,theta3_deg,theta4_deg,steps\n";
  cell.tool->lengths.clear();  // the tolerances are then those of the tip, whatever the tilt
  const auto settled = [&](const std::string& steps) {
    auto measurements =
        parseMeasurements(header + "a,steps,R10C20,10,90,-20,5," + steps + "\n", "m.csv", cell.arm, &*cell.sheet);
    stateSigma(measurements, cell, "m.csv", 0);
    return measurements.front();
  };
  const auto all = settled("3"), two = settled("2");
  EXPECT_EQ(rowsOf(all), 2);
  EXPECT_NEAR(all.sigma, 0.010 * kInch / 2, 1e-12);
  EXPECT_EQ(rowsOf(two), 1);
  EXPECT_NEAR(two.kind_values[1], 0.010 * kInch, 1e-12);
  EXPECT_NEAR(two.kind_values[2], 0.058 * kInch, 1e-12);
  EXPECT_NEAR(two.sigma, 0.048 * kInch / std::sqrt(12), 1e-12);
  for (const char* wrong : {"0", "4", "1.5", "-1"}) EXPECT_THROW(settled(wrong), InputError) << wrong;
}

}  // namespace
}  // namespace tubeplan::app
