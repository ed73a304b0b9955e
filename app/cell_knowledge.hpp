// What a cell and its readings tell of the model, for commands that look ahead.
#pragma once

#include <string>
#include <vector>

#include "app/readers/cell_reader.hpp"
#include "calibration/knowledge.hpp"

namespace tubeplan::app {

/// The readings of a measurement file with a sigma each; none for an empty name. `sigma` [m] stands in where the file
/// states none; 0: InputError then, unless the cell's tool tells it.
[[nodiscard]] std::vector<calibration::Measurement> readingsMade(const std::string& file, const Cell& cell,
                                                                 double sigma);

/// What the readings tell of the free numbers. `where` names what they were asked by, for the InputError about a name
/// that is no number of the arm.
[[nodiscard]] calibration::Knowledge knowledgeOf(const Cell& cell,
                                                 const std::vector<calibration::Measurement>& readings,
                                                 const calibration::FreeChoice& free, const std::string& where);

/// The cell with arm and base as known.
[[nodiscard]] Cell cellAsKnown(Cell cell, const calibration::Knowledge& knowledge);

}  // namespace tubeplan::app
