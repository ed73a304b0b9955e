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
  kOpen,      ///< item not yet visited
  kQueued,    ///< item to be visited again, after the open items
  kHeld,      ///< item on hold until a decision is made
  kDone,      ///< finished
  kExcluded,  ///< item removed from the plan, with a reason
};

struct Mark {
  std::string_view name;   ///< name on the command line and in the log
  char key;                ///< keyboard key on the desk page
  std::string_view words;  ///< description for help texts and reports
  ItemStanding standing = ItemStanding::kOpen;
  bool needs_tool = true;     ///< true if the tool entered the tube, which requires a confirmed identity
  bool needs_reason = false;  ///< true if the log must state a reason
  std::optional<tubesheets::TubeState> state = {};  ///< new state of this end of the tube
};

[[nodiscard]] std::span<const Mark> marks();

/// Returns the mark with the given name; null if there is none.
[[nodiscard]] const Mark* findMark(std::string_view name);

/// Returns the name of a standing: open, queued, held, done or excluded.
[[nodiscard]] std::string_view standingName(ItemStanding standing);

}  // namespace tubeplan::app
