// Base calibration from touches must recover the true base, give confidence regions that contain it, and refuse wrong
// touches.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/calibration/estimation/cobra_touches.hpp"

namespace tubeplan::calibration {
namespace {

BaseStep stepBetween(const Eigen::Isometry3d& from, const Eigen::Isometry3d& to) {
  const Eigen::AngleAxisd turn(Eigen::Matrix3d(to.linear() * from.linear().transpose()));
  BaseStep step;
  step << to.translation() - from.translation(), turn.angle() * turn.axis();
  return step;
}

TEST(BaseCalibration, RecoversTheBaseExactlyFromAnyStart) {
  const auto cell = touchedCell();
  const auto touches = touchesOf(cell, 0, 1);
  const Eigen::Isometry3d starts[] = {cell.X_WB_nominal, Eigen::Isometry3d::Identity(), pose(90, -30, 10, 170, 40, 12),
                                      cell.X_WB_true};
  for (const auto& start : starts) {
    const auto found = calibrateBase(cell.arm, touches, start);
    ASSERT_EQ(found.status, CalibrationStatus::kDone) << found.reason;
    const BaseStep off = stepBetween(found.X_WB, cell.X_WB_true);
    EXPECT_LE(off.head<3>().norm(), 1e-6 * kInch);
    EXPECT_LE(off.tail<3>().norm(), 1e-6 * kDegree);
    EXPECT_LE(found.rms, 1e-7 * kInch);
  }
}

TEST(BaseCalibration, IsTheSameByEitherSolver) {
  const auto cell = touchedCell();
  BaseCalibrationOptions quick;
  quick.method = LeastSquaresMethod::kLevenbergMarquardt;
  quick.mistaken_hole_p_value = 0;  // do not refuse the rigid arm, whose error is inches
  quick.finds_model_error = quick.finds_suspects = false;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    auto touches = touchesOf(cell, 0.005, seed);
    for (const bool is_rigid : {false, true}) {
      const deflection::Arm arm = is_rigid ? deflection::rigidCopy(cell.arm) : cell.arm;
      quick.arm = is_rigid ? ArmUncertainty::none() : ArmUncertainty{};
      BaseCalibrationOptions slow = quick;
      slow.method = LeastSquaresMethod::kInteriorPoint;
      const auto one = calibrateBase(arm, touches, cell.X_WB_nominal, quick);
      const auto other = calibrateBase(arm, touches, cell.X_WB_nominal, slow);
      ASSERT_EQ(one.status, CalibrationStatus::kDone) << one.reason;
      ASSERT_EQ(other.status, CalibrationStatus::kDone) << other.reason;
      const BaseStep off = stepBetween(one.X_WB, other.X_WB);
      EXPECT_LE(off.head<3>().norm(), 1e-4 * kInch);  // a fiftieth of the noise
      EXPECT_LE(off.tail<3>().norm(), 1e-4 * kDegree);
      EXPECT_NEAR(one.chi2, other.chi2, 1e-6 * other.chi2);
    }
  }
}

TEST(BaseCalibration, RecoversAHangingBase) {
  auto cell = touchedCell();
  const Eigen::Isometry3d X_WB = pose(5, 30, 20, 180, 0, 30);
  std::vector<Measurement> touches;
  for (const Eigen::Vector4d& q : {Eigen::Vector4d(20, 60, -50, -40), Eigen::Vector4d(-30, 90, -60, 20),
                                   Eigen::Vector4d(70, 40, 30, -60), Eigen::Vector4d(0, 100, -90, 0)}) {
    const auto shape = deflection::solveFlexibleKinematics(
        cell.arm, {q * kDegree, 0, deflection::gravityInBase(cell.arm, X_WB)}, {1e-14, 100});
    const std::string name = "H" + std::to_string(touches.size());
    touches.push_back(plannedTouch({name, name, X_WB * shape.X_BD.p, {}}, q * kDegree, 0, 0.005 * kInch));
  }
  const auto found = calibrateBase(cell.arm, touches, Eigen::Isometry3d::Identity());
  ASSERT_EQ(found.status, CalibrationStatus::kDone) << found.reason;
  EXPECT_LE(stepBetween(found.X_WB, X_WB).head<3>().norm(), 1e-6 * kInch);
}

/// Counts of calibrations in which the stated 95 % region contains the true base, for arms drawn from their
/// uncertainty.
struct Coverage {
  int runs = 0, held = 0, fits = 0, held_where_it_fits = 0;
  double chi2 = 0;
};

Coverage coverageOf(const ArmUncertainty& uncertainty, int runs) {
  constexpr double kInRegion = 12.591587;  // 95 % quantile of chi-square with 6 degrees of freedom
  const auto cell = touchedCell();
  BaseCalibrationOptions options;
  options.arm = uncertainty;
  options.finds_suspects = false;
  Coverage coverage;
  for (int run = 1; run <= runs; ++run) {
    const auto seed = static_cast<std::uint64_t>(run);
    auto truth = cell;
    truth.arm = drawnArm(cell.arm, uncertainty, seed);
    const auto found = calibrateBase(cell.arm, touchesOf(truth, 0.005, seed), cell.X_WB_nominal, options);
    EXPECT_EQ(found.status, CalibrationStatus::kDone) << found.reason;
    const BaseStep off = stepBetween(found.X_WB, cell.X_WB_true);
    const bool is_held = off.dot(found.covariance.ldlt().solve(off))<kInRegion, fits = found.p_value> 0.05;
    ++coverage.runs;
    coverage.held += is_held;
    coverage.fits += fits;
    coverage.held_where_it_fits += is_held && fits;
    coverage.chi2 += found.chi2 / runs;
  }
  return coverage;
}

/// The stated region must contain the true base in 95 % of the runs, whether the arms are exact, deviate in their
/// stiffnesses, or deviate in all parameters.
TEST(BaseCalibration, NinetyFivePercentRegionsHoldTheBaseWhateverOfTheArmIsUncertain) {
  constexpr int kRuns = 1000;
  ArmUncertainty stiffnesses = ArmUncertainty::none();
  stiffnesses.stiffness = 0.1;
  for (const auto& uncertainty : {ArmUncertainty::none(), stiffnesses, ArmUncertainty{}}) {
    const Coverage coverage = coverageOf(uncertainty, kRuns);
    EXPECT_NEAR(coverage.held, 0.95 * kRuns, 20);
    EXPECT_NEAR(coverage.fits, 0.95 * kRuns, 20);
    EXPECT_NEAR(coverage.held_where_it_fits / static_cast<double>(coverage.fits), 0.95, 0.02);
    EXPECT_NEAR(coverage.chi2, 3, 0.3);
  }
}

TEST(BaseCalibration, AnArmTakenAsExactThatIsNotHasFalseRegions) {
  const auto cell = touchedCell();
  ArmUncertainty stiffnesses = ArmUncertainty::none();
  stiffnesses.stiffness = 0.1;
  BaseCalibrationOptions exact;
  exact.arm = ArmUncertainty::none();
  exact.finds_suspects = exact.finds_model_error = false;
  int held = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    auto truth = cell;
    truth.arm = drawnArm(cell.arm, stiffnesses, seed);
    const auto found = calibrateBase(cell.arm, touchesOf(truth, 0.005, seed), cell.X_WB_nominal, exact);
    const BaseStep off = stepBetween(found.X_WB, cell.X_WB_true);
    held += off.dot(found.covariance.ldlt().solve(off)) < 12.591587;
  }
  EXPECT_LT(held, 50) << "what the file does not know counts";
}

