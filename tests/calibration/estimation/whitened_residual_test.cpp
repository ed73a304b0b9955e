// The whitened residual of a campaign must have exact derivatives, and must treat touched points of unknown position
// like additional unknowns.
#include "calibration/estimation/whitened_residual.hpp"

#include <gtest/gtest.h>

#include "calibration/estimation/campaign_residual.hpp"
#include "calibration/estimation/fit.hpp"
#include "deflection/effects/effect.hpp"
#include "tests/calibration/synthetic_measurements.hpp"

namespace tubeplan::calibration {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

/// Frees parameters of all kinds: stiffnesses (one of them of a rigid axis and one of a beam), a length, an angle, a
/// weight, the tip, and every unknown base.
FreeChoice everyScale() {
  return {{"tool.joint_stiffness.z", "latch-link.beam.Iz", "base-link.joint_stiffness.y", "forearm.dh.a",
           "latch-link.joint.offset", "forearm.weight.end", "tool.tip"},
          true};
}

VectorXd anyStep(const std::vector<Unknown>& unknowns, MeasurementMaker& random) {
  VectorXd x(static_cast<Index>(unknowns.size()));
  for (Index k = 0; k < x.size(); ++k) {
    const Unknown& unknown = unknowns[static_cast<std::size_t>(k)];
    const bool is_base = unknown.owner == Unknown::Owner::kBase;
    x[k] = is_base                                        ? random.uniform(-0.3, 0.3)
           : unknown.scale == Unknown::Scale::kCompliance ? random.uniform(0.02, 0.1) * unknown.typical
                                                          : random.uniform(-0.5, 0.5) * unknown.typical;
  }
  return x;
}

/// Returns a maker with measurements of every kind in two set-ups, including touches of unknown points.
MeasurementMaker everyKindTwice() {
  MeasurementMaker maker(cobraTwice(), 3);
  addEveryKind(maker, 2, "A");
  addEveryKind(maker, 2, "B");
  addUntouched(maker, 2, "B");
  return maker;
}

// Without unknowns, the Jacobian must have rows but no columns, even if the same state was evaluated without a Jacobian
// before. Builds with sanitizers detect any access outside of it.
TEST(WhitenedResidual, HasSlopesWithoutColumnsWhereNothingIsUnknown) {
  MeasurementMaker maker = everyKindTwice();
  const PlacedArm start = cobraTwice();
  const auto weights = weighMeasurements(start, maker.measurements);
  ASSERT_TRUE(weights);
  const std::vector<Unknown> nothing;
  CampaignResidual residual(start, nothing, maker.measurements, *weights);
  VectorXd alone, r;
  MatrixXd jacobian;
  ASSERT_TRUE(residual.evaluate(VectorXd(), alone, nullptr));
  ASSERT_TRUE(residual.evaluate(VectorXd(), r, &jacobian));
  EXPECT_EQ(r, alone);
  EXPECT_EQ(jacobian.rows(), r.size());
  EXPECT_EQ(jacobian.cols(), 0);
}

// Whatever the weights and the order of evaluations, a residual that reuses stored results must equal a fresh
// evaluation.
TEST(WhitenedResidual, IsTheSameAtAStateThatIsAskedForAgain) {
  MeasurementMaker maker = everyKindTwice();
  PlacedArm start = cobraTwice();
  const auto unknowns = chooseUnknowns(start, everyScale()).list;
  const VectorXd x = anyStep(unknowns, maker);
  const auto stated = weighMeasurements(start, maker.measurements);
  ASSERT_TRUE(stated);
  MeasurementWeights weights = *stated;
  CampaignResidual kept(start, unknowns, maker.measurements, weights);
  const auto expectFresh = [&](const VectorXd& at, bool with_jacobian) {
    VectorXd r, error;
    MatrixXd jacobian;
    ASSERT_TRUE(kept.evaluate(at, r, with_jacobian ? &jacobian : nullptr, &error));
    const auto fresh = whitenedResidual(start, unknowns, maker.measurements, weights, at, with_jacobian);
    // Different kernels may solve the deflected shapes with and without a Jacobian, so results agree only to rounding.
    EXPECT_TRUE(r.isApprox(fresh.r, 1e-9));
    EXPECT_TRUE(error.isApprox(fresh.error, 1e-9));
    EXPECT_TRUE(jacobian.isApprox(fresh.jacobian, 1e-9));
  };
  expectFresh(x, false);
  expectFresh(x, true);
  weights = reweighted(weights, maker.measurements, 0.001);
  expectFresh(x, true);
  expectFresh(x, false);
  expectFresh(0.5 * x, false);
  expectFresh(x, true);
}

TEST(WhitenedResidual, JacobianMatchesDifferencesFarFromTheStart) {
  MeasurementMaker maker = everyKindTwice();
  PlacedArm start = cobraTwice();
  const auto unknowns = chooseUnknowns(start, everyScale());
  ASSERT_TRUE(unknowns.problems.empty());
  ASSERT_EQ(unknowns.list.size(), 21u);
  const VectorXd x = anyStep(unknowns.list, maker);
  const auto weights = weighMeasurements(start, maker.measurements);
  ASSERT_TRUE(weights);
  const auto exact = whitenedResidual(start, unknowns.list, maker.measurements, *weights, x, true);
  ASSERT_TRUE(exact.ok);
  for (Index k = 0; k < x.size(); ++k) {
    const double h = 0.002 * unknowns.list[static_cast<std::size_t>(k)].typical;
    const auto at = [&](double step) {
      VectorXd moved = x;
      moved[k] += step;
      return whitenedResidual(start, unknowns.list, maker.measurements, *weights, moved, false).r;
    };
    const VectorXd slope = (8 * (at(h) - at(-h)) - (at(2 * h) - at(-2 * h))) / (12 * h);
    EXPECT_LE((slope - exact.jacobian.col(k)).norm(), 1e-5 * exact.jacobian.col(k).norm())
        << unknowns.list[static_cast<std::size_t>(k)].name;
    EXPECT_GT(exact.jacobian.col(k).norm() * unknowns.list[static_cast<std::size_t>(k)].typical, 1);
  }
}

// If a displacement is converted to another kind of measurement, it keeps its `reference`, which must no longer affect
// its noise.
TEST(WhitenedResidual, AReferenceWeighsOnlyWhereTheKindHasOne) {
  const PlacedArm placed = cobra();
  MeasurementMaker maker(placed, 6);
  maker.add(MeasurementKind::kRelative, 3);
  for (auto& measurement : maker.measurements) measurement.kind = MeasurementKind::kPosition;
  auto alone = maker.measurements;
  for (auto& measurement : alone) measurement.reference = nullptr;
  const auto with = weighMeasurements(placed, maker.measurements), without = weighMeasurements(placed, alone);
  ASSERT_TRUE(with && without);
  for (std::size_t k = 0; k < alone.size(); ++k) EXPECT_EQ(with->noise[k], without->noise[k]);
}

// If only some components of a base step are free, the residual and their Jacobian columns must be the same as if all
// were free and the others 0.
TEST(WhitenedResidual, SomeNumbersOfABaseHaveTheSlopesThatTheyHaveAmongAll) {
  MeasurementMaker maker = everyKindTwice();
  PlacedArm start = cobraTwice();
  const auto all = chooseUnknowns(start, everyScale()).list;
  std::vector<Unknown> some;
  std::vector<Index> columns;
  VectorXd x = anyStep(all, maker), of_some = x;
  for (Index k = 0; k < x.size(); ++k) {
    const Unknown& unknown = all[static_cast<std::size_t>(k)];
    if (unknown.owner == Unknown::Owner::kBase && unknown.component % 4 != unknown.base_pose) {
      x[k] = 0;
      continue;
    }
    of_some[static_cast<Index>(some.size())] = x[k];
    some.push_back(unknown);
    columns.push_back(k);
  }
  ASSERT_LT(some.size(), all.size() - 6);
  of_some.conservativeResize(static_cast<Index>(some.size()));
  const auto weights = weighMeasurements(start, maker.measurements);
  ASSERT_TRUE(weights);
  const auto complete = whitenedResidual(start, all, maker.measurements, *weights, x, true);
  const auto part = whitenedResidual(start, some, maker.measurements, *weights, of_some, true);
  ASSERT_TRUE(complete.ok && part.ok);
  EXPECT_TRUE(part.r.isApprox(complete.r, 1e-9));
  EXPECT_TRUE(part.jacobian.isApprox(complete.jacobian(Eigen::all, columns), 1e-9));
}

/// Evaluation in batches and one by one must give the same results. The arm `slow` is evaluated one by one, because an
/// effect, here of zero size, excludes the batch kernels.
TEST(WhitenedResidual, IsTheSameSideBySideAndOneByOne) {
  MeasurementMaker maker(cobraTwice(), 5, MeasurementMaker::Noise::kStated);
  addEveryKind(maker, 3, "A");
  addEveryKind(maker, 3, "B");
  addUntouched(maker, 2, "A");
  PlacedArm fast = cobraTwice();
  fast.base_poses[1].is_known = true;
  const FreeChoice choice{
      {"tool.joint_stiffness.z", "latch-link.beam.Iz", "latch-link.beam.E", "base-link.joint_stiffness.y"}, true};
  const auto unknowns = chooseUnknowns(fast, choice).list;
  ASSERT_EQ(unknowns.size(), 10u);
  PlacedArm slow = fast;
  slow.arm.effects.push_back(deflection::makeEffect(slow.arm, "contact-force", "tip").effect);
  const VectorXd x = anyStep(unknowns, maker);
  const auto weights = weighMeasurements(applied(fast, unknowns, x), maker.measurements);
  const auto same_weights = weighMeasurements(applied(slow, unknowns, x), maker.measurements);
  ASSERT_TRUE(weights && same_weights);
  for (std::size_t k = 0; k < maker.measurements.size(); ++k)
    EXPECT_LE((weights->whitener[k] - same_weights->whitener[k]).norm(), 1e-8 * weights->whitener[k].norm());
  const auto a = whitenedResidual(fast, unknowns, maker.measurements, *weights, x, true);
  const auto b = whitenedResidual(slow, unknowns, maker.measurements, *weights, x, true);
  ASSERT_TRUE(a.ok && b.ok);
  EXPECT_LE((a.r - b.r).norm(), 1e-8 * b.r.norm());
  EXPECT_LE((a.error - b.error).norm(), 1e-8 * b.error.norm());
  for (Index k = 0; k < x.size(); ++k)
    EXPECT_LE((a.jacobian.col(k) - b.jacobian.col(k)).norm(), 1e-8 * b.jacobian.col(k).norm())
        << unknowns[static_cast<std::size_t>(k)].name;
}

TEST(WhitenedResidual, DoesNotHangOnHowManyMeasurementsAreTakenAtOnce) {
  PlacedArm exact = cobra();  // no encoder noise, because copies of a measurement would share it
  for (auto& row : exact.arm.rows) row.joint.encoder_sigma = 0;
  MeasurementMaker maker(cobra(), 7, MeasurementMaker::Noise::kStated);
  addEveryKind(maker, 2);
  addUntouched(maker, 2);
  const auto few = maker.measurements;
  while (maker.measurements.size() < 1300) maker.measurements.insert(maker.measurements.end(), few.begin(), few.end());
  const auto own = weighMeasurements(exact, few), all = weighMeasurements(exact, maker.measurements);
  MeasurementWeights plain_own = *own, plain_all = *all;
  plain_own.points.clear();
  plain_all.points.clear();
  const VectorXd of_few = whitenedResidual(exact, {}, few, plain_own, {}, false).r;
  const VectorXd of_all = whitenedResidual(exact, {}, maker.measurements, plain_all, {}, false).r;
  for (Index row = 0; row < of_all.size(); row += of_few.size())
    EXPECT_EQ(VectorXd(of_all.segment(row, of_few.size())), of_few);
}

/// Residual and Jacobian of a campaign in which each unknown point is three additional variables instead of being
/// eliminated.
struct ExplicitPoints {
  MatrixXd jacobian;
  VectorXd r;
};

ExplicitPoints withExplicitPoints(const PlacedArm& start, const std::vector<Unknown>& unknowns,
                                  const std::vector<Measurement>& measurements, const MeasurementWeights& weights,
                                  const VectorXd& x) {
  MeasurementWeights plain = weights;
  plain.points.clear();
  auto measured = measurements;
  for (auto& m : measured)
    if (!m.p_W) m.p_W = Eigen::Vector3d(0.3, 0.2, 0.1);  // start position of every unknown point
  const auto residual = whitenedResidual(start, unknowns, measured, plain, x, true);
  ExplicitPoints result{MatrixXd::Zero(residual.r.size(), x.size() + 3 * static_cast<Index>(weights.points.size())),
                        residual.r};
  result.jacobian.leftCols(x.size()) = residual.jacobian;
  for (std::size_t p = 0; p < weights.points.size(); ++p)
    for (const int k : weights.points[p].measurements)
      result.jacobian.block<3, 3>(weights.first_row[static_cast<std::size_t>(k)],
                                  x.size() + 3 * static_cast<Index>(p)) =
          -weights.whitener[static_cast<std::size_t>(k)];
  return result;
}

TEST(WhitenedResidual, EliminatedPointsEqualExplicitOnes) {
  MeasurementMaker maker(cobraTwice(), 4, MeasurementMaker::Noise::kStated);
  addEveryKind(maker, 4, "A");
  addEveryKind(maker, 4, "B");
  PlacedArm start = cobraTwice();
  const auto unknowns = chooseUnknowns(start, {{"tool.joint_stiffness.z", "latch-link.beam.Iz"}, true}).list;
  VectorXd x(static_cast<Index>(unknowns.size()));
  for (Index k = 0; k < x.size(); ++k) x[k] = 0.01 * unknowns[static_cast<std::size_t>(k)].typical;
  const auto weights = weighMeasurements(applied(start, unknowns, x), maker.measurements);
  ASSERT_EQ(weights->points.size(), 8u);
  EXPECT_EQ(weights->degrees_of_freedom, weights->rows - 24);
  auto eliminated = whitenedResidual(start, unknowns, maker.measurements, *weights, x, true);
  auto with_points = withExplicitPoints(start, unknowns, maker.measurements, *weights, x);
  for (Index k = 0; k < x.size(); ++k) {  // scale: a compliance and an angle differ by many powers of ten
    eliminated.jacobian.col(k) *= unknowns[static_cast<std::size_t>(k)].typical;
    with_points.jacobian.col(k) *= unknowns[static_cast<std::size_t>(k)].typical;
  }
  const VectorXd step = eliminated.jacobian.colPivHouseholderQr().solve(-eliminated.r);
  const VectorXd step_with_points = with_points.jacobian.colPivHouseholderQr().solve(-with_points.r);
  EXPECT_LE((step - step_with_points.head(x.size())).norm(), 1e-9 * step.norm());
  const double remaining = (eliminated.r + eliminated.jacobian * step).norm();
  EXPECT_NEAR(remaining, (with_points.r + with_points.jacobian * step_with_points).norm(), 1e-8 * remaining);
  const MatrixXd covariance = (eliminated.jacobian.transpose() * eliminated.jacobian).inverse();
  const MatrixXd covariance_with_points = (with_points.jacobian.transpose() * with_points.jacobian).inverse();
  EXPECT_LE((covariance - covariance_with_points.topLeftCorner(x.size(), x.size())).norm(), 1e-6 * covariance.norm());
}

TEST(WhitenedResidual, AnUnknownPointIsEstimatedFromItsTouches) {
  MeasurementMaker maker(cobra(), 6, MeasurementMaker::Noise::kStated);
  maker.addTouches(3, {0, 20 * kPound, 40 * kPound}, false);
  const auto weights = weighMeasurements(cobra(), maker.measurements);
  const auto residual = whitenedResidual(cobra(), {}, maker.measurements, *weights, {}, false);
  for (const auto& point : weights->points) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const int k : point.measurements) {
      const auto row = weights->first_row[static_cast<std::size_t>(k)];
      sum += weights->covariance(static_cast<std::size_t>(k)).inverse() * residual.error.segment(row, 3);
    }
    // At the estimated position of the point, the weighted errors of its touches must add up to zero.
    EXPECT_LE(sum.norm(), 1e-6 / maker.measurements.front().sigma);
  }
  EXPECT_EQ(weights->points.size(), 3u);
}

