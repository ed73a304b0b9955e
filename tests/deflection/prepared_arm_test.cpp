// A prepared arm must solve each shape independently of earlier ones and without heap allocations. The slopes of the
// elements' laws must equal their derivatives in dual numbers.
#include "deflection/prepared_arm.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>

#include "deflection/elements/beam.hpp"
#include "deflection/elements/joint_stiffness.hpp"
#include "deflection/kinematics.hpp"
#include "tests/deflection/effects/effect_arms.hpp"

namespace {
std::atomic<long> allocations = 0;
}

// Counts all heap allocations, of Eigen's matrices as well as by `new`. Sanitizers do not let a test replace malloc.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define TUBEPLAN_SANITIZED 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define TUBEPLAN_SANITIZED 1
#endif
#endif
#ifndef TUBEPLAN_SANITIZED
extern "C" void* __libc_malloc(std::size_t size);
extern "C" void* malloc(std::size_t size) {
  ++allocations;
  return __libc_malloc(size);
}
#endif

namespace tubeplan::deflection {
namespace {

/// Returns the number of heap allocations of `work`; 0 in builds that do not count them.
template <class Work>
long allocationsOf(Work&& work) {
  const long before = allocations;
  work();
  return allocations - before;
}

TEST(PreparedArm, AllocationsAreCountedOfMatricesToo) {
#ifdef TUBEPLAN_SANITIZED
  GTEST_SKIP() << "sanitizers keep the heap to themselves: tests without the heap assert nothing here";
#endif
  Eigen::VectorXd matrix;
  std::vector<double> numbers;
  EXPECT_EQ(allocationsOf([&] { matrix.resize(3); }), 1);
  EXPECT_EQ(allocationsOf([&] { numbers.resize(3); }), 1);
}

TEST(PreparedArm, AShapeDoesNotDependOnThoseBefore) {
  std::mt19937_64 random(5);
  for (const Arm& bare : effectArms()) {
    Arm arm = bare;
    for (const bool with_effects : {false, true}) {
      if (with_effects)
        for (const Effect& effect : allEffects(bare)) arm.effects.push_back(sized(bare, effect, 0.02));
      PreparedArm prepared(arm);
      for (int n = 0; n < 10; ++n) {
        const Posture posture = randomPosture(arm, random);
        ASSERT_EQ(prepared.solve(posture), KinematicsStatus::kConverged);
        const auto alone = solveFlexibleKinematics(arm, posture);
        EXPECT_EQ(prepared.X_BD().p, alone.X_BD.p) << arm.name;
        EXPECT_EQ(prepared.X_BD().R, alone.X_BD.R) << arm.name;
        EXPECT_EQ(prepared.shape().rows.back().moment_B, alone.rows.back().moment_B) << arm.name;
      }
    }
  }
}

TEST(PreparedArm, SolvesWithoutTheHeap) {
  std::mt19937_64 random(6);
  const Arm arm = cobraArm();
  PreparedArm prepared(arm);
  std::vector<Posture> postures;
  for (int n = 0; n < 20; ++n) postures.push_back(randomPosture(arm, random));
  ASSERT_EQ(prepared.solve(postures[0]), KinematicsStatus::kConverged);
  EXPECT_EQ(allocationsOf([&] {
              for (const Posture& posture : postures) prepared.solve(posture);
            }),
            0);
}

TEST(PostureBatch, IsSolvedWithoutTheHeap) {
  std::mt19937_64 random(9);
  const Arm arm = cobraArm();
  Kinematics kinematics(arm);
  PostureBatch batch;
  batch.resize(4, 29, 50);
  for (Eigen::Index k = 0; k < batch.size(); ++k) batch.q.col(k) = randomJoints(arm, random);
  TipBatch tips;
  kinematics.solveWithJacobian(batch, tips);
  EXPECT_EQ(allocationsOf([&] { kinematics.solveWithJacobian(batch, tips); }), 0);
  TipDifferentiation one(arm);
  const std::vector<Variable> joints = jointVariables(arm);
  const Posture posture{batch.q.col(0)};
  ASSERT_EQ(one.solve(posture, joints), KinematicsStatus::kConverged);
  EXPECT_EQ(allocationsOf([&] { one.solve(posture, joints); }), 0);
}

TEST(TipDifferentiation, TakesDerivativesWithoutTheHeap) {
  std::mt19937_64 random(7);
  const Arm arm = cobraArm();
  std::vector<Variable> variables = jointVariables(arm);
  for (const auto& parameter : parametersOf(arm))
    if (parameter.quantity == Quantity::kTorquePerAngle) variables.push_back(Variable::number(parameter.path));
  TipDifferentiation tip(arm);
  std::vector<Posture> postures;
  for (int n = 0; n < 20; ++n) postures.push_back(randomPosture(arm, random));
  ASSERT_EQ(tip.solve(postures[0], variables), KinematicsStatus::kConverged);
  EXPECT_EQ(allocationsOf([&] {
              for (const Posture& posture : postures) tip.solve(posture, variables);
            }),
            0);
}

/// Expects that `slopes`, as stated by a law, equal the law's derivatives in dual numbers.
template <Deflection<Dual> (*Deflect)(const Flexibility<Dual>&, const Loading<Dual>&)>
void expectSlopes(const Flexibility<double>& flexibility, const Loading<double>& loading,
                  const DeflectionSlopes& slopes) {
  Flexibility<Dual> constant{flexibility.member.cast<Dual>(), flexibility.compliance.cast<Dual>(),
                             flexibility.has_soft_zone, flexibility.softness.cast<Dual>(),
                             flexibility.knee.cast<Dual>()};
  const Eigen::Matrix3d displacement[] = {slopes.displacement_by_force, slopes.displacement_by_moment,
                                          slopes.displacement_by_weight, slopes.displacement_by_chord};
  const Eigen::Matrix3d rotation[] = {slopes.rotation_by_force, slopes.rotation_by_moment, slopes.rotation_by_weight,
                                      slopes.rotation_by_chord};
  for (int input = 0; input < 4; ++input) {
    Loading<Dual> seeded{loading.force.cast<Dual>(), loading.moment.cast<Dual>(), loading.weight.cast<Dual>(),
                         loading.chord.cast<Dual>()};
    Vector3<Dual>* inputs[] = {&seeded.force, &seeded.moment, &seeded.weight, &seeded.chord};
    for (int k = 0; k < 3; ++k) (*inputs[input])[k].derivatives()[k] = 1;
    const Deflection<Dual> by = Deflect(constant, seeded);
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k) {
        EXPECT_NEAR(displacement[input](i, k), by.displacement[i].derivatives()[k], 1e-13 * displacement[input].norm());
        EXPECT_NEAR(rotation[input](i, k), by.rotation[i].derivatives()[k], 1e-13 * rotation[input].norm());
      }
  }
}

TEST(ElementSlopes, AreThoseOfTheLaws) {
  std::mt19937_64 random(8);
  std::uniform_real_distribution<double> size(0.1, 1);
  for (int n = 0; n < 50; ++n) {
    const Eigen::Vector3d member = size(random) * randomDirection(random);
    const Loading<double> loading{100 * randomDirection(random), 300 * randomDirection(random),
                                  40 * randomDirection(random), member + 0.02 * randomDirection(random)};
    Row<double> row;
    row.joint_stiffness = {2e3, kRigid, 5e3};
    row.beam = Beam<double>{7e10, {2e-8, kRigid, 4e-8}, 2.6e10, 3e-8};
    row.effect_terms.emplace();
    row.effect_terms->joint_is_compliant = true;
    row.effect_terms->softness = {0.5, 0, 2};
    row.effect_terms->knee = {100, 0, 250};
    const auto spring = joint_stiffness::flexibilityOf<double>(row, member);
    expectSlopes<joint_stiffness::deflect<Dual, Dual>>(spring, loading, joint_stiffness::slopesOf(spring, loading));
    const auto beam = beam::flexibilityOf<double>(row, member);
    expectSlopes<beam::deflect<Dual, Dual>>(beam, loading, beam::slopesOf(beam, loading));
  }
}

}  // namespace
}  // namespace tubeplan::deflection
