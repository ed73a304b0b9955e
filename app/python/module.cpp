// The module `tubeplan._core`, on which the Python package `tubeplan` is built: the program's commands, and batches of
// postures as arrays.
#include <pybind11/stl.h>

#include <filesystem>

#include "app/python/cell_arrays.hpp"
#include "app/python/command_calls.hpp"
#include "app/storage/missing_file.hpp"
#include "app/version.hpp"

namespace {

namespace py = pybind11;
using tubeplan::app::InputError;

/// Raises the Python exception for input that cannot be used.
void raiseInputError(const InputError& error) {
  const auto errors = py::module_::import("tubeplan.errors");
  const py::object raised =
      errors.attr("input_error")(error.where(), error.found(), error.expected(), error.advice(),
                                 dynamic_cast<const tubeplan::app::MissingFile*>(&error) != nullptr);
  PyErr_SetObject(reinterpret_cast<PyObject*>(Py_TYPE(raised.ptr())), raised.ptr());
}

}  // namespace

PYBIND11_MODULE(_core, module) {
  using tubeplan::app::CellArrays;
  module.attr("version") = tubeplan::app::kVersion;
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const InputError& error) {
      raiseInputError(error);
    } catch (const std::filesystem::filesystem_error& error) {
      raiseInputError(tubeplan::app::inputErrorOf(error));
    }
  });
  module.def("call", &tubeplan::app::callCommand, py::arg("words"), py::arg("file"), py::arg("si"),
             py::arg("progress"));
  module.def("call_for_terminal", &tubeplan::app::callForTerminal, py::arg("words"));
  module.def("commands", &tubeplan::app::commandsJson);
  module.def("units_of", &tubeplan::app::unitsOfFile, py::arg("path"));
  module.def("figure_list", &tubeplan::app::figureListJson, py::arg("document"));
  py::class_<CellArrays>(module, "CellArrays")
      .def(py::init<const std::string&>(), py::arg("path"))
      .def_property_readonly("name", &CellArrays::name)
      .def_property_readonly("joints", &CellArrays::joints)
      .def_property_readonly("limits", &CellArrays::limits)
      .def_property_readonly("tool_axis", &CellArrays::toolAxis)
      .def_property_readonly("base", &CellArrays::base)
      .def_property_readonly("base_standing", &CellArrays::baseStanding)
      .def("poses", &CellArrays::poses, py::arg("q"), py::arg("load"))
      .def("inverse", &CellArrays::inverse, py::arg("places"), py::arg("axes"), py::arg("load"))
      .def("holes", &CellArrays::holes);
}
