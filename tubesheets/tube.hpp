// A hole of a tube sheet, the leg that it is in and the state of its tube.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tubeplan::tubesheets {

/// Half of the channel head: hot or cold leg of a U-tube generator, or the full sheet of a once-through generator.
enum class Leg { kHot, kCold, kFull };

/// Side from which a picture of the sheet is drawn. Positions do not depend on this side: they are in the sheet frame.
enum class ViewedFrom { kBelow, kAbove };

enum class TubeState {
  kOpen,
  kPlugged,
  kSleeved,
  kStabilised,    ///< a plugged tube with a stabiliser inside
  kToPlug,        ///< a tube recommended for plugging and not yet plugged
  kInaccessible,  ///< a tube reported as unreachable or obstructed
  kUnresolved,    ///< a tube whose identity is in doubt
};

/// A hole [m]. The sheet frame has its origin at the centre of the sheet's lower face, x along the divider plate, y
/// into the hot leg and z up. The hole's centre is at z = 0.
struct Tube {
  int row = 0;     ///< row number from 1, counted away from the divider plate
  int column = 0;  ///< column number from 1, counted along x
  double x = 0;
  double y = 0;
  TubeState state = TubeState::kOpen;
};

/// Returns the usual name of a tube, such as "R12C7".
[[nodiscard]] std::string tubeName(int row, int column);

/// Row and column of a tube.
struct RowAndColumn {
  int row = 0, column = 0;
};
[[nodiscard]] std::optional<RowAndColumn> parseTubeName(std::string_view name);

[[nodiscard]] std::string_view legName(Leg leg);                 ///< name of a leg: hot, cold or full
[[nodiscard]] std::string_view viewedFromName(ViewedFrom side);  ///< name of a side: below or above
[[nodiscard]] std::string_view tubeStateName(TubeState state);   ///< name of a state: open, plugged, sleeved, ...

/// Return descriptions for reports, such as "hot leg", "seen from below" and "recommended to plug".
[[nodiscard]] std::string_view legWords(Leg leg);
[[nodiscard]] std::string_view viewedFromWords(ViewedFrom side);
[[nodiscard]] std::string_view tubeStateWords(TubeState state);

/// Return all legs and all tube states, in the order of their enumerations.
[[nodiscard]] std::vector<Leg> legs();
[[nodiscard]] std::vector<TubeState> tubeStates();

/// Return the value with the given name; std::nullopt if the name is unknown. A leg may also be written HL, CL or "Hot
/// leg", in upper or lower case.
[[nodiscard]] std::optional<Leg> findLeg(std::string_view name);
[[nodiscard]] std::optional<ViewedFrom> findViewedFrom(std::string_view name);
[[nodiscard]] std::optional<TubeState> findTubeState(std::string_view name);

/// Return the names of all legs, sides or states, separated by commas, for messages.
[[nodiscard]] std::string legNames();
[[nodiscard]] std::string viewedFromNames();
[[nodiscard]] std::string tubeStateNames();

}  // namespace tubeplan::tubesheets
