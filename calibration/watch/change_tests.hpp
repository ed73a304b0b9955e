// Tests of a watch after every measurement, with the largest statistic of each as a fraction of its limit.
#pragma once

#include <Eigen/Cholesky>
#include <string>
#include <vector>

#include "calibration/statistics.hpp"
#include "calibration/watch/state_filter.hpp"

namespace tubeplan::calibration {

/// Largest statistic of a test after a measurement.
struct TestedLevel {
  const char* test = "";
  double level = 0;  ///< statistic as a fraction of its limit; an alarm if above 1
  int since = 0;     ///< first measurement after the change that the statistic supposes
  double chi2 = 0;
  int degrees_of_freedom = 0;
};

/// Returns the measurements that are tried as the last one before a change: the latest ones, then increasingly sparse
/// ones, down to -1.
[[nodiscard]] std::vector<int> startsBefore(int measurement);

/// Tests on the measured values, which are normally distributed.
class MeasuredTests {
 public:
  /// Each of the three tests may raise a false alarm with the probability `share` over `planned` measurements.
  MeasuredTests(const RowsAndCandidates& watched, double share, int planned);

  /// Takes measurement `k` into account and tests all starts. Returns the test nearest to its limit.
  TestedLevel add(int k);

 private:
  /// Candidates with the same columns up to scale, which have the same statistic.
  struct Direction {
    std::vector<int> columns;
    double prior = 0;
    ChiSquareLimit limit{0.5};
  };
  /// Sums over the measurements up to one of them; z are the uncertain directions, of unit prior variance, and c the
  /// candidates' columns.
  struct Sums {
    Eigen::MatrixXd zz, zc;
    Eigen::MatrixXd cc;  ///< products of each column with the columns of the same direction
    Eigen::VectorXd ze, ce;
    double ee = 0, innovations = 0;
    int rows = 0;
  };

  void findDirections(double share, int tests);
  void take(int k);
  void testStart(int start, TestedLevel& nearest);
  void testDirection(Direction& direction, const char* test, int start, TestedLevel& nearest);

  const RowsAndCandidates& watched_;
  std::vector<Direction> directions_;  // directions; the displacement of the base comes first
  ChiSquareLimit innovation_limit_;
  std::vector<Sums> sums_;           // sums_[k]: over the first k measurements
  Eigen::LLT<Eigen::MatrixXd> all_;  // factor of the information on z from all measurements so far
  Eigen::MatrixXd cross_, solved_;   // products for the tested start
  Eigen::VectorXd score_;
};

}  // namespace tubeplan::calibration
