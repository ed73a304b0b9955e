// Sheet, scene, postures and the catalogue: what is answered at once.
#include "app/documents/effect_catalogue.hpp"
#include "app/files/input_error.hpp"
#include "app/workbench/geometry_json.hpp"
#include "app/workbench/posture_answer.hpp"
#include "app/workbench/request_body.hpp"
#include "app/workbench/request_numbers.hpp"
#include "app/workbench/routes.hpp"
#include "app/workbench/state_json.hpp"

namespace tubeplan::app {

namespace {

Answer sheet(Workbench& workbench, const Request&) {
  const Session session = workbench.session();
  const Cell& cell = currentModel(session).cell;
  if (!cell.sheet) return refusal(404, InputError(cell.path, "no key 'tubesheet'", "one"));
  return answerOf(sheetDrawing(cell, *cell.sheet));
}

Answer scene(Workbench& workbench, const Request&) {
  return answerOf(sceneDrawing(currentModel(workbench.session()).cell));
}

Answer pose(Workbench& workbench, const Request& request) {
  const auto body = objectOf(request);
  const Session session = workbench.session();
  const Model& model = currentModel(session);
  PostureQuestion question{jointsOf(body, model.cell), loadOf(body, model.cell), holeOf(body, model.cell)};
  return answerOf(answerPosture(model, question));
}

Answer catalogue(Workbench& workbench, const Request&) {
  return answerOf(catalogueJson(currentModel(workbench.session()).cell));
}

Answer select(Workbench& workbench, const Request& request) {
  const auto body = objectOf(request);
  const Session session = workbench.session();
  const auto& sheet = requireSheet(currentModel(session).cell, "choose tubes");
  auto selection = selectedTubes(textOf(body, "text"), sheet);
  std::sort(selection.begin(), selection.end());
  return answerOf({{"holes", selection}});
}

constexpr Route kRoutes[] = {
    {"GET", "sheet", sheet},         {"GET", "scene", scene},    {"POST", "pose", pose},
    {"GET", "catalogue", catalogue}, {"POST", "select", select},
};

}  // namespace

std::span<const Route> geometryRoutes() { return kRoutes; }

}  // namespace tubeplan::app
