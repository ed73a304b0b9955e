// Routes for downloads, with the contents that the commands write, and for saving the model in the opened folder.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "app/documents/diagnosis_pages.hpp"
#include "app/documents/ladder_json.hpp"
#include "app/documents/plan_files.hpp"
#include "app/documents/trajectory_yaml.hpp"
#include "app/documents/work_list_export.hpp"
#include "app/formats/cell/cell_places.hpp"
#include "app/formats/cell/cell_writer.hpp"
#include "app/formats/measurements/measurements_writer.hpp"
#include "app/formats/sheet/touch_input.hpp"
#include "app/report/plan_report.hpp"
#include "app/storage/atomic_file.hpp"
#include "app/storage/input_error.hpp"
#include "app/workbench/job_routes.hpp"
#include "app/workbench/project.hpp"
#include "app/workbench/request_body.hpp"
#include "app/workbench/routes.hpp"
#include "app/workbench/urdf_export.hpp"

namespace tubeplan::app {

namespace {

const PlanOutcome& planOf(const Session& session) {
  if (!session.plan)
    throw InputError::problem("export", "there is no plan yet", "plan tube visits first (POST /api/plan)");
  return *session.plan;
}

nlohmann::json figuresOf(const Session& session, const std::string& name) {
  const auto result = findResult(session, name);
  if (!result)
    throw InputError::problem("export", "there is no result of '" + name + "' yet",
                              "compute it first (POST /api/" + name + ")");
  return result->document;
}

/// Returns the measurements with the model for which the named result was computed.
CellMeasurements inputOfResult(const Session& session, const std::string& name) {
  CellMeasurements input = inputOf(session);
  const int id = findResult(session, name)->model;
  for (const auto& model : session.models)
    if (model->id == id) input.cell = model->cell;
  return input;
}

/// Returns the cell file and, if the cell has one, the arm file, which refer to each other.
std::vector<TextFile> exportedFiles(const Session& s) {
  const Cell& cell = currentModel(s).cell;
  return cellFiles(cell, std::filesystem::path(cell.path).replace_filename("cell.yaml"));
}
std::string exportedCell(const Session& s) { return exportedFiles(s).front().text; }
std::string exportedArm(const Session& s) {
  const auto files = exportedFiles(s);
  if (files.size() < 2)
    throw InputError::problem("export", "the cell has no arm file of its own",
                              "export cell.yaml, which contains the arm");
  return files.back().text;
}
std::string exportedMeasurements(const Session& s) {
  const CellMeasurements input = inputOf(s);  // throws InputError if there are no measurements
  return measurementsCsv(s.measurements->measurements, input.cell.arm, input.cell.units);
}
/// Returns the touches as CSV; a comment above the header lists the simulated touches.
std::string touchesText(const Session& s) {
  std::vector<calibration::Measurement> touches;
  std::vector<std::string> simulated;
  for (const auto& made : s.touches) {
    touches.push_back(made.touch);
    if (made.is_simulated) simulated.push_back(made.touch.id);
  }
  const std::string note =
      simulated.empty() ? "" : fmt::format("# simulated, not touched: {}\n", fmt::join(simulated, ", "));
  return note + touchesCsv(touches, currentModel(s).cell);
}
/// Returns an empty measurement table: only the header.
std::string exportedTemplate(const Session& s) {
  const Cell& cell = currentModel(s).cell;
  return measurementsCsv({}, cell.arm, cell.units);
}
/// Returns the measurements proposed by the diagnosis as a table with empty fields for the results.
std::string exportedRunSheet(const Session& s) {
  const auto figures = figuresOf(s, "diagnose");
  const auto sheet = figures.find("run_sheet");
  if (sheet == figures.end())
    throw InputError::problem("export", "the diagnosis proposes no readings",
                              "only a diagnosis without a conclusive verdict has a run sheet");
  return sheet->get<std::string>();
}
std::string exportedPlan(const Session& s) { return planFileText(s.plan_request, planOf(s)); }
std::string pathText(const Session& s) { return pathCsv(planOf(s)); }
std::string workListText(const Session& s) { return workListCsv(planOf(s)); }
std::string trajectoryText(const Session& s) { return trajectoryYaml(planOf(s)); }
std::string planReport(const Session& s) { return renderPlanReport(reportJson(s.plan_request, planOf(s))); }
std::string comparisonReport(const Session& s) {
  const auto figures = figuresOf(s, "compare");
  return comparisonPage(inputOfResult(s, "compare"), 1, figures);
}
/// Returns the results of the pattern tests on a model's errors; an empty array if the model was not compared.
nlohmann::json testedOf(const Session& s, int model) {
  const auto none = nlohmann::json::array();
  const auto compared = s.results.find("compare");
  if (compared == s.results.end() || !compared->second.contains(model)) return none;
  return compared->second.at(model)->document.value("tested", none);
}
std::string diagnosisReport(const Session& s) {
  const auto figures = figuresOf(s, "diagnose");
  return diagnosisPage(inputOfResult(s, "diagnose"), 1, figures, testedOf(s, findResult(s, "diagnose")->model));
}
std::string ladderReport(const Session& s) { return ladderPage(figuresOf(s, "ladder"), inputOf(s).file, 1); }

struct Export {
  std::string_view name, content_type;
  std::string (*text)(const Session&);
};
constexpr Export kExports[] = {
    {"cell.yaml", "application/yaml", exportedCell},
    {"cell-arm.yaml", "application/yaml", exportedArm},
    {"arm.urdf", "application/xml", exportedUrdf},
    {"measurements.csv", "text/csv", exportedMeasurements},
    {"template.csv", "text/csv", exportedTemplate},
    {"run-sheet.csv", "text/csv", exportedRunSheet},
    {"touches.csv", "text/csv", touchesText},
    {"plan.json", "application/json", exportedPlan},
    {"path.csv", "text/csv", pathText},
    {"worklist.csv", "text/csv", workListText},
    {"trajectory.yaml", "application/yaml", trajectoryText},
    {"project.tubeplan", "application/json", projectText},
    {"report.html", "text/html", planReport},
    {"compare.html", "text/html", comparisonReport},
    {"diagnose.html", "text/html", diagnosisReport},
    {"ladder.html", "text/html", ladderReport},
};

Answer download(Workbench& workbench, const Request& request) {
  const auto found = std::find_if(std::begin(kExports), std::end(kExports),
                                  [&](const Export& e) { return e.name == request.words[1]; });
  if (found == std::end(kExports))
    return refusal(404, InputError::problem(inQuotes(request.words[1]), "there is no export with this name",
                                            "docs/workbench_api.md lists the exports"));
  try {
    return downloadOf(std::string(found->name), std::string(found->content_type), found->text(workbench.session()));
  } catch (const InputError& error) {
    return refusal(404, error);
  }
}

/// Writes the current model and its arm file into the opened folder, for the request {"file", "overwrite"?}.
Answer saveCell(Workbench& workbench, const Request& request) {
  const auto body = objectOf(request);
  const std::string name = textOf(body, "file");
  const auto place = workbench.folder().fileToWrite(name);
  if (place.extension() != ".yaml") throw InputError("request (file)", inQuotes(name), "a name that ends in .yaml");
  const auto files = cellFiles(currentModel(workbench.session()).cell, place);
  requireReplaceable(place, files.size() > 1, "request (file)");
  nlohmann::json written = nlohmann::json::array();
  for (const auto& file : files) {
    const auto checked = workbench.folder().fileToWrite(file.path.filename().string());
    if (std::filesystem::exists(checked) && !booleanOf(body, "overwrite", false))
      return refusal(409, InputError::problem(checked.filename().string(), "this file already exists",
                                              "choose another name, or confirm that it is to be replaced"));
    written.push_back(checked.filename().string());
  }
  writeFilesTogether(files, "file");
  return answerOf({{"written", written}});
}

constexpr Route kExportRoutes[] = {
    {"GET", "export/*", download},
    {"POST", "cell/save", saveCell},
};

}  // namespace

std::span<const Route> exportRoutes() { return kExportRoutes; }

}  // namespace tubeplan::app