TEST(WhitenedResidual, NoiseLeavesItsFloorAndOneOfChiSquareForEachDegreeOfFreedom) {
  double squares = 0, floor = 0, chi2 = 0, freedom = 0;
  constexpr int kSeeds = 60;
  for (int seed = 1; seed <= kSeeds; ++seed) {
    MeasurementMaker maker(cobra(), static_cast<std::uint64_t>(seed), MeasurementMaker::Noise::kStated);
    addEveryKind(maker, 2);
    const auto weights = weighMeasurements(cobra(), maker.measurements);
    const auto residual = whitenedResidual(cobra(), {}, maker.measurements, *weights, {}, false);
    squares += errorLengths(maker.measurements, *weights, residual.error).squaredNorm() /
               static_cast<double>(maker.measurements.size() * kSeeds);
    floor += std::pow(noiseFloor(maker.measurements, *weights), 2) / kSeeds;
    chi2 += residual.r.squaredNorm();
    freedom += weights->degrees_of_freedom;
  }
  EXPECT_NEAR(chi2 / freedom, 1, 4 * std::sqrt(2 / freedom));
  EXPECT_NEAR(squares / floor, 1, 0.1);
}

TEST(WhitenedResidual, AFactorWeakensItsMeasurement) {
  MeasurementMaker maker(cobra(), 8, MeasurementMaker::Noise::kStated);
  maker.add(MeasurementKind::kPosition, 3);
  VectorXd factors = VectorXd::Ones(3);
  factors[1] = 0.25;
  const auto plain = weighMeasurements(cobra(), maker.measurements),
             weakened = weighMeasurements(cobra(), maker.measurements, factors);
  const auto a = whitenedResidual(cobra(), {}, maker.measurements, *plain, {}, false).r;
  const auto b = whitenedResidual(cobra(), {}, maker.measurements, *weakened, {}, false).r;
  EXPECT_LE((b.head(3) - a.head(3)).norm(), 1e-12);
  EXPECT_LE((b.segment(3, 3) - 0.5 * a.segment(3, 3)).norm(), 1e-9);
}

