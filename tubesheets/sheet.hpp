// A tube sheet: the holes of one leg, or of the full sheet, with their row and column numbers, positions and states.
//
// Example, compiled and run by tests/examples:
//
//     #include "tubesheets/sheet.hpp"
//     #include "tubesheets/work_list.hpp"
//     using namespace tubeplan::tubesheets;
//     SheetDescription description;
//     description.layout = {.type = "square", .pitch = 0.025, .first_row = 0.05, .radius = 0.5};  // m
//     description.hole_diameter = 0.019;
//     const Sheet sheet = makeSheet(description);
//     const auto edge = selectTubes(sheet, "outer:1");
//     std::printf("%zu of %zu\n", edge.tube_indices.size(), sheet.tubes.size());  // prints 90 of 566
#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tubesheets/layout.hpp"
#include "tubesheets/manway.hpp"
#include "tubesheets/tube.hpp"

namespace tubeplan::tubesheets {

struct HoleMap;

/// Description of a sheet, from which makeSheet() generates the holes; all lengths are in m.
struct SheetDescription {
  std::string name;
  Layout layout;
  double hole_diameter = std::numeric_limits<double>::quiet_NaN();
  Leg leg = Leg::kHot;
  ViewedFrom viewed_from = ViewedFrom::kBelow;
  std::optional<Manway> manway = std::nullopt;  ///< manway of the sheet; std::nullopt if its position is unknown
};

/// A tube sheet. `tubes` are sorted in sheet order: by row, then by column. Positions [m] are in the sheet frame of
/// tube.hpp.
struct Sheet {
  std::string name;
  std::string layout_type;
  Leg leg = Leg::kHot;
  ViewedFrom viewed_from = ViewedFrom::kBelow;
  double hole_diameter = std::numeric_limits<double>::quiet_NaN();
  double pitch = std::numeric_limits<double>::quiet_NaN();
  int rows = 0;     ///< highest row number
  int columns = 0;  ///< highest column number
  std::optional<Manway> manway;
  std::vector<Tube> tubes;
  std::shared_ptr<const HoleMap> map;  ///< map that the sheet was read from; null if the sheet was made from a layout

  /// Returns the tube at that row and column, or null if it is not on this sheet.
  [[nodiscard]] const Tube* find(int row, int column) const;

  /// Returns the index in `tubes` of the tube at that row and column, or std::nullopt if it is not on this sheet.
  [[nodiscard]] std::optional<int> indexOf(int row, int column) const;

  /// Returns the indices in `tubes` of the other holes within 1.05 pitches of a tube, in sheet order. Compares the tube
  /// with every hole; findNeighbours() is faster for the neighbours of all holes.
  [[nodiscard]] std::vector<int> neighbours(int tube) const;

  /// Returns a hash, 16 hexadecimal digits, of layout type, leg, pitch, hole diameter, row and column numbers and
  /// positions (to 1e-9 m), but not of name, states and manway. If two sheets have equal fingerprints, every tube has
  /// the same name and position on both.
  [[nodiscard]] std::string fingerprint() const;
};

/// Returns the problems that prevent making a sheet: faults of the layout or the hole diameter, or a leg that
/// contradicts the layout.
[[nodiscard]] std::vector<Problem> findDescriptionProblems(const SheetDescription& description);

/// Builds a sheet of a layout: the hot leg as generated, the cold leg mirrored (y -> -y). The description must have no
/// problems.
[[nodiscard]] Sheet makeSheet(const SheetDescription& description);

/// Builds a sheet from given holes, with their positions unchanged; of the layout, only type and pitch are used. The
/// result may have problems: see findSheetProblems().
[[nodiscard]] Sheet makeSheet(const SheetDescription& description, std::vector<Tube> tubes);

/// Returns for each hole the indices of the other holes within 1.05 pitches, in sheet order.
[[nodiscard]] std::vector<std::vector<int>> findNeighbours(const Sheet& sheet);

/// Returns up to about twenty problems that make the sheet unusable: no holes, numbers that are not finite or absurd,
/// two holes with the same name, holes that overlap, a hole diameter not below the pitch, holes beyond the divider
/// plate, a spacing that contradicts the pitch (a wrong unit), and faults of the manway.
[[nodiscard]] std::vector<Problem> findSheetProblems(const Sheet& sheet);

}  // namespace tubeplan::tubesheets
