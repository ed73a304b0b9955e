#include "app/python/command_calls.hpp"

#include <fstream>
#include <nlohmann/json.hpp>

#include "app/cli/caller.hpp"
#include "app/cli/command.hpp"
#include "app/cli/stop_signal.hpp"
#include "app/commands/command_line.hpp"
#include "app/commands/command_words.hpp"
#include "app/documents/converted_figures.hpp"
#include "app/documents/figure_list.hpp"
#include "app/formats/cell/cell_reader.hpp"
#include "app/outage/job_store.hpp"
#include "app/python/python_hooks.hpp"
#include "app/storage/input_error.hpp"
#include "app/studies/job_steps.hpp"

namespace tubeplan::app {

namespace {

namespace py = pybind11;
using nlohmann::json;

/// Runs a command for a caller. Returns kStoppedExitCode if the work was stopped.
int runFor(CommandCaller& caller, const std::vector<std::string>& words) {
  const CalledBy called(caller);
  try {
    return runCommandLine(words);
  } catch (const JobStopped& stopped) {
    remark("stopped; {}\n", stopped.kept.empty() ? "nothing was written" : stopped.kept);
    return kStoppedExitCode;
  }
}

/// Throws the exception that stopped the work. An interruption states which results were kept.
[[noreturn]] void raise(const py::error_already_set& error, const std::string& remarks) {
  if (!error.matches(PyExc_KeyboardInterrupt) || remarks.empty()) throw error;
  PyErr_SetString(PyExc_KeyboardInterrupt, remarks.substr(0, remarks.find_last_not_of('\n') + 1).c_str());
  throw py::error_already_set();
}

std::vector<JointInFile> jointsOf(const deflection::Arm& arm) {
  std::vector<JointInFile> joints;
  for (Eigen::Index k = 0; k < arm.jointCount(); ++k)
    joints.push_back({arm.joint(k).name, arm.joint(k).type == deflection::JointType::kPrismatic});
  return joints;
}

std::vector<JointInFile> jointsOfFile(const std::string& file) {
  if (file.empty()) return {};
  try {
    return jointsOf(readCell(file).arm);
  } catch (const InputError&) {
    return {};  // the command's input was a project or another file, not a cell
  }
}

bool isRecord(const std::string& path) {
  std::string head(15, '\0');
  std::ifstream(path, std::ios::binary).read(head.data(), 15);
  return head == "SQLite format 3";
}

json siFactors(const Units& units) {
  json factors;
  for (const auto& [name, dimension] : {std::pair("LENGTH", dimension::kLength), std::pair("ANGLE", dimension::kAngle),
                                        std::pair("FORCE", dimension::kForce), std::pair("TORQUE", dimension::kTorque)})
    factors[name] = units.factor(dimension);
  return factors;
}

}  // namespace

py::tuple callCommand(const std::vector<std::string>& words, const std::string& file, bool are_si,
                      const py::object& progress) {
  PythonHooks python(progress);
  CommandCaller caller;
  caller.hooks = python.hooks();
  const int code = withoutLock([&] {
    try {
      const int exit_code = runFor(caller, words);
      if (are_si && !caller.figures.is_null())
        caller.figures = inUnits(caller.figures, {.joints = jointsOfFile(file)}, TargetUnits::si());
      return exit_code;
    } catch (const InputError&) {
      if (!python.error()) throw;
      return kStoppedExitCode;
    }
  });
  if (python.error()) raise(*python.error(), caller.remarks);
  py::object figures = py::none();
  if (!caller.figures.is_null()) figures = py::str(caller.figures.dump());
  return py::make_tuple(code, caller.output, caller.remarks, figures);
}

int callForTerminal(const std::vector<std::string>& words) {
  try {
    return withoutLock([&] { return runCommandLine(words); });
  } catch (const JobStopped& stopped) {
    remark("stopped; {}\n", stopped.kept.empty() ? "nothing was written" : stopped.kept);
    return kStoppedExitCode;
  } catch (const InputError& error) {
    remark("tubeplan: {}\n", error.what());
    return kBadInput;
  }
}

std::string commandsJson() {
  json commands = json::array();
  for (const auto& command : commandWords()) {
    json options = json::array();
    for (const auto& option : command.options)
      options.push_back({{"names", option.names},
                         {"value", option.value},
                         {"description", option.description},
                         {"initial", option.initial},
                         {"positional", option.is_positional},
                         {"required", option.is_required},
                         {"several", option.is_list},
                         {"delimiter", option.delimiter ? std::string(1, option.delimiter) : ""}});
    commands.push_back(
        {{"name", command.name}, {"summary", command.summary}, {"example", command.example}, {"options", options}});
  }
  return commands.dump();
}

std::string unitsOfFile(const std::string& path) {
  if (isRecord(path)) return siFactors(JobStore(path, Database::Mode::kRead).job().units).dump();
  const Cell cell = readCell(path);
  json units = siFactors(cell.units);
  units["joints"] = json::array();
  for (const auto& joint : jointsOf(cell.arm)) units["joints"].push_back(joint.is_slide ? "LENGTH" : "ANGLE");
  return units.dump();
}

std::string figureListJson(const std::string& document) {
  json list = json::array();
  for (const Figure& figure : figuresOf(json::parse(document)))
    list.push_back({{"list", figure.list},
                    {"row", figure.row},
                    {"column", figure.column},
                    {"key", figure.key()},
                    {"description", figure.description},
                    {"value", figure.value},
                    {"unit", figure.unit},
                    {"note", figure.note}});
  return list.dump();
}

}  // namespace tubeplan::app
