#include "tubesheets/layouts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace tubeplan::tubesheets {
namespace {

constexpr double kHalfRootThree = std::numbers::sqrt3 / 2;

// Tolerance, as a fraction of the radius, that keeps hole centres on the limiting circle inside despite rounding.
constexpr double kOnCircle = 1e-12;

bool isWithin(const Layout& layout, double x, double y) {
  const double distance = std::hypot(x / layout.pitch, y / layout.pitch);
  return distance <= layout.radius / layout.pitch * (1 + kOnCircle) &&
         distance >= layout.stay_radius / layout.pitch * (1 - kOnCircle);
}

// Lattice of one leg with rows dy apart and columns dx apart, centred on x = 0; if staggered, every second point is
// omitted.
struct LegLattice {
  double dx, dy;
  bool staggered;
};

void addLegRow(const Layout& layout, const LegLattice& lattice, int row, int columns, std::vector<Tube>& tubes) {
  const double y = layout.first_row + (row - 1) * lattice.dy;
  for (int column = 1; column <= columns; ++column) {
    const bool is_gap = lattice.staggered && (row + column - (columns + 1) / 2) % 2 == 0;
    const double x = (column - (columns + 1) / 2.0) * lattice.dx;
    if (!is_gap && isWithin(layout, x, y)) tubes.push_back({row, column, x, y});
  }
}

// Renumbers the columns so that the widest row begins at column 1.
void dropEmptyMargins(int columns, std::vector<Tube>& tubes) {
  int margin = columns;
  for (const Tube& tube : tubes) margin = std::min({margin, tube.column - 1, columns - tube.column});
  for (Tube& tube : tubes) tube.column -= margin;
}

std::vector<Tube> makeLeg(const Layout& layout, const LegLattice& lattice) {
  const int half = static_cast<int>(layout.radius / lattice.dx) + 1;
  const int most_columns = lattice.staggered ? 2 * half + 1 : 2 * half;
  const int columns = layout.columns > 0 ? layout.columns : most_columns;
  const int most_rows = layout.rows > 0 ? layout.rows : std::numeric_limits<int>::max();
  std::vector<Tube> tubes;
  for (int row = 1; row <= most_rows && layout.first_row + (row - 1) * lattice.dy <= layout.radius * (1 + kOnCircle);
       ++row)
    addLegRow(layout, lattice, row, columns, tubes);
  if (layout.columns == 0) dropEmptyMargins(columns, tubes);
  return tubes;
}

std::vector<Tube> makeSquareLeg(const Layout& layout) { return makeLeg(layout, {layout.pitch, layout.pitch, false}); }

std::vector<Tube> makeTriangularLeg(const Layout& layout) {
  return makeLeg(layout, {layout.pitch / 2, layout.pitch * kHalfRootThree, true});
}

// Adds a row of a once-through generator, whose tubes are numbered from 1 in each row: the column is the position in
// the row, not a line of holes.
void addDiscRow(const Layout& layout, int line, int row, std::vector<Tube>& tubes) {
  const int half = static_cast<int>(layout.radius / layout.pitch) + 1;
  const double shift = line % 2 == 0 ? 0.0 : 0.5;
  int number = 0;
  for (int place = -half - 1; place <= half; ++place) {
    const double x = (place + shift) * layout.pitch, y = line * kHalfRootThree * layout.pitch;
    if (isWithin(layout, x, y)) tubes.push_back({row, ++number, x, y});
  }
}

std::vector<Tube> makeDisc(const Layout& layout) {
  const int half = static_cast<int>(layout.radius * (1 + kOnCircle) / (layout.pitch * kHalfRootThree));
  std::vector<Tube> tubes;
  for (int line = -half; line <= half; ++line) addDiscRow(layout, line, line + half + 1, tubes);
  return tubes;
}

const LayoutKey kPitch{"pitch", &Layout::pitch, true, "distance between neighbouring centres"};
const LayoutKey kFirstRow{"first_row", &Layout::first_row, true, "distance of row 1 from the divider plate"};
const LayoutKey kRadius{"radius", &Layout::radius, true, "outermost distance of a centre from the sheet's centre"};
const LayoutKey kStayRadius{"stay_radius", &Layout::stay_radius, false,
                            "innermost distance of a centre (stay cylinder)"};
const LayoutKey kRows{"rows", &Layout::rows, false, "most rows; 0 = as many as fit"};
const LayoutKey kColumns{"columns", &Layout::columns, false, "columns, centred; 0 = as many as fit"};

}  // namespace

const std::vector<LayoutType>& layoutTypes() {
  static const std::vector<LayoutType> types{
      {"square",
       "one leg of a U-tube generator on a square lattice",
       {kPitch, kFirstRow, kRadius, kStayRadius, kRows, kColumns},
       false,
       -1,
       makeSquareLeg},
      {"triangular",
       "one leg of a U-tube generator on a triangular lattice, rows parallel to the divider plate",
       {kPitch, kFirstRow, kRadius, kStayRadius, kRows, kColumns},
       false,
       1,
       makeTriangularLeg},
      {"disc",
       "the full sheet of a once-through generator on a triangular lattice, tubes numbered from 1 in each row",
       {kPitch, kRadius, kStayRadius},
       true,
       -1,
       makeDisc},
  };
  return types;
}

const LayoutType* findLayoutType(std::string_view name) {
  const auto& types = layoutTypes();
  const auto type = std::find_if(types.begin(), types.end(), [&](const LayoutType& t) { return t.name == name; });
  return type == types.end() ? nullptr : &*type;
}

std::string layoutTypeNames() {
  std::vector<std::string_view> names;
  for (const LayoutType& type : layoutTypes()) names.push_back(type.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace tubeplan::tubesheets
