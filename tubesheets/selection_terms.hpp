// The words of the selection language: one row each. The language itself is described in work_list.hpp.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tubesheets/sheet.hpp"

namespace tubeplan::tubesheets {

/// Result of a term: the candidates that it keeps, or the reason why it cannot be applied.
struct TermChoice {
  std::vector<int> tubes;  ///< indices in Sheet::tubes, ascending
  std::string reason;      ///< reason of failure; empty on success
};

enum class TermRole {
  kSource,   ///< adds tubes, or removes them when it has a minus
  kGuard,    ///< changes nothing, but refuses the wrong sheet
  kThinner,  ///< keeps some of what the rest of the list selects
};

struct SelectionTerm {
  std::string_view name;  ///< text before the colon, or the whole word
  std::string_view form;  ///< example of the term in use
  std::string_view meaning;
  TermRole role = TermRole::kSource;
  bool takes_argument = false;
  TermChoice (*choose)(const Sheet&, const std::vector<int>& candidates, std::string_view argument) = nullptr;
};

/// Returns the table, for help pages too. Ranges (R1-10C5-9) and the names of tube states are terms beside these.
[[nodiscard]] const std::vector<SelectionTerm>& selectionTerms();

/// Selects the tubes of a range R10C20, R1-10C5-9, R10 or C20; gives a reason if it is malformed or names what is not
/// on the sheet. A range of two or more places may include places without a hole, because sheets are round.
[[nodiscard]] TermChoice chooseRange(const Sheet& sheet, const std::vector<int>& candidates, std::string_view range);

/// Returns "R60C3 is not on this sheet: rows 1 to 49, columns 1 to 114", with the columns of its row if there is such a
/// row.
[[nodiscard]] std::string explainMissing(const Sheet& sheet, int row, int column);

}  // namespace tubeplan::tubesheets
