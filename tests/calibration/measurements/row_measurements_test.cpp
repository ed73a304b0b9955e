// Measurements of a row's frame: their prediction, its derivatives, and how accurately they determine a stiffness.
#include <gtest/gtest.h>

#include "calibration/estimation/identification.hpp"
#include "calibration/estimation/whitened_residual.hpp"
#include "calibration/measurements/predict_all.hpp"
#include "deflection/effects/effect.hpp"
#include "deflection/effects/joint_shift.hpp"
#include "tests/calibration/synthetic_measurements.hpp"

namespace tubeplan::calibration {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

std::vector<MeasurementKind> kindsOfRows() {
  std::vector<MeasurementKind> kinds;
  for (const auto& row : measurementKinds())
    if (row.may_be_of_row) kinds.push_back(row.kind);
  return kinds;
}

Measurement tiltOf(const deflection::Arm& arm, std::optional<int> row) {
  Measurement m;
  m.kind = MeasurementKind::kTilt;
  m.row = row;
  m.q = Eigen::Vector4d(25, 70, -60, -20) * kDegree;
  m.load = 30 * kPound;
  m.direction_W = -arm.gravity_W;
  m.kind_values.setZero();
  m.sigma = kTurnLever * 0.01 * kDegree;
  m.turn_sigma = 0.01 * kDegree;
  return m;
}

PlacedArm withEffects() {
  PlacedArm placed = cobra();
  for (const auto& [name, at, value] :
       {std::tuple{"joint-offset", "theta2", 0.01}, std::tuple{"joint-compliance", "forearm.x", 1e-4},
        std::tuple{"link-length", "latch-link", 0.002}}) {
    placed.arm.effects.push_back(deflection::makeEffect(placed.arm, name, at).effect);
    placed.arm.effects.back().values = {value};
  }
  return placed;
}

TEST(RowMeasurements, AreOfTheRowsDeflectedFrame) {
  for (const PlacedArm& placed : {cobra(), withEffects()}) {
    const auto& X_WB = placed.base_poses.front().X_WB;
    const Measurement any = tiltOf(placed.arm, {});
    const auto shape = deflection::solveFlexibleKinematics(placed.arm, postureOf(any, placed.arm, X_WB), kFine);
    double most = 0;
    for (int row = 0; row < static_cast<int>(placed.arm.rows.size()); ++row) {
      const auto& state = shape.rows[static_cast<std::size_t>(row)];
      const VectorXd angles = predictMeasurement(placed.arm, X_WB, tiltOf(placed.arm, row)).value / kTurnLever;
      const Eigen::Matrix3d R = X_WB.linear() * state.X_BL.R;
      for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(angles[axis], std::asin(R(2, axis)), 1e-9) << row;
      most = std::max(most, (state.X_BL.R - state.X_BL_rigid.R).norm());
    }
    EXPECT_GT(most, 0.001) << "an arm that bends";
  }
}

TEST(RowMeasurements, ThoseOfTheLastRowAreThoseOfTheToolWhereItsMemberIsRigid) {
  const PlacedArm placed = cobra();  // no beam between the last row and the tip
  const auto& X_WB = placed.base_poses.front().X_WB;
  const int last = static_cast<int>(placed.arm.rows.size()) - 1;
  const auto row = predictMeasurement(placed.arm, X_WB, tiltOf(placed.arm, last)).value;
  EXPECT_LE((row - predictMeasurement(placed.arm, X_WB, tiltOf(placed.arm, {})).value).norm(), 1e-12);
}

TEST(RowMeasurements, DerivativesMatchDifferences) {
  for (const PlacedArm& placed : {cobra(), withEffects()}) {
    const auto& X_WB = placed.base_poses.front().X_WB;
    PredictionRequest request;
    request.by_base = request.by_joints = true;
    const auto number = deflection::findParameter(placed.arm, "forearm.joint_stiffness.z");
    request.numbers = {deflection::Variable::number(number->path)};
    for (int row = 0; row < static_cast<int>(placed.arm.rows.size()); ++row) {
      Measurement m = tiltOf(placed.arm, row);
      // record() omits the nearly vertical axis, whose derivative is ill-conditioned, as an inclinometer does.
      kindOf(m).record(*frameAt(placed.arm, X_WB, m), 1, MeasuredValue::Zero(3), m);
      ASSERT_EQ(rowsOf(m), 2);
      const auto exact = predictMeasurement(placed.arm, X_WB, m, request);
      ASSERT_TRUE(exact.ok);
      const auto expectSlope = [&](const auto& at, double h, const VectorXd& column, const std::string& what) {
        const VectorXd slope = (8 * (at(h) - at(-h)) - (at(2 * h) - at(-2 * h))) / (12 * h);
        EXPECT_LE((slope - column).norm(), 1e-6 * column.norm() + 1e-12 / h) << what << " of row " << row;
      };
      for (int k = 0; k < 4; ++k)
        expectSlope(
            [&](double h) {
              Measurement other = m;
              other.q[k] += h;
              return predictMeasurement(placed.arm, X_WB, other).value;
            },
            1e-3, exact.by_joints.col(k), "joint");
      for (int k = 0; k < 6; ++k)
        expectSlope(
            [&](double h) { return predictMeasurement(placed.arm, moved(X_WB, h * BaseStep::Unit(k)), m).value; }, 1e-3,
            exact.by_base.col(k), "base");
      expectSlope(
          [&](double h) {
            deflection::Arm arm = placed.arm;
            deflection::locate(arm, number->path) *= 1 + h;
            return predictMeasurement(arm, X_WB, m).value;
          },
          0.01, exact.by_numbers.col(0) * number->value, "stiffness");
    }
  }
}

/// Returns the arm with every effect that only shifts joints, at its first place, and adds the names of their
/// parameters to `names`.
PlacedArm withShiftedJoints(PlacedArm placed, std::vector<std::string>& names) {
  for (const auto& kind : deflection::effectKinds()) {
    const auto places = deflection::placeTexts(placed.arm, kind);
    if (kind.parameters.empty() || places.empty()) continue;
    auto effect = deflection::makeEffect(placed.arm, kind.name, places.front()).effect;
    if (!deflection::shiftsJoints(effect)) continue;
    for (std::size_t v = 0; v < effect.values.size(); ++v) {
      effect.values[v] += 0.3 * kind.parameters[v].plausible;
      names.push_back(deflection::textOf(placed.arm, effect) + "." + kind.parameters[v].name);
    }
    placed.arm.effects.push_back(effect);
  }
  return placed;
}

/// Expects that residuals and derivatives of tool measurements are the same whether they are solved in batches or, if
/// measurements of rows are among them, singly.
void expectSameInBatches(const PlacedArm& placed, const std::vector<std::string>& names) {
  MeasurementMaker maker(placed, 8, MeasurementMaker::Noise::kStated);
  addUntouched(maker, 2, "A");
  const auto alone = maker.measurements;
  for (const auto kind : kindsOfRows())
    for (int row = 0; row < 6; ++row) maker.add(kind, 1, "B", row);
  ASSERT_TRUE(areForKernels(placed.arm, alone));
  ASSERT_FALSE(areForKernels(placed.arm, maker.measurements));
  PlacedArm start = placed;
  const auto unknowns = chooseUnknowns(start, {names, true}).list;
  const auto weights = weighMeasurements(start, alone), all_weights = weighMeasurements(start, maker.measurements);
  ASSERT_TRUE(weights && all_weights);
  const auto a = whitenedResidual(start, unknowns, alone, *weights, zerosOf(unknowns), true);
  const auto b = whitenedResidual(start, unknowns, maker.measurements, *all_weights, zerosOf(unknowns), true);
  ASSERT_TRUE(a.ok && b.ok);
  EXPECT_LE((a.r - b.r.head(a.r.size())).norm(), 1e-7 * a.r.norm());
  for (Eigen::Index k = 0; k < a.jacobian.cols(); ++k)
    EXPECT_LE((a.jacobian.col(k) - b.jacobian.col(k).head(a.r.size())).norm(), 1e-7 * a.jacobian.col(k).norm())
        << unknowns[static_cast<std::size_t>(k)].name;
  EXPECT_GT(b.jacobian.bottomRows(b.r.size() - a.r.size()).norm(), 1);
}

TEST(RowMeasurements, AmongOthersChangeNothingOfThem) {
  std::vector<std::string> names{"tool.joint_stiffness.z", "forearm.dh.a"};
  expectSameInBatches(cobraTwice(), names);
  const PlacedArm shifted = withShiftedJoints(cobraTwice(), names);
  ASSERT_GT(shifted.arm.effects.size(), 5U);
  expectSameInBatches(shifted, names);
}

struct Stiffness {
  const char* row;
  const char* name;
};

// For each kind and row, between 180 and 198 of 200 intervals of 95 % contain the truth; for correct intervals, this
// has a probability of 0.998.
TEST(RowMeasurements, IntervalsHoldTheTruthAsOftenAsTheySay) {
  for (const auto kind : kindsOfRows())
    for (const auto& [row, name] :
         {Stiffness{"base-link", "mezzanine-beam.joint_stiffness.z"}, Stiffness{"forearm", "forearm.joint_stiffness.z"},
          Stiffness{"tool", "tool.joint_stiffness.z"}}) {
      int holds = 0, count = 0;
      for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        const PlacedArm truth = cobra();
        MeasurementMaker maker(truth, seed, MeasurementMaker::Noise::kStated);
        maker.add(kind, 30, "", deflection::findRow(truth.arm, row).value());
        IdentificationOptions options;
        options.free = {{name}, false};
        options.folds = 0;
        options.intervals_by_profile = false;
        const auto result = identify(truth, maker.measurements, options);
        if (result.status != IdentificationStatus::kDone) continue;
        const double value = deflection::findParameter(truth.arm, name)->value;
        ++count;
        holds += result.numbers.front().lower <= value && value <= result.numbers.front().upper;
      }
      EXPECT_EQ(count, 200) << row;
      EXPECT_GE(holds, 180) << row;
      EXPECT_LE(holds, 198) << row;
    }
}

}  // namespace
}  // namespace tubeplan::calibration
