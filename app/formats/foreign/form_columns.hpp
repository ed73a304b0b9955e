// Which columns of foreign tables state a turn or a place together, and in which form.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/formats/foreign/foreign_columns.hpp"
#include "app/formats/foreign/foreign_heading.hpp"

namespace tubeplan::app {

/// Marks of the columns that nothing has taken yet: one list for each table, one mark for each column.
using FreeColumns = std::vector<std::vector<bool>>;

/// Where forms are looked for: in the free columns of tables, beside the joints that have none yet.
struct FormSearch {
  const std::vector<ForeignTable>& tables;
  const std::vector<std::vector<ForeignHeading>>& headings;
  const UsualUnits& units;
  const FreeColumns& free;
  std::vector<const ColumnTarget*> joints;
};

/// Returns whether a free column has the name of a target.
[[nodiscard]] bool hasFreeColumn(const FormSearch& search, const ColumnTarget& target);

/// Returns the kind that is asked for, else those that the rows state.
[[nodiscard]] std::set<std::string> kindsOf(const FormSearch& search, const std::string& asked);

/// Returns what readings of those kinds need, of none a place, and what is asked for: with the name of the form, which
/// is empty where none is asked for.
[[nodiscard]] std::map<Stated, std::string> neededForms(const std::set<std::string>& kinds, const ColumnChoice& choice);

/// Returns every form whose headings stand in one table, each once; only the one of that name unless empty. The last
/// columns that a joint may have are the joint's: q1 to q4 are joints where no others are.
[[nodiscard]] std::vector<FormColumns> formsByHeadings(const FormSearch& search, Stated stated,
                                                       const std::string& name);

/// Takes off the forms that a column beside them or the numbers of the rows exclude, and those that read the rows as
/// the one before them does.
[[nodiscard]] std::vector<FormColumns> decideForms(std::vector<FormColumns> forms,
                                                   const std::vector<ForeignTable>& tables);

/// Returns the only form of those; nothing where there is none. Throws InputError where several are left.
[[nodiscard]] std::optional<FormColumns> onlyForm(const std::vector<FormColumns>& found,
                                                  const std::vector<ForeignTable>& tables);

/// Returns the numbers of a row in internal units; nothing where a field is none.
[[nodiscard]] std::optional<FormNumbers> numbersOf(const FormColumns& columns, const ForeignRow& row);

/// Returns their headings, quoted, with the file.
[[nodiscard]] std::string namesOf(const FormColumns& columns, const std::vector<ForeignTable>& tables);

}  // namespace tubeplan::app
