// Search for columns of foreign tables that together state an orientation or a position, and for the form of their
// numbers.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/formats/foreign/foreign_columns.hpp"
#include "app/formats/foreign/foreign_heading.hpp"

namespace tubeplan::app {

/// For each table, one flag per column: true if the column is not yet assigned to a quantity.
using FreeColumns = std::vector<std::vector<bool>>;

/// Inputs of a search for forms: tables with their unassigned columns, and the joints that have no column yet.
struct FormSearch {
  const std::vector<ForeignTable>& tables;
  const std::vector<std::vector<ForeignHeading>>& headings;
  const UsualUnits& units;
  const FreeColumns& free;
  std::vector<const ColumnTarget*> joints;
};

/// Returns true if the heading of an unassigned column matches a name of the target.
[[nodiscard]] bool hasFreeColumn(const FormSearch& search, const ColumnTarget& target);

/// Returns the kinds of the measurements: only `requested_kind` or, if it is empty, all kinds stated in the rows.
[[nodiscard]] std::set<std::string> kindsOf(const FormSearch& search, const std::string& requested_kind);

/// Returns the quantities (orientation, position) for which a form is needed: those measured by measurements of the
/// given kinds (a position if there are no kinds), and those whose form the user chose. Each is mapped to the name of
/// the chosen form, or to an empty name.
[[nodiscard]] std::map<Stated, std::string> neededForms(const std::set<std::string>& kinds, const ColumnChoice& choice);

/// Returns every form whose headings all occur in the same table; if `name` is not empty, only the form of this name. A
/// column that is the only candidate for a joint is reserved for the joint: q1 to q4 are joints, not a quaternion, if
/// no other columns can be.
[[nodiscard]] std::vector<FormColumns> formsByHeadings(const FormSearch& search, Stated stated,
                                                       const std::string& name);

/// Returns the forms that remain after three exclusions: forms contradicted by a further column, forms for which the
/// numbers are implausible, and forms with the same results as an earlier form.
[[nodiscard]] std::vector<FormColumns> decideForms(std::vector<FormColumns> forms,
                                                   const std::vector<ForeignTable>& tables);

/// Returns the only form that decideForms() leaves; std::nullopt if `found` is empty. Throws InputError if several
/// forms remain.
[[nodiscard]] std::optional<FormColumns> onlyForm(const std::vector<FormColumns>& found,
                                                  const std::vector<ForeignTable>& tables);

/// Returns the numbers of a form in a row, in internal units; std::nullopt if a field is not a number.
[[nodiscard]] std::optional<FormNumbers> numbersOf(const FormColumns& columns, const ForeignRow& row);

/// Returns the quoted headings of the columns and the name of their file, for messages.
[[nodiscard]] std::string namesOf(const FormColumns& columns, const std::vector<ForeignTable>& tables);

}  // namespace tubeplan::app
