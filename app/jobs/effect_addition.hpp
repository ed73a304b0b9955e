// A cell with additions to its model, to be fitted with the rest: effects of the catalogue, the user's own formulas,
// and numbers of the arm's file that were held.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/formats/measurements/reading_input.hpp"
#include "app/studies/model/explained_model.hpp"

namespace tubeplan::app {

/// Request in the words of a command. A cause is `EFFECT@AT`, `EFFECT@AT:NUMBER=VALUE,...` (with sizes, as a diagnosis
/// gives them), `EFFECT@all joints`, `free@NAME` or `free@geometry`. A formula is `TARGET += EXPRESSION`; the causes
/// may then include `formula@TARGET`.
struct AdditionRequest {
  std::vector<std::string> causes;
  std::string formula;
};

struct Addition : AddedCauses {
  Cell cell;  ///< the cell with all additions, in the form in which it will be read again
};

/// Adds the causes. Throws InputError for an empty request, an effect that the cell has already, or what the readers of
/// effects refuse.
[[nodiscard]] Addition addToCell(const Cell& cell, const AdditionRequest& request);

/// Returns the cell without these causes: each an effect, `EFFECT@AT`, with its numbers in `identify`, or `free@NAME`,
/// a name of `identify` that is held again at its present value. Throws InputError for causes that the cell does not
/// have.
[[nodiscard]] Cell withoutCauses(const Cell& cell, const std::vector<std::string>& causes);

/// Returns the cell's text with the additions, to be written at `out`.
[[nodiscard]] std::string cellTextWith(const Cell& cell, const Addition& addition, const std::filesystem::path& out);

/// Returns words on the overlap of the cell's formulas with the catalogue at these readings.
[[nodiscard]] std::string overlapAt(const CellReadings& input);

}  // namespace tubeplan::app