TEST(WhitenedResidual, SaysWhenTheModelCannotBeEvaluated) {
  MeasurementMaker maker(cobra(), 9);
  maker.add(MeasurementKind::kPosition, 2);
  maker.measurements[1].load = 1e7;
  EXPECT_FALSE(weighMeasurements(cobra(), maker.measurements).has_value());
}

TEST(WhitenedResidual, AModelErrorIsOneMoreVarianceOfEveryCoordinate) {
  MeasurementMaker maker(cobra(), 10, MeasurementMaker::Noise::kStated);
  addEveryKind(maker, 2);
  const double model_error = 2 * maker.measurements.front().sigma;
  const auto plain = weighMeasurements(cobra(), maker.measurements);
  const auto weights = weighMeasurements(cobra(), maker.measurements, {}, model_error);
  const auto again = reweighted(*plain, maker.measurements, model_error);
  for (std::size_t k = 0; k < maker.measurements.size(); ++k) {
    MatrixXd expected = plain->covariance(k);
    expected.diagonal().array() += model_error * model_error;
    EXPECT_LE((weights->covariance(k) - expected).norm(), 1e-12 * expected.norm());
    EXPECT_LE((weights->whitener[k] * expected * weights->whitener[k].transpose() -
               MatrixXd::Identity(expected.rows(), expected.rows()))
                  .norm(),
              1e-9);
    EXPECT_EQ(again.whitener[k], weights->whitener[k]);
  }
  EXPECT_EQ(noiseFloor(maker.measurements, *weights), noiseFloor(maker.measurements, *plain));
  EXPECT_EQ(weights->degrees_of_freedom, plain->degrees_of_freedom);
}

}  // namespace
}  // namespace tubeplan::calibration
