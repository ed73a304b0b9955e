#include "tubesheets/sheet.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <tuple>

#include "tubesheets/fingerprint.hpp"
#include "tubesheets/hole_grid.hpp"
#include "tubesheets/layouts.hpp"
#include "tubesheets/length_unit.hpp"

namespace tubeplan::tubesheets {
namespace {

// Largest distance of neighbouring holes, in pitches. It allows for drilling tolerance, but excludes the diagonal.
constexpr double kNeighbourReach = 1.05;

bool isBefore(const Tube& a, const Tube& b) { return std::tie(a.row, a.column) < std::tie(b.row, b.column); }

}  // namespace

const Tube* Sheet::find(int row, int column) const {
  const std::optional<int> index = indexOf(row, column);
  return index ? &tubes[*index] : nullptr;
}

std::optional<int> Sheet::indexOf(int row, int column) const {
  const auto tube = std::lower_bound(tubes.begin(), tubes.end(), Tube{row, column}, isBefore);
  if (tube == tubes.end() || tube->row != row || tube->column != column) return std::nullopt;
  return static_cast<int>(tube - tubes.begin());
}

std::vector<int> Sheet::neighbours(int tube) const {
  assert(tube >= 0 && tube < static_cast<int>(tubes.size()));
  std::vector<int> found;
  for (int other = 0; other < static_cast<int>(tubes.size()); ++other) {
    const double distance = std::hypot(tubes[other].x - tubes[tube].x, tubes[other].y - tubes[tube].y);
    if (other != tube && distance <= kNeighbourReach * pitch) found.push_back(other);
  }
  return found;
}

std::string Sheet::fingerprint() const {
  Fingerprint fingerprint;
  fingerprint.add(layout_type);
  fingerprint.add(legName(leg));
  fingerprint.addLength(pitch);
  fingerprint.addLength(hole_diameter);
  for (const Tube& tube : tubes) {
    fingerprint.add(tube.row);
    fingerprint.add(tube.column);
    fingerprint.addLength(tube.x);
    fingerprint.addLength(tube.y);
  }
  return fingerprint.text();
}

std::vector<Problem> findDescriptionProblems(const SheetDescription& description) {
  std::vector<Problem> problems = findLayoutProblems(description.layout);
  if (!problems.empty()) return problems;
  const double diameter = description.hole_diameter;
  if (!std::isfinite(diameter) || diameter <= 0 || diameter >= description.layout.pitch)
    problems.push_back({"hole_diameter", fmt::format("{:.6g} m", diameter),
                        fmt::format("a length above zero and below the pitch, {:.6g} m", description.layout.pitch),
                        ""});
  const bool is_full = findLayoutType(description.layout.type)->covers_full_sheet;
  if (is_full != (description.leg == Leg::kFull))
    problems.push_back(
        {"leg", std::string(legName(description.leg)), is_full ? "full" : "hot or cold",
         fmt::format("a {} layout covers {}", description.layout.type, is_full ? "the full sheet" : "one leg")});
  if (!is_full && description.layout.first_row <= diameter / 2)
    problems.push_back({"first_row", fmt::format("{:.6g} m", description.layout.first_row),
                        fmt::format("more than half a hole, {:.6g} m", diameter / 2),
                        "otherwise the holes of row 1 would cut the divider plate"});
  return problems;
}

Sheet makeSheet(const SheetDescription& description) {
  assert(findDescriptionProblems(description).empty());
  std::vector<Tube> tubes = makeTubes(description.layout);
  if (description.leg == Leg::kCold)
    for (Tube& tube : tubes) tube.y = -tube.y;
  return makeSheet(description, std::move(tubes));
}

Sheet makeSheet(const SheetDescription& description, std::vector<Tube> tubes) {
  Sheet sheet;
  sheet.name = description.name;
  sheet.layout_type = description.layout.type;
  sheet.leg = description.leg;
  sheet.viewed_from = description.viewed_from;
  sheet.hole_diameter = description.hole_diameter;
  sheet.pitch = description.layout.pitch;
  sheet.manway = description.manway;
  std::stable_sort(tubes.begin(), tubes.end(), isBefore);
  for (Tube& tube : tubes) {
    tube.x = snapLength(tube.x);
    tube.y = snapLength(tube.y);
    sheet.rows = std::max(sheet.rows, tube.row);
    sheet.columns = std::max(sheet.columns, tube.column);
  }
  sheet.tubes = std::move(tubes);
  return sheet;
}

std::vector<std::vector<int>> findNeighbours(const Sheet& sheet) {
  return neighboursWithin(sheet.tubes, kNeighbourReach * sheet.pitch);
}

}  // namespace tubeplan::tubesheets
