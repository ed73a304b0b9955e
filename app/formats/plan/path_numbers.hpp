// The numbers of a path's rows, in the file's units: what distinguishes a path from an altered one, or from another
// plan's.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace tubeplan::app {

class PathNumbers {
 public:
  /// Of one row; `segment` as the file counts, from 1.
  void add(double time, int segment, const Eigen::VectorXd& joints);

  /// Of all rows so far, to the last bit of every number, however it is written.
  [[nodiscard]] std::string fingerprint() const;

 private:
  std::vector<double> numbers_;
};

}  // namespace tubeplan::app
