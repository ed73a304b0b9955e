// Fingerprint of the numbers in a path. It detects a path that was altered or belongs to another plan.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace tubeplan::app {

class PathNumbers {
 public:
  /// Adds one row of the path, in file units; `segment` counts from 1, as in path.csv.
  void add(double time, int segment, const Eigen::VectorXd& joints);

  /// Returns the fingerprint of all rows added so far, which depends on every bit of the numbers, but not on their
  /// notation.
  [[nodiscard]] std::string fingerprint() const;

 private:
  std::vector<double> numbers_;
};

}  // namespace tubeplan::app
