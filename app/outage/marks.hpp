// The open table of marks: what can be recorded about a visit. Commands, totals and documents loop over the table.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "tubesheets/tube.hpp"

namespace tubeplan::app {

/// Standing of one item of work. Planned items = done + excluded + unresolved; the first three standings are
/// unresolved.
enum class ItemStanding {
  kOpen,      ///< not yet visited
  kQueued,    ///< to be visited again, after the open items
  kHeld,      ///< not to be visited until it is decided what to do
  kDone,      ///< finished
  kExcluded,  ///< taken out of the plan, with a reason
};

struct Mark {
  std::string_view name;   ///< name on the command line and in the log
  char key;                ///< key of the desk's page
  std::string_view words;  ///< description for help texts and reports
  ItemStanding standing = ItemStanding::kOpen;
  bool needs_tool = true;     ///< true: the tool was in the tube, so the tube's identity must be confirmed first
  bool needs_reason = false;  ///< true: the log must say why
  std::optional<tubesheets::TubeState> state = {};  ///< new state of this end of the tube
};

[[nodiscard]] std::span<const Mark> marks();

/// Returns the mark of that name; null if there is none.
[[nodiscard]] const Mark* findMark(std::string_view name);

/// Returns the name of a standing: open, queued, held, done or excluded.
[[nodiscard]] std::string_view standingName(ItemStanding standing);

}  // namespace tubeplan::app
