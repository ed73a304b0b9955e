#include "app/python/cell_arrays.hpp"

#include <pybind11/stl.h>

#include <nlohmann/json.hpp>

#include "app/documents/pose_json.hpp"
#include "app/python/python_hooks.hpp"
#include "app/storage/input_error.hpp"
#include "app/studies/positioning/base_standing.hpp"
#include "deflection/inverse/inverse_solver.hpp"
#include "deflection/kinematics.hpp"
#include "deflection/side_chains.hpp"
#include "tubesheets/tube.hpp"

namespace tubeplan::app {

namespace py = pybind11;

namespace {

/// Branches of several goals, one entry for each branch.
struct FlatBranches {
  std::vector<Eigen::Index> goals;
  std::vector<Eigen::VectorXd> readings;
  std::vector<std::string> statuses;
  std::vector<double> errors, tilts;

  void add(Eigen::Index goal, const deflection::Branch& branch) {
    goals.push_back(goal);
    readings.push_back(branch.q);
    statuses.emplace_back(nameOf(branch.status));
    errors.push_back(branch.position_error);
    tilts.push_back(branch.tilt);
  }
};

Rows stacked(const std::vector<Eigen::VectorXd>& rows, Eigen::Index columns) {
  Rows out = Rows::Constant(std::ssize(rows), columns, std::numeric_limits<double>::quiet_NaN());
  for (std::size_t k = 0; k < rows.size(); ++k)
    if (rows[k].size() == columns) out.row(static_cast<Eigen::Index>(k)) = rows[k].transpose();
  return out;
}

}  // namespace

std::string CellArrays::baseStanding() const { return standingJson(standingOf(cell_)).dump(); }

std::vector<std::string> CellArrays::joints() const { return deflection::jointNames(cell_.arm); }

Eigen::Vector3d CellArrays::toolAxis() const { return toolFrame(cell_.arm).transpose() * cell_.arm.tool_axis_L; }

Rows CellArrays::limits() const {
  Rows limits(cell_.arm.jointCount(), 2);
  for (Eigen::Index k = 0; k < cell_.arm.jointCount(); ++k) {
    const auto& joint = cell_.arm.joint(k);
    limits.row(k) << joint.lower, joint.upper;
  }
  return limits;
}

void CellArrays::requireNoSideJoints(const char* what) const {
  if (!deflection::sideJoints(cell_.arm).empty())
    throw InputError::problem(
        cell_.path, std::string("the arm has side chains with joints of their own, which ") + what + " does not take",
        "use pose(joints=..., side_joints=...) for each posture");
}

py::tuple CellArrays::poses(const Rows& q, const Eigen::VectorXd& load) const {
  requireNoSideJoints("poses()");
  deflection::PostureBatch postures;
  postures.resize(cell_.arm.jointCount(), q.rows(), 0, deflection::gravityInBase(cell_.arm, cell_.X_WB));
  postures.q = q.transpose();
  postures.load = load;
  deflection::TipBatch tips;
  withoutLock([&] { deflection::Kinematics(cell_.arm).solve(postures, tips); });
  py::array_t<double> poses({q.rows(), Eigen::Index{4}, Eigen::Index{4}});
  py::array_t<bool> converged(q.rows());
  auto is_converged = converged.mutable_unchecked<1>();
  const Eigen::Matrix3d tool = toolFrame(cell_.arm);
  for (Eigen::Index k = 0; k < q.rows(); ++k) {
    const auto X_BD = tips.X_BD(k);
    Eigen::Map<Eigen::Matrix<double, 4, 4, Eigen::RowMajor>> pose(poses.mutable_data(k, 0, 0));
    pose.setIdentity();
    pose.topLeftCorner<3, 3>() = cell_.X_WB.linear() * X_BD.R * tool;
    pose.topRightCorner<3, 1>() = cell_.X_WB * X_BD.p;
    is_converged(k) = tips.status[static_cast<std::size_t>(k)] == deflection::KinematicsStatus::kConverged;
  }
  return py::make_tuple(poses, converged);
}

py::tuple CellArrays::inverse(const Rows& places, const Rows& axes, double load) const {
  requireNoSideJoints("inverse()");
  const Eigen::Isometry3d X_BW = cell_.X_WB.inverse();
  std::vector<deflection::ToolGoal> goals;
  for (Eigen::Index k = 0; k < places.rows(); ++k)
    goals.push_back({X_BW * Eigen::Vector3d(places.row(k)), X_BW.linear() * Eigen::Vector3d(axes.row(k)).normalized()});
  FlatBranches flat;
  std::vector<std::string> statuses, reasons;
  withoutLock([&] {
    deflection::InverseSolver solver(cell_.arm, load, deflection::gravityInBase(cell_.arm, cell_.X_WB));
    Eigen::Index goal = 0;
    for (const auto& found : solver.solve(goals)) {
      for (const auto& branch : found.branches) flat.add(goal, branch);
      statuses.emplace_back(nameOf(found.status));
      reasons.push_back(found.reason);
      ++goal;
    }
  });
  return py::make_tuple(py::array(py::cast(flat.goals)), stacked(flat.readings, cell_.arm.jointCount()), flat.statuses,
                        py::array(py::cast(flat.errors)), py::array(py::cast(flat.tilts)), statuses, reasons);
}

py::tuple CellArrays::holes() const {
  const tubesheets::Sheet& sheet = requireSheet(cell_, "list its holes");
  const auto count = std::ssize(sheet.tubes);
  py::array_t<int> rows(count), columns(count);
  Rows centres = Rows::Zero(count, 3);
  std::vector<std::string> states;
  for (Eigen::Index k = 0; k < count; ++k) {
    const auto& tube = sheet.tubes[static_cast<std::size_t>(k)];
    rows.mutable_at(k) = tube.row;
    columns.mutable_at(k) = tube.column;
    centres.row(k).head<2>() << tube.x, tube.y;
    states.emplace_back(tubesheets::tubeStateName(tube.state));
  }
  return py::make_tuple(rows, columns, centres, states);
}

}  // namespace tubeplan::app
