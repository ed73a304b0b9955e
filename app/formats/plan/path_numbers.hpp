// Numbers of a path's rows in the file's units, to distinguish a path from an altered one or from another plan's.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace tubeplan::app {

class PathNumbers {
 public:
  /// Adds one row; `segment` counts from 1, as in the file.
  void add(double time, int segment, const Eigen::VectorXd& joints);

  /// Returns the fingerprint of all rows so far. It depends on every bit of the numbers, but not on their notation.
  [[nodiscard]] std::string fingerprint() const;

 private:
  std::vector<double> numbers_;
};

}  // namespace tubeplan::app
