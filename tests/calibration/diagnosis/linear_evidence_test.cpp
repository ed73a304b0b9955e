// What columns take of chi-square, about one linearisation.
#include "calibration/diagnosis/linear_evidence.hpp"

#include <gtest/gtest.h>

namespace tubeplan::calibration {
namespace {

TEST(LinearEvidence, ColumnsTakeWhatTheyHaveOfTheResidualAndNoneTakesNothing) {
  Eigen::MatrixXd S(4, 2);
  S << 1, 0, 1, 0, 0, 2, 0, 0;
  const Eigen::Vector4d y(3, 1, 4, 5);  // along the columns 8 and 16 of a chi-square of 51
  EvidenceGram gram;
  gram.add(Eigen::MatrixXd(4, 0), S, Eigen::MatrixXd(4, 0), y);
  const LinearEvidence evidence(gram, {}, {});
  EXPECT_NEAR(evidence.chi2(), 51, 1e-9);
  EXPECT_EQ(evidence.fall({}), 0);
  EXPECT_NEAR(evidence.fall({0}), 8, 1e-9);
  EXPECT_NEAR(evidence.fall({0, 1}), 24, 1e-9);
}

}  // namespace
}  // namespace tubeplan::calibration
