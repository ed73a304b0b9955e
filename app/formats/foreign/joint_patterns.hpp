// Search for joint columns whose headings have the same words around each joint's name or number: `panda_joint1`,
// `joint_1_position`, `/joint_states/position[0]`.
#pragma once

#include <string>
#include <vector>

#include "app/formats/foreign/foreign_columns.hpp"
#include "app/formats/foreign/foreign_heading.hpp"

namespace tubeplan::app {

/// Columns of one table, one for each joint on the chain to the tip.
struct JointColumns {
  std::size_t table = 0;
  std::vector<std::size_t> columns;  ///< column indices, in the order of the joints

  friend bool operator==(const JointColumns&, const JointColumns&) = default;
};

/// Returns true if headings may identify a joint by number, which is the case for joints on the chain to the tip.
[[nodiscard]] bool isNumbered(const ColumnTarget& target);

/// Returns all sets of columns whose headings name every joint, with the same words before and after its name. The
/// names are those of the joints, the same names without their common words, or numbers from 0 or 1 next to a word for
/// joints or positions. Sets with words for speeds, torques and similar quantities are excluded.
[[nodiscard]] std::vector<JointColumns> jointPatterns(const std::vector<ForeignTable>& tables,
                                                      const std::vector<std::vector<ForeignHeading>>& headings,
                                                      const std::vector<ColumnTarget>& targets);

}  // namespace tubeplan::app
