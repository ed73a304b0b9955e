#include "app/cell_knowledge.hpp"

#include "app/input_error.hpp"
#include "app/reading_input.hpp"
#include "app/suggestion.hpp"

namespace tubeplan::app {

std::vector<calibration::Measurement> readingsMade(const std::string& file, const Cell& cell, double sigma) {
  if (file.empty()) return {};
  return readReadings(file, cell, sigma / cell.units.factor(dimension::kLength));
}

calibration::Knowledge knowledgeOf(const Cell& cell, const std::vector<calibration::Measurement>& readings,
                                   const calibration::FreeChoice& free, const std::string& where) {
  auto knowledge = calibration::learnFrom(cell.arm, cell.X_WB, cell.base_known, readings, free);
  if (knowledge.problems.empty()) return knowledge;
  const auto& problem = knowledge.problems.front();
  const auto known = calibration::freeableNames(cell.arm);
  throw InputError(where, problem.found, problem.expected, suggestion(problem.name, known));
}

Cell cellAsKnown(Cell cell, const calibration::Knowledge& knowledge) {
  const auto placed = calibration::placedAsKnown(knowledge);
  cell.arm = placed.arm;
  cell.X_WB = placed.placings.back().X_WB;
  return cell;
}

}  // namespace tubeplan::app
