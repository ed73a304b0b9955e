// The table of terms of the selection language, which work_list.hpp describes; one row for each term.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tubesheets/sheet.hpp"

namespace tubeplan::tubesheets {

/// Result of a term: the candidates that the term selects, or the reason why it cannot be applied.
struct TermChoice {
  std::vector<int> tubes;  ///< indices in Sheet::tubes, ascending
  std::string reason;      ///< reason why the term cannot be applied; empty on success
};

enum class TermRole {
  kSource,   ///< adds tubes to the selection, or removes them if preceded by a minus
  kGuard,    ///< selects no tubes, but refuses a sheet or leg other than the stated one
  kThinner,  ///< keeps a subset of the tubes selected by the other terms
};

struct SelectionTerm {
  std::string_view name;  ///< text before the colon, or the whole term if there is no colon
  std::string_view form;  ///< example of the term in use, for help pages
  std::string_view meaning;
  TermRole role = TermRole::kSource;
  bool takes_argument = false;
  TermChoice (*choose)(const Sheet&, const std::vector<int>& candidates, std::string_view argument) = nullptr;
};

/// Returns the table of terms. Ranges (R1-10C5-9) and names of tube states are also terms, but not in this table.
[[nodiscard]] const std::vector<SelectionTerm>& selectionTerms();

/// Selects the tubes of a range such as R10C20, R1-10C5-9, R10 or C20; gives a reason if the range is malformed or
/// names a row or column that is not on the sheet. A range of more than one tube may include positions without a hole,
/// because sheets are round.
[[nodiscard]] TermChoice chooseRange(const Sheet& sheet, const std::vector<int>& candidates, std::string_view range);

/// Returns a sentence such as "R60C3 is not on this sheet: rows 1 to 49, columns 1 to 114", with the columns of the
/// tube's row if the row exists.
[[nodiscard]] std::string explainMissing(const Sheet& sheet, int row, int column);

}  // namespace tubeplan::tubesheets
