// A cell with more in its model, to be fitted with the rest: effects of the catalogue, the user's own formulas, and
// numbers of the arm's file that were held.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/files/reading_input.hpp"
#include "app/studies/model/explained_model.hpp"

namespace tubeplan::app {

/// What is asked for, as a command says it: each of EFFECT@AT, EFFECT@AT:NUMBER=VALUE,... (with sizes, as a diagnosis
/// gives them), EFFECT@all joints, free@NAME, free@geometry; and a formula, TARGET += EXPRESSION, beside which
/// formula@TARGET may stand among the causes.
struct AdditionRequest {
  std::vector<std::string> causes;
  std::string formula;
};

struct Addition : AddedCauses {
  Cell cell;  ///< with all of it, as it will be read again
};

/// Throws InputError for nothing, an effect that the cell has already, or what the readers of effects refuse.
[[nodiscard]] Addition addToCell(const Cell& cell, const AdditionRequest& request);

/// The cell without these: each an effect, EFFECT@AT, with its numbers in `identify`, or free@NAME, a name of `identify`
/// that is held again at the value it has. Throws InputError for what the cell does not have.
[[nodiscard]] Cell withoutCauses(const Cell& cell, const std::vector<std::string>& causes);

/// The cell's text with what was added, to be written at `out`.
[[nodiscard]] std::string cellTextWith(const Cell& cell, const Addition& addition, const std::filesystem::path& out);

/// In words: the overlap of the cell's formulas with the catalogue at these readings.
[[nodiscard]] std::string overlapAt(const CellReadings& input);

}  // namespace tubeplan::app
