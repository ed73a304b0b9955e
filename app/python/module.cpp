// The Python module `tubeplan`: batches of arm poses as NumPy arrays, and the commands on cells and measurements.
// Commands return dictionaries with the keys of their --json output. Arrays are in metres, radians and newtons;
// dictionaries are in the cell's own units.
#include <pybind11/eigen.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <atomic>
#include <filesystem>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <thread>

#include "app/documents/plan_files.hpp"
#include "app/documents/plan_outcome.hpp"
#include "app/documents/pose_json.hpp"
#include "app/formats/cell/cell_places.hpp"
#include "app/formats/cell/cell_writer.hpp"
#include "app/formats/measurements/measurement_input.hpp"
#include "app/jobs/comparison.hpp"
#include "app/jobs/diagnosis.hpp"
#include "app/jobs/identification.hpp"
#include "app/jobs/plan.hpp"
#include "app/storage/atomic_file.hpp"
#include "app/storage/input_error.hpp"
#include "app/storage/origin.hpp"
#include "app/studies/job_steps.hpp"
#include "app/version.hpp"
#include "deflection/kinematics.hpp"
#include "deflection/side_chains.hpp"

namespace tubeplan::app {

namespace {

namespace py = pybind11;
using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

py::object toPython(const nlohmann::json& json) { return py::module_::import("json").attr("loads")(json.dump()); }

/// Stop condition by which Ctrl-C ends long work, as in the terminal. Only the calling thread detects the signal; then
/// all threads stop.
class Interruption {
 public:
  bool operator()() const {
    if (std::this_thread::get_id() != caller_ || *is_seen_) return *is_seen_;
    const py::gil_scoped_acquire gil;
    if (PyErr_CheckSignals() != 0) *is_seen_ = true;
    return *is_seen_;
  }

 private:
  std::thread::id caller_ = std::this_thread::get_id();
  std::shared_ptr<std::atomic<bool>> is_seen_ = std::make_shared<std::atomic<bool>>(false);
};

/// Runs `work` without Python's global interpreter lock, so that other Python threads can run.
template <class Work>
auto withoutLock(Work&& work) {
  const py::gil_scoped_release released;
  return work();
}

/// Returns rotation matrices as one N x 3 x 3 array.
py::array_t<double> stacked(const std::vector<Eigen::Matrix3d>& rotations) {
  py::array_t<double> out({static_cast<py::ssize_t>(rotations.size()), py::ssize_t{3}, py::ssize_t{3}});
  auto at = out.mutable_unchecked<3>();
  for (std::size_t k = 0; k < rotations.size(); ++k)
    for (py::ssize_t i = 0; i < 3; ++i)
      for (py::ssize_t j = 0; j < 3; ++j) at(static_cast<py::ssize_t>(k), i, j) = rotations[k](i, j);
  return out;
}

class PythonCell {
 public:
  /// Stores the absolute path, because a Python program may change its working directory.
  explicit PythonCell(const std::filesystem::path& path)
      : path_(path.empty() ? "" : std::filesystem::absolute(path).string()), cell_(readCell(path.string())) {}

  [[nodiscard]] std::string name() const { return cell_.name; }
  [[nodiscard]] Eigen::Matrix4d base() const { return cell_.X_WB.matrix(); }
  [[nodiscard]] py::object baseStanding() const { return toPython(standingJson(standingOf(cell_))); }

  [[nodiscard]] std::vector<std::string> joints() const { return deflection::jointNames(cell_.arm); }

  [[nodiscard]] Rows limits() const {
    Rows limits(cell_.arm.jointCount(), 2);
    for (Eigen::Index k = 0; k < cell_.arm.jointCount(); ++k) {
      const auto& joint = cell_.arm.joint(k);
      limits.row(k) << joint.lower, joint.upper;
    }
    return limits;
  }

  /// Returns the deflected tip poses in the world frame: N x 3 positions [m], N x 3 x 3 rotations of the tool frame,
  /// and N flags, true if the deflected shape converged.
  [[nodiscard]] py::tuple poses(const Rows& q, double load) const {
    const auto joints = cell_.arm.jointCount();
    if (q.cols() != joints)
      throw py::value_error("q has " + std::to_string(q.cols()) + " columns, expected one for each of the " +
                            std::to_string(joints) + " joints, and a row for each posture: q[None, :] of a single one");
    if (!(load >= 0)) throw py::value_error("load is " + std::to_string(load) + ", expected 0 N or more");
    if (!deflection::sideJoints(cell_.arm).empty())
      throw py::value_error("the arm has side chains with joints of their own, which poses() does not take");
    deflection::PostureBatch postures;
    postures.resize(joints, q.rows(), load, deflection::gravityInBase(cell_.arm, cell_.X_WB));
    postures.q = q.transpose();
    deflection::TipBatch tips;
    withoutLock([&] { deflection::Kinematics(cell_.arm).solve(postures, tips); });
    Rows places(q.rows(), 3);
    std::vector<Eigen::Matrix3d> turns;
    std::vector<bool> converged;
    for (Eigen::Index k = 0; k < q.rows(); ++k) {
      const auto X_BD = tips.X_BD(k);
      places.row(k) = (cell_.X_WB * X_BD.p).transpose();
      turns.emplace_back(cell_.X_WB.linear() * X_BD.R * toolFrame(cell_.arm));
      converged.push_back(tips.status[static_cast<std::size_t>(k)] == deflection::KinematicsStatus::kConverged);
    }
    return py::make_tuple(places, stacked(turns), py::array(py::cast(converged)));
  }