TEST(BaseCalibration, TheArmAsTouchedBringsTheTipNearerToOtherHoles) {
  const auto cell = touchedCell(), elsewhere = touchedCell({{-20, 20}, {0, 30}, {25, 15}, {-30, 35}});
  ArmUncertainty stiffnesses = ArmUncertainty::none();
  stiffnesses.stiffness = 0.1;
  double as_touched = 0, as_filed = 0;
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    auto truth = cell;
    truth.arm = drawnArm(cell.arm, stiffnesses, seed);
    const auto touches = touchesOf(truth, 0.005, seed);
    for (const bool is_touched : {true, false}) {
      BaseCalibrationOptions options;
      options.arm = is_touched ? stiffnesses : ArmUncertainty::none();
      options.finds_suspects = false;
      const auto found = calibrateBase(cell.arm, touches, cell.X_WB_nominal, options);
      for (const auto& plan : elsewhere.plans)
        (is_touched ? as_touched : as_filed) += (predictTip(found.arm, found.X_WB, plan.q_start, 0).value -
                                                 predictTip(truth.arm, cell.X_WB_true, plan.q_start, 0).value)
                                                    .squaredNorm();
    }
  }
  EXPECT_LT(std::sqrt(as_touched), 0.6 * std::sqrt(as_filed));
}

TEST(BaseCalibration, MoreTouchesTightenTheBase) {
  const auto three = touchedCell(), six = touchedCell({{-40, 10}, {38, 12}, {10, 45}, {-25, 30}, {28, 32}, {0, 5}});
  const auto few = calibrateBase(three.arm, touchesOf(three, 0.005, 3), three.X_WB_nominal);
  const auto many = calibrateBase(six.arm, touchesOf(six, 0.005, 3), six.X_WB_nominal);
  ASSERT_EQ(many.status, CalibrationStatus::kDone);
  EXPECT_EQ(many.degrees_of_freedom, 12);
  EXPECT_EQ(many.distances.size(), 15u);
  EXPECT_LT(many.covariance.diagonal().head(3).sum(), few.covariance.diagonal().head(3).sum());
}

