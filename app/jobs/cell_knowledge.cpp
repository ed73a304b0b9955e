#include "app/jobs/cell_knowledge.hpp"

#include "app/files/input_error.hpp"
#include "app/files/reading_input.hpp"
#include "app/files/suggestion.hpp"

namespace tubeplan::app {

ReadingsWithChecks readingsMade(const std::string& file, Cell& cell, double sigma,
                                const std::vector<std::string>& assume) {
  if (file.empty()) return {};
  return readAndCheck({file}, cell, {sigma / cell.units.factor(dimension::kLength), {}, assume});
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