  [[nodiscard]] py::object identify(const MeasurementFiles& files, const std::vector<std::string>& free,
                                    const std::string& robust, int folds, std::uint64_t seed,
                                    const std::string& out) const {
    IdentificationRequest request;
    request.free = free;
    request.robust = robust;
    request.folds = folds;
    request.seed = seed;
    return run([&] {
      const CellMeasurements input = readCellMeasurements(path_, files);
      if (!out.empty()) checkWritableCellAndArm(input.cell, out, "out");
      auto identified = identifyModel(input, request, hooks());
      if (!out.empty() && identified.fit.status == calibration::IdentificationStatus::kDone)
        writeFilesTogether(identifiedCell(input.cell, identified.fit, identified.measurements, out).inOrder(), "out");
      return identified.figures;
    });
  }

  [[nodiscard]] py::object diagnose(const MeasurementFiles& files, std::uint64_t seed) const {
    DiagnosisRequest request;
    request.seed = seed;
    return run([&] { return diagnoseModel(readCellMeasurements(path_, files), request, hooks()).figures; });
  }

  [[nodiscard]] py::object compare(const MeasurementFiles& files, std::uint64_t seed) const {
    ComparisonRequest request;
    request.seed = seed;
    return run([&] { return compareModel(readCellMeasurements(path_, files), request, hooks()).figures; });
  }

  [[nodiscard]] py::object plan(const std::string& tubes, const std::string& compensation, double load,
                                std::uint64_t seed) const {
    PlanRequest request;
    request.cell = path_;
    request.tubes = tubes;
    request.compensation = compensation;
    request.load = load;
    request.seed = seed;
    planner::PlanHooks asked;
    asked.stop = Interruption();
    return run([&] { return planJson(request, planCell(readCell(path_), request, asked)); });
  }

 private:
  static calibration::WorkHooks hooks() {
    calibration::WorkHooks asked;
    asked.stop = Interruption();
    return asked;
  }

  /// Runs a command's work. If Ctrl-C ends the work, raises Python's KeyboardInterrupt.
  static py::object run(const std::function<nlohmann::json()>& work) {
    const nlohmann::json figures = withoutLock([&] {
      const InputRecord inputs;
      nlohmann::json document = work();
      stateOrigin(document);
      return document;
    });
    if (PyErr_Occurred()) throw py::error_already_set();
    return toPython(figures);
  }

  std::string path_;
  Cell cell_;
};

}  // namespace

}  // namespace tubeplan::app

PYBIND11_MODULE(tubeplan, module) {
  using tubeplan::app::PythonCell;
  namespace py = pybind11;
  module.doc() = "Flexible robot arms under tube sheets: posed, identified, diagnosed, planned.";
  module.attr("__version__") = tubeplan::app::kVersion;
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const tubeplan::app::InputError& error) {
      PyErr_SetString(PyExc_ValueError, error.what());
    } catch (const tubeplan::app::JobStopped&) {
      if (!PyErr_Occurred()) PyErr_SetNone(PyExc_KeyboardInterrupt);
    }
  });
  py::class_<PythonCell>(module, "Cell", "A cell's file and the arm's beside it. A wrong file raises ValueError.")
      .def(py::init<const std::filesystem::path&>(), py::arg("path"))
      .def_property_readonly("name", &PythonCell::name)
      .def_property_readonly("joints", &PythonCell::joints, "Names of the joints, in the order of every q.")
      .def_property_readonly("limits", &PythonCell::limits, "Lowest and highest reading of each joint [rad, m].")
      .def_property_readonly("base", &PythonCell::base, "Pose of the base in the world, 4 x 4 [m].")
      .def_property_readonly("base_standing", &PythonCell::baseStanding,
                             "How that base was placed: status, words, whether it is placed, number of touches.")
      .def("poses", &PythonCell::poses, py::arg("q"), py::arg("load") = 0.0,
           "Deflected tips of N postures q (N x joints) [rad, m] under a hung load [N]: places (N x 3) [m] and tool "
           "frames (N x 3 x 3) in the world, and whether each shape converged.")
      .def("identify", &PythonCell::identify, py::arg("measurements"), py::arg("free") = std::vector<std::string>{},
           py::arg("robust") = "none", py::arg("folds") = 5, py::arg("seed") = 1, py::arg("out") = "",
           "Fits the freed numbers to files of readings; `out` writes the cell with what was found.")
      .def("diagnose", &PythonCell::diagnose, py::arg("measurements"), py::arg("seed") = 1,
           "Which physical effect is missing, and what to read next.")
      .def("compare", &PythonCell::compare, py::arg("measurements"), py::arg("seed") = 1,
           "Where the model fails, and what its error follows.")
      .def("plan", &PythonCell::plan, py::arg("tubes") = "all", py::arg("compensation") = "via-point",
           py::arg("load") = 0.0, py::arg("seed") = 1,
           "Plans the visits of tubes under a load in the cell's unit, the base where the cell has it.");
}