TEST(BaseCalibration, DistanceChecksDoNotDependOnTheBase) {
  const auto cell = touchedCell();
  BaseCalibrationOptions exact;
  exact.arm = ArmUncertainty::none();
  const auto found = calibrateBase(cell.arm, touchesOf(cell, 0, 1), cell.X_WB_nominal, exact);
  const auto uncertain = calibrateBase(cell.arm, touchesOf(cell, 0, 1), cell.X_WB_nominal);
  ASSERT_EQ(found.distances.size(), 3u);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(found.distances[k].by_arm, found.distances[k].on_sheet, 1e-8);
    EXPECT_GT(found.distances[k].sigma, 0.005 * kInch);
    EXPECT_LT(found.distances[k].sigma, 0.02 * kInch);
    EXPECT_GT(uncertain.distances[k].sigma, 1.5 * found.distances[k].sigma);
  }
}

TEST(BaseCalibration, RefusesTooFewTouches) {
  const auto cell = touchedCell();
  auto touches = touchesOf(cell, 0, 1);
  touches.pop_back();
  const auto found = calibrateBase(cell.arm, touches, cell.X_WB_nominal);
  EXPECT_EQ(found.status, CalibrationStatus::kRefused);
  EXPECT_NE(found.reason.find("at least three"), std::string::npos);
}

TEST(BaseCalibration, RefusesTheSameHoleTwice) {
  const auto cell = touchedCell();
  auto touches = touchesOf(cell, 0, 1);
  touches[2].point = touches[0].point;
  const auto found = calibrateBase(cell.arm, touches, cell.X_WB_nominal);
  EXPECT_EQ(found.status, CalibrationStatus::kRefused);
  EXPECT_NE(found.reason.find("H1 is touched twice"), std::string::npos);
}

TEST(BaseCalibration, NamesTheOneTouchThatDoesNotAgreeWithTheOthers) {
  const auto cell = touchedCell();
  const Eigen::Isometry3d& X_WB = cell.X_WB_true;
  std::vector<Measurement> touches;
  for (const Eigen::Vector4d& q :
       {Eigen::Vector4d(20, 60, -50, -40), Eigen::Vector4d(-30, 90, -60, 20), Eigen::Vector4d(70, 40, 30, -60),
        Eigen::Vector4d(0, 100, -90, 0), Eigen::Vector4d(-60, 50, -70, 10), Eigen::Vector4d(45, 80, -30, -20)}) {
    const auto shape = deflection::solveFlexibleKinematics(
        cell.arm, {q * kDegree, 0, deflection::gravityInBase(cell.arm, X_WB)}, {1e-14, 100});
    const std::string name = "H" + std::to_string(touches.size());
    touches.push_back(plannedTouch({name, name, X_WB * shape.X_BD.p, {}}, q * kDegree, 0, 0.005 * kInch));
  }
  BaseCalibrationOptions options;
  options.arm = ArmUncertainty::none();
  options.mistaken_hole_p_value = 0;
  EXPECT_EQ(calibrateBase(cell.arm, touches, cell.X_WB_nominal, options).outlier_touch, -1) << "they all fit";
  touches[1].q[1] += 0.2 * kDegree;
  const auto found = calibrateBase(cell.arm, touches, cell.X_WB_nominal, options);
  ASSERT_EQ(found.status, CalibrationStatus::kDone) << found.reason;
  EXPECT_TRUE(isFitRefused(found));
  EXPECT_EQ(found.outlier_touch, 1);
  EXPECT_LT(found.rms_of_others, found.rms / 3);
  touches[4].q[1] -= 0.2 * kDegree;
  EXPECT_EQ(calibrateBase(cell.arm, touches, cell.X_WB_nominal, options).outlier_touch, -1) << "two do not agree";
}

