// Additions to a cell's model, to be fitted together with the rest: catalogue effects, user formulas, and parameters of
// the arm file that were held fixed.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/formats/measurements/measurement_input.hpp"
#include "app/studies/model/explained_model.hpp"

namespace tubeplan::app {

/// Requested additions, in the syntax of the command line. A cause is `EFFECT@AT`, `EFFECT@AT:NUMBER=VALUE,...` (with
/// values, as a diagnosis prints them), `EFFECT@all joints`, `free@NAME` or `free@geometry`. A formula is `TARGET +=
/// EXPRESSION`. With a formula, `causes` may also contain `formula@TARGET`.
struct AdditionRequest {
  std::vector<std::string> causes;
  std::string formula;
};

struct Addition : AddedCauses {
  Cell cell;  ///< the cell with all additions, as if read back from a written cell file
};

/// Adds the causes to the cell. Throws InputError for an empty request, for an effect that the cell already has, and
/// for a cause or formula that cannot be parsed.
[[nodiscard]] Addition addToCell(const Cell& cell, const AdditionRequest& request);

/// Returns the cell without the given causes. `EFFECT@AT` removes an effect and its parameters from `identify`.
/// `free@NAME` removes a name from `identify`, so that the parameter is held at its current value. Throws InputError
/// for a cause that the cell does not have.
[[nodiscard]] Cell withoutCauses(const Cell& cell, const std::vector<std::string>& causes);

/// Returns the text of the cell file with the additions, to be written to the path `out`.
[[nodiscard]] std::string cellTextWith(const Cell& cell, const Addition& addition, const std::filesystem::path& out);

/// Returns a text that states to what extent other parameters and effects of the catalogue can reproduce the cell's
/// formulas at these measurements.
[[nodiscard]] std::string overlapAt(const CellMeasurements& input);

}  // namespace tubeplan::app
