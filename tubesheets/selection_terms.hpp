// The words of the selection language: one row each. The language itself is described in work_list.hpp.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tubesheets/sheet.hpp"

namespace tubeplan::tubesheets {

/// What a term leaves of its candidates, or why it cannot be followed.
struct TermChoice {
  std::vector<int> tubes;  ///< places in sheet.tubes, ascending
  std::string reason;      ///< empty when all is well
};

enum class TermRole {
  kSource,   ///< adds tubes, or with a minus takes them away
  kGuard,    ///< changes nothing, but refuses the wrong sheet
  kThinner,  ///< keeps some of what the rest of the list selects
};

struct SelectionTerm {
  std::string_view name;  ///< what stands before the colon, or the whole word
  std::string_view form;  ///< as a user writes it
  std::string_view meaning;
  TermRole role = TermRole::kSource;
  bool takes_argument = false;
  TermChoice (*choose)(const Sheet&, const std::vector<int>& candidates, std::string_view argument) = nullptr;
};

/// The table, for help pages too. Ranges (R1-10C5-9) and the names of tube states are terms beside these.
[[nodiscard]] const std::vector<SelectionTerm>& selectionTerms();

/// The tubes of a range R10C20, R1-10C5-9, R10 or C20; a reason when it is malformed or names what is not on the sheet.
/// Places without a hole inside a range of two or more are no fault, for sheets are round.
[[nodiscard]] TermChoice chooseRange(const Sheet& sheet, const std::vector<int>& candidates, std::string_view range);

/// "R60C3 is not on this sheet: rows 1 to 49, columns 1 to 114", with the columns of its row where there is such a row.
[[nodiscard]] std::string explainMissing(const Sheet& sheet, int row, int column);

}  // namespace tubeplan::tubesheets
