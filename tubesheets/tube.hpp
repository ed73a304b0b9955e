// One hole of a tube sheet, the leg it is in and the state of its tube.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tubeplan::tubesheets {

/// Half of the channel head: hot and cold legs of a U-tube generator, or the full sheet of a once-through one.
enum class Leg { kHot, kCold, kFull };

/// Side from which a picture of the sheet is drawn. Positions do not depend on it: they are in the sheet frame.
enum class ViewedFrom { kBelow, kAbove };

enum class TubeState {
  kOpen,
  kPlugged,
  kSleeved,
  kStabilised,    ///< a plugged tube with a stabiliser inside
  kToPlug,        ///< a tube recommended for plugging and not yet plugged
  kInaccessible,  ///< a tube reported as unreachable or obstructed
  kUnresolved,    ///< identity in doubt
};

/// A hole [m]. Sheet frame: origin at the centre of the sheet's lower face, x along the divider plate, y into the hot
/// leg, z up. The hole's centre is at z = 0.
struct Tube {
  int row = 0;     ///< row number from 1, counted away from the divider plate
  int column = 0;  ///< column number from 1, counted along x
  double x = 0;
  double y = 0;
  TubeState state = TubeState::kOpen;
};

/// Returns the tube's usual name, "R12C7".
[[nodiscard]] std::string tubeName(int row, int column);

/// Row and column of a tube.
struct RowAndColumn {
  int row = 0, column = 0;
};
[[nodiscard]] std::optional<RowAndColumn> parseTubeName(std::string_view name);

[[nodiscard]] std::string_view legName(Leg leg);                 ///< hot, cold or full
[[nodiscard]] std::string_view viewedFromName(ViewedFrom side);  ///< below or above
[[nodiscard]] std::string_view tubeStateName(TubeState state);   ///< open, plugged, sleeved, ...

/// Return words for a reader: "hot leg", "seen from below", "recommended to plug".
[[nodiscard]] std::string_view legWords(Leg leg);
[[nodiscard]] std::string_view viewedFromWords(ViewedFrom side);
[[nodiscard]] std::string_view tubeStateWords(TubeState state);

/// Returns all states, in the order of their table.
[[nodiscard]] std::vector<TubeState> tubeStates();

/// Find a value by its name (a leg also as HL, CL, "Hot leg", in any capitals); nothing if the name is unknown.
[[nodiscard]] std::optional<Leg> findLeg(std::string_view name);
[[nodiscard]] std::optional<ViewedFrom> findViewedFrom(std::string_view name);
[[nodiscard]] std::optional<TubeState> findTubeState(std::string_view name);

/// Return all names, "a, b, c", for messages.
[[nodiscard]] std::string legNames();
[[nodiscard]] std::string viewedFromNames();
[[nodiscard]] std::string tubeStateNames();

}  // namespace tubeplan::tubesheets
