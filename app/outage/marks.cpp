#include "app/outage/marks.hpp"

#include <algorithm>
#include <array>

namespace tubeplan::app {

namespace {

using enum ItemStanding;
using tubesheets::TubeState;

constexpr std::array kMarks{
    Mark{"done", 'd', "examined over its full extent", kDone},
    Mark{"retest", 'r', "to be examined again", kQueued},
    Mark{"skipped", 's', "skipped for now", kQueued, false},
    Mark{"obstructed", 'o', "the tool does not enter or pass", kHeld},
    Mark{"restricted", 'c', "only a smaller tool passes", kHeld},
    Mark{"to-plug", 't', "examined, and recommended for plugging", kDone, true, false, TubeState::kToPlug},
    Mark{"plugged", 'p', "plugged at this end", kDone, true, false, TubeState::kPlugged},
    Mark{"excluded", 'x', "taken out of the plan", kExcluded, false, true},
    Mark{"open", 'b', "back in the plan, as if never visited", kOpen, false, true},
};

}  // namespace

std::span<const Mark> marks() { return kMarks; }

const Mark* findMark(std::string_view name) {
  const auto found = std::ranges::find(kMarks, name, &Mark::name);
  return found == kMarks.end() ? nullptr : &*found;
}

std::string_view standingName(ItemStanding standing) {
  constexpr std::array<std::string_view, 5> kNames{"open", "queued", "held", "done", "excluded"};
  return kNames[static_cast<std::size_t>(standing)];
}

}  // namespace tubeplan::app
