#include "app/workbench/model.hpp"

namespace tubeplan::app {

ModelPointer makeModel(int id, std::string label, std::string origin, Cell cell) {
  auto model = std::make_shared<Model>();
  model->id = id;
  model->label = std::move(label);
  model->origin = std::move(origin);
  model->cell = std::move(cell);
  model->posed.arm = model->cell.arm;
  model->posed.X_WB = model->cell.X_WB;
  model->posed.scene = model->cell.scene;
  if (!model->cell.scene.bodies.empty())
    model->pairs = std::make_shared<const planner::NearestPairs>(model->cell.scene);
  return model;
}

}  // namespace tubeplan::app
