// Search for columns of foreign tables that together state an orientation or a position, and for their form.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/formats/foreign/foreign_columns.hpp"
#include "app/formats/foreign/foreign_heading.hpp"

namespace tubeplan::app {

/// Marks of unassigned columns: one list for each table, one mark for each column.
using FreeColumns = std::vector<std::vector<bool>>;

/// Inputs of a search for forms: the tables with their free columns, and the joints without a column so far.
struct FormSearch {
  const std::vector<ForeignTable>& tables;
  const std::vector<std::vector<ForeignHeading>>& headings;
  const UsualUnits& units;
  const FreeColumns& free;
  std::vector<const ColumnTarget*> joints;
};

/// Returns true if a free column has a name of the target.
[[nodiscard]] bool hasFreeColumn(const FormSearch& search, const ColumnTarget& target);

/// Returns the requested kind, else the kinds stated in the rows.
[[nodiscard]] std::set<std::string> kindsOf(const FormSearch& search, const std::string& asked);

/// Returns the quantities that readings of those kinds need, or a position if no kind is stated, and those whose form
/// the user chose. Each has the name of the chosen form, or an empty one.
[[nodiscard]] std::map<Stated, std::string> neededForms(const std::set<std::string>& kinds, const ColumnChoice& choice);

/// Returns every form whose headings occur in one table, each once; with a name, only that form. A column that is the
/// last one possible for a joint belongs to the joint: q1 to q4 are joints if there are no others.
[[nodiscard]] std::vector<FormColumns> formsByHeadings(const FormSearch& search, Stated stated,
                                                       const std::string& name);

/// Returns the forms that remain after exclusion by columns beside them, by the numbers of the rows, and of forms that
/// give the same result as one before them.
[[nodiscard]] std::vector<FormColumns> decideForms(std::vector<FormColumns> forms,
                                                   const std::vector<ForeignTable>& tables);

/// Returns the only remaining form; nothing if there is none. Throws InputError if several remain.
[[nodiscard]] std::optional<FormColumns> onlyForm(const std::vector<FormColumns>& found,
                                                  const std::vector<ForeignTable>& tables);

/// Returns the numbers of a row in internal units; nothing if a field is not a number.
[[nodiscard]] std::optional<FormNumbers> numbersOf(const FormColumns& columns, const ForeignRow& row);

/// Returns the quoted headings of the columns, with the file.
[[nodiscard]] std::string namesOf(const FormColumns& columns, const std::vector<ForeignTable>& tables);

}  // namespace tubeplan::app
