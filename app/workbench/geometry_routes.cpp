// Routes answered without a job: sheet, scene, postures, catalogue, confounding, tube selection and signatures.
#include "app/documents/effect_catalogue.hpp"
#include "app/documents/effect_words_json.hpp"
#include "app/documents/signature_json.hpp"
#include "app/storage/input_error.hpp"
#include "app/studies/model/cell_fit.hpp"
#include "app/workbench/geometry_json.hpp"
#include "app/workbench/job_routes.hpp"
#include "app/workbench/posture_answer.hpp"
#include "app/workbench/request_body.hpp"
#include "app/workbench/routes.hpp"
#include "app/workbench/state_json.hpp"
#include "calibration/diagnosis/causes/confounding.hpp"
#include "deflection/weights.hpp"

namespace tubeplan::app {

namespace {

Answer sheet(Workbench& workbench, const Request&) {
  const Session session = workbench.session();
  const Cell& cell = currentModel(session).cell;
  if (!cell.sheet)
    return refusal(
        404, InputError::problem(cell.path, "the cell has no key 'tubesheet'", "add the key, or open another cell"));
  return answerOf(sheetDrawing(cell, *cell.sheet));
}

Answer scene(Workbench& workbench, const Request&) {
  return answerOf(sceneDrawing(currentModel(workbench.session()).cell));
}

Answer pose(Workbench& workbench, const Request& request) {
  const auto body = objectOf(request);
  const Session session = workbench.session();
  const Model& model = currentModel(session);
  RequestedPosture question{jointsOf(body, model.cell), loadOf(body, model.cell), holeOf(body, model.cell)};
  return answerOf(answerPosture(model, question));
}

Answer catalogue(Workbench& workbench, const Request&) {
  return answerOf(catalogueJson(currentModel(workbench.session()).cell));
}

/// Returns the displacement of the tip by an effect, for the query ?effect=hysteresis&at=theta4.
Answer signature(Workbench& workbench, const Request& request) {
  constexpr double kOfWeight = 0.2;  // largest load as a fraction of the arm's weight if no measurement's is larger
  const Session session = workbench.session();
  const Cell& cell = currentModel(session).cell;
  double most_load = kOfWeight * deflection::weightOf(cell.arm);
  if (session.measurements)
    for (const auto& measurement : session.measurements->measurements)
      most_load = std::max(most_load, measurement.load);
  return answerOf(signatureJson(cell, request.parameter("effect"), request.parameter("at"), most_load));
}

// Largest number of measurements used, evenly spaced in the list; with more, the confounding would hardly change.
constexpr std::size_t kMostForConfounding = 300;

/// Returns, for each possible cause, how far the measurements in use can distinguish it from the fitted parameters and
/// from other causes.
Answer confounding(Workbench& workbench, const Request&) {
  const Session session = workbench.session();
  if (!session.measurements) return refusal(404, withoutMeasurements());
  const Cell& cell = currentModel(session).cell;
  const auto all = measurementsInUse(*session.measurements);
  std::vector<calibration::Measurement> some;
  for (std::size_t k = 0; k < all.size(); k += (all.size() + kMostForConfounding - 1) / kMostForConfounding)
    some.push_back(all[k]);
  auto placed = startOf(cell, all);
  const auto fitted = calibration::chooseUnknowns(placed, freeNumbersOf(cell)).list;
  nlohmann::json causes = nlohmann::json::array();
  for (const auto& cause : calibration::findConfounding(placed, some, fitted)) {
    nlohmann::json list = nlohmann::json::array();
    for (const auto& other : cause.confounded) {
      list.push_back({{"effect", other.effect}, {"at", other.at}, {"share", other.share}});
      addCauseTitle(list.back());
    }
    causes.push_back({{"effect", cause.effect}, {"at", cause.at}, {"kept", cause.kept}, {"confounded", list}});
  }
  return answerOf({{"readings", some.size()}, {"causes", causes}});
}

Answer select(Workbench& workbench, const Request& request) {
  const auto body = objectOf(request);
  const Session session = workbench.session();
  const auto& sheet = requireSheet(currentModel(session).cell, "choose tubes");
  auto selection = selectedTubes(textOf(body, "text"), sheet);
  std::sort(selection.begin(), selection.end());
  return answerOf({{"holes", selection}});
}

constexpr Route kGeometryRoutes[] = {
    {"GET", "sheet", sheet},
    {"GET", "scene", scene},
    {"POST", "pose", pose},
    {"GET", "catalogue", catalogue},
    {"GET", "confounding", confounding},
    {"POST", "select", select},
    {"GET", "signature", signature},
};

}  // namespace

std::span<const Route> geometryRoutes() { return kGeometryRoutes; }

}  // namespace tubeplan::app
