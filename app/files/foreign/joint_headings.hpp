// Joints among the headings of foreign tables: by their names, by their numbers, by a controller's letters.
#pragma once

#include <vector>

#include "app/files/foreign/foreign_columns.hpp"
#include "app/files/foreign/foreign_heading.hpp"

namespace tubeplan::app {

/// The name of a heading that is this target's and no other's.
[[nodiscard]] std::string settledName(const ColumnTarget& target);

/// Counts joints from one where they were counted from zero, and settles those that are called by their own names, by
/// letters (S, L, U, R, B, T of Yaskawa) or, of those that are left, by numbers; else all of them by jointPatterns(),
/// where that is one set.
void settleJoints(const std::vector<ForeignTable>& tables, std::vector<std::vector<ForeignHeading>>& headings,
                  const std::vector<ColumnTarget>& targets);

}  // namespace tubeplan::app