/// If one joint reading of one touch is wrong by half a degree or by five degrees, the fit must be rejected. Of ten
/// such cases, the wrong measurement must be among those named in at least nine, and be named first in at least seven.
TEST(BaseCalibration, NamesTheJointReadingThatIsOff) {
  const auto cell = touchedCell({{-40, 10}, {38, 12}, {10, 45}, {-5, 20}, {30, 35}});
  for (const double off : {0.5, 5.}) {
    int named = 0, first = 0;
    for (std::size_t touch = 0; touch < cell.plans.size(); ++touch)
      for (Eigen::Index joint = 0; joint < 2; ++joint) {  // only joints far from the tip
        auto touches = touchesOf(cell, 0.005, 3 + touch);
        touches[touch].q[joint] += off * kDegree;
        const auto found = calibrateBase(cell.arm, touches, cell.X_WB_nominal);
        EXPECT_TRUE(isFitRefused(found)) << off;
        EXPECT_EQ(found.residuals.size(), touches.size()) << "a refused fit shows what it left";
        for (std::size_t k = 0; k < found.suspect_measurements.size(); ++k) {
          const auto& suspect = found.suspect_measurements[k];
          if (suspect.touch != touches[touch].id || suspect.joint != joint) continue;
          ++named;
          first += k == 0;
          EXPECT_NEAR(suspect.off, off * kDegree, 0.3 * off * kDegree + 0.1 * kDegree);
        }
      }
    EXPECT_GE(named, 9) << off;
    EXPECT_GE(first, 7) << off;
  }
}

TEST(BaseCalibration, AHoleMayBeTouchedAgainUnderAnotherPush) {
  const auto cell = touchedCell();
  auto touches = touchesOf(cell, 0, 1);
  touches.push_back(touches[0]);
  EXPECT_NE(findTouchProblem(touches, {}), "");
  touches.back().wrench = TipWrench{};
  EXPECT_EQ(findTouchProblem(touches, {}), "");
}

TEST(BaseCalibration, AHoleMayBeTouchedAgainUnderAnotherLoad) {
  const auto cell = touchedCell();
  auto touches = touchesOf(cell, 0, 1);
  auto loaded = cell;
  TouchSimulationOptions options;
  options.sigma = 0;
  options.load = 133;
  for (auto& row : loaded.arm.rows) row.joint.encoder_sigma = 0;
  for (auto touch : simulateTouches(loaded.arm, cell.X_WB_true, cell.plans, options).touches) {
    touch.sigma = 0.005 * kInch;
    touches.push_back(touch);
  }
  const auto found = calibrateBase(cell.arm, touches, cell.X_WB_nominal);
  ASSERT_EQ(found.status, CalibrationStatus::kDone) << found.reason;
  EXPECT_LE((found.X_WB.translation() - cell.X_WB_true.translation()).norm(), 1e-6 * kInch);
  EXPECT_EQ(found.distances.size(), 12u);
}

TEST(BaseCalibration, RefusesHolesOnALine) {
  const auto cell = touchedCell({{-40, 10}, {38, 10}, {5, 10.5}});
  const auto found = calibrateBase(cell.arm, touchesOf(cell, 0, 1), cell.X_WB_nominal);
  EXPECT_EQ(found.status, CalibrationStatus::kRefused);
  EXPECT_NE(found.reason.find("line"), std::string::npos);
}

TEST(BaseCalibration, NamesTheMistakenHole) {
  const auto cell = touchedCell();
  constexpr double kPitch = 1.0625 * kInch;
  const Eigen::Vector3d aside[] = {{kPitch, 0, 0}, {-kPitch, 0, 0}, {0, kPitch, 0}, {0, -kPitch, 0}};
  int named = 0, cases = 0;
  for (std::size_t wrong = 0; wrong < 3; ++wrong)
    for (int way = 0; way < 4; ++way) {
      auto touches = touchesOf(cell, 0.005, 7 + static_cast<std::uint64_t>(way));
      // The arm touched the recorded hole's neighbour in the direction `aside[way]`.
      *touches[wrong].p_W -= aside[way];
      BaseCalibrationOptions options;
      options.neighbours = [&](const Measurement& touch) {
        std::vector<NeighbourHole> neighbours;
        for (int k = 0; k < 4; ++k)
          neighbours.push_back({touch.point + "+" + std::to_string(k), *touch.p_W + aside[k]});
        return neighbours;
      };
      const auto found = calibrateBase(cell.arm, touches, cell.X_WB_nominal, options);
      ASSERT_EQ(found.status, CalibrationStatus::kRefused) << wrong << " " << way;
      ++cases;
      const std::string right = "touch " + touches[wrong].id + " named " + touches[wrong].point + " fits hole " +
                                touches[wrong].point + "+" + std::to_string(way);
      named += std::find(found.suspects.begin(), found.suspects.end(), right) != found.suspects.end();
    }
  EXPECT_EQ(named, cases);
}

TEST(BaseCalibration, RefusesTouchesThatFitNothing) {
  const auto cell = touchedCell();
  auto touches = touchesOf(cell, 0.005, 3);
  touches[1].q[1] += 0.2;
  const auto found = calibrateBase(cell.arm, touches, cell.X_WB_nominal);
  EXPECT_EQ(found.status, CalibrationStatus::kRefused);
  EXPECT_TRUE(found.suspects.empty());
}

}  // namespace
}  // namespace tubeplan::calibration
