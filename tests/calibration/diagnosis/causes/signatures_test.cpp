// Columns of effects on joint readings, which follow from the derivatives with respect to the joints, must equal the
// derivatives with respect to the effects' own parameters.
#include "calibration/diagnosis/causes/signatures.hpp"

#include <gtest/gtest.h>

#include "app/formats/cell/cell_reader.hpp"
#include "deflection/effects/joint_shift.hpp"
#include "tests/calibration/random_mechanisms.hpp"

namespace tubeplan::calibration {
namespace {

std::vector<Measurement> randomPositions(const PlacedArm& placed) {
  RandomStream random(3);
  std::vector<Measurement> measurements(20);
  for (auto& measurement : measurements) {
    measurement.p_W = Eigen::Vector3d::Zero();
    measurement.sigma = 1e-4;
    measurement.q.resize(placed.arm.jointCount());
    for (Eigen::Index j = 0; j < measurement.q.size(); ++j) {
      const auto [lower, upper] = rangeOf(placed.arm, placed.arm.joint(j));
      measurement.q[j] = random.uniform(lower, upper) / 2;
      measurement.approach_directions.push_back(random.index(3) - 1);
    }
  }
  return measurements;
}

/// Expects that the columns of every effect on joint readings equal those of a layer with this effect alone.
void expectColumnsOfEffects(const PlacedArm& placed, std::vector<Measurement> measurements) {
  auto causes = listCauses(placed, measurements, {}).causes;
  std::erase_if(causes, [](const Cause& cause) {
    return cause.effects.size() != 1 || !deflection::shiftsJoints(cause.effects.front());
  });
  ASSERT_GT(causes.size(), 6U);
  const Signatures signatures(placed, causes);
  const auto weights = weighMeasurements(placed, measurements);
  ASSERT_TRUE(weights);
  const Eigen::MatrixXd columns = signatures.columnsAt(measurements, *weights);
  ASSERT_EQ(columns.rows(), weights->rows);
  for (std::size_t c = 0; c < causes.size(); ++c) {
    PlacedArm with = placed;
    const auto unknowns = placeCause(with, causes[c], 0);
    const auto residual = whitenedResidual(with, unknowns, measurements, *weights, zerosOf(unknowns), true);
    ASSERT_TRUE(residual.ok);
    for (std::size_t v = 0; v < unknowns.size(); ++v) {
      const Eigen::VectorXd expected = residual.jacobian.col(static_cast<Eigen::Index>(v)) * unknowns[v].typical;
      const int column = signatures.columnsOf(static_cast<int>(c), 0)[v];
      EXPECT_LT((columns.col(column) - expected).norm(), 1e-9 * (1 + expected.norm()))
          << causes[c].effect << "@" << causes[c].at << " " << unknowns[v].name;
    }
  }
}

TEST(Signatures, EffectsOnJointReadingsFollowFromTheJoints) {
  for (const char* name : {"bench", "bowl", "iiwa", "column", "puma"}) {
    const auto cell = app::readCell(std::string(TUBEPLAN_SOURCE_DIR "/app/cells/") + name + ".yaml");
    PlacedArm placed{cell.arm, {{"", cell.X_WB, true}}, {}};
    SCOPED_TRACE(name);
    expectColumnsOfEffects(placed, randomPositions(placed));
    placed.arm.effects.push_back(deflection::makeEffect(placed.arm, "joint-scale", jointNames(placed.arm)[1]).effect);
    placed.arm.effects.back().values[0] = 0.01;
    expectColumnsOfEffects(placed, randomPositions(placed));
  }
}

TEST(Signatures, DisplacementsTakeBothPosturesIntoAccount) {
  const auto cell = app::readCell(TUBEPLAN_SOURCE_DIR "/app/cells/bench.yaml");
  const PlacedArm placed{cell.arm, {{"", cell.X_WB, true}}, {}};
  auto measurements = randomPositions(placed);
  for (Measurement& measurement : measurements) {
    measurement.kind = MeasurementKind::kDeflection;
    measurement.load = 100;
  }
  expectColumnsOfEffects(placed, measurements);
}

}  // namespace
}  // namespace tubeplan::calibration
