// A cell's arm and sheet as arrays, in m, rad and N, in the world frame.
#pragma once

#include <pybind11/eigen.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <string>
#include <vector>

#include "app/formats/cell/cell_reader.hpp"

namespace tubeplan::app {

using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// A cell as it was read. All functions are const and may be called from several threads.
class CellArrays {
 public:
  explicit CellArrays(const std::string& path) : cell_(readCell(path)) {}

  [[nodiscard]] std::string name() const { return cell_.name; }
  [[nodiscard]] Eigen::Matrix4d base() const { return cell_.X_WB.matrix(); }
  /// Returns the source of the base pose, as JSON.
  [[nodiscard]] std::string baseStanding() const;
  [[nodiscard]] std::vector<std::string> joints() const;
  /// Returns the direction in which the tool enters a hole, in the tool frame.
  [[nodiscard]] Eigen::Vector3d toolAxis() const;
  /// Returns the lowest and highest reading of each joint.
  [[nodiscard]] Rows limits() const;

  /// Returns the poses of the deflected tip's tool frame, N x 4 x 4, and N flags, true if the shape converged. `q` is N
  /// x joints, `load` has N entries.
  [[nodiscard]] pybind11::tuple poses(const Rows& q, const Eigen::VectorXd& load) const;

  /// Returns all branches of N goals, each a position and a direction of the tool's axis. For each branch: the
  /// index of its goal, the joint values, the status, and the errors of position and direction. For each
  /// goal: status and reason.
  [[nodiscard]] pybind11::tuple inverse(const Rows& places, const Rows& axes, double load) const;

  /// Returns the sheet's holes: rows, columns, centres on the lower face (N x 3), and the names of their states.
  [[nodiscard]] pybind11::tuple holes() const;

 private:
  void requireNoSideJoints(const char* what) const;

  Cell cell_;
};

}  // namespace tubeplan::app
