#include "calibration/diagnosis/judgement/same_posture.hpp"

#include <gtest/gtest.h>

#include <random>

namespace tubeplan::calibration {
namespace {

constexpr int kPostures = 20, kLoads = 3;
constexpr double kMeasurementSigma = 1e-4;  // [m]

struct Measurements {
  std::vector<Measurement> measurements;
  MeasurementWeights weights;
};

/// Returns measurements of every posture under three loads.
Measurements measurementsUnderLoads(std::mt19937_64& random) {
  Measurements made;
  std::uniform_real_distribution<double> angle(-1, 1);
  for (int k = 0; k < kPostures; ++k) {
    const Eigen::Vector3d q(angle(random), angle(random), angle(random));
    for (int load = 0; load < kLoads; ++load) {
      Measurement measurement;
      measurement.q = q;
      measurement.load = 50. * load;
      measurement.sigma = kMeasurementSigma;
      measurement.p_W = Eigen::Vector3d::Zero();
      made.measurements.push_back(measurement);
      made.weights.first_row.push_back(made.weights.rows);
      made.weights.whitener.push_back(Eigen::MatrixXd::Identity(3, 3) / kMeasurementSigma);
      made.weights.rows += 3;
    }
  }
  return made;
}

/// Returns noise plus an error common to the measurements of each posture, both in units of the noise sigma.
Eigen::VectorXd errorsOf(const Measurements& made, double of_posture, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  Eigen::VectorXd errors(made.weights.rows);
  Eigen::Vector3d own;
  for (std::size_t k = 0; k < made.measurements.size(); ++k)
    for (int axis = 0; axis < 3; ++axis) {
      if (k % kLoads == 0) own[axis] = of_posture * normal(random);
      errors[3 * static_cast<Eigen::Index>(k) + axis] = own[axis] + normal(random);
    }
  return errors;
}

TEST(SamePosture, HasItsShareOfTheVariance) {
  std::mt19937_64 random(1);
  const Measurements made = measurementsUnderLoads(random);
  for (const double of_posture : {1., 3.}) {
    const SamePosture same = judgeSamePosture(made.measurements, made.weights, errorsOf(made, of_posture, random));
    EXPECT_EQ(same.postures, kPostures);
    EXPECT_TRUE(same.isSignificant());
    EXPECT_NEAR(same.share, of_posture * of_posture / (of_posture * of_posture + 1), 0.15);
  }
}

TEST(SamePosture, NoiseAloneIsOfNoPosture) {
  std::mt19937_64 random(2);
  const Measurements made = measurementsUnderLoads(random);
  int significant = 0, unlikely = 0;
  for (int k = 0; k < 500; ++k) {
    const SamePosture same = judgeSamePosture(made.measurements, made.weights, errorsOf(made, 0, random));
    significant += same.isSignificant();
    unlikely += same.p_value < 0.05;
  }
  EXPECT_EQ(significant, 0);
  EXPECT_NEAR(unlikely, 25, 15);
}

TEST(SamePosture, IsNotJudgedWhereEachWasReadOnce) {
  std::mt19937_64 random(3);
  Measurements made = measurementsUnderLoads(random);
  const Eigen::VectorXd errors = errorsOf(made, 3, random);
  for (std::size_t k = 0; k < made.measurements.size(); ++k) made.measurements[k].q[0] += 0.1 * static_cast<double>(k);
  const SamePosture same = judgeSamePosture(made.measurements, made.weights, errors);
  EXPECT_EQ(same.postures, 0);
  EXPECT_FALSE(same.isSignificant());
}

}  // namespace
}  // namespace tubeplan::calibration
