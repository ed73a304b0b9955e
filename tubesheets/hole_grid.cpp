#include "tubesheets/hole_grid.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <tuple>

namespace tubeplan::tubesheets {
namespace {

constexpr double kFarthestCell = 1e12;  // holes farther away are put into the outermost cell, to avoid integer overflow

}  // namespace

HoleGrid::HoleGrid(const std::vector<Tube>& tubes, double reach) : reach_(reach) {
  assert(std::isfinite(reach) && reach > 0);
  for (int i = 0; i < static_cast<int>(tubes.size()); ++i) {
    const Tube& tube = tubes[i];
    if (!std::isfinite(tube.x) || !std::isfinite(tube.y)) continue;
    entries_.push_back({cellOf(tube.x), cellOf(tube.y), i, tube.x, tube.y});
  }
  std::sort(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) {
    return std::tie(a.cell_x, a.cell_y, a.tube) < std::tie(b.cell_x, b.cell_y, b.tube);
  });
}

std::vector<int> HoleGrid::findWithin(double x, double y, double distance) const {
  assert(distance <= reach_);
  std::vector<int> found;
  const std::int64_t centre_y = cellOf(y);
  for (std::int64_t cell_x = cellOf(x) - 1; cell_x <= cellOf(x) + 1; ++cell_x) {
    const auto is_before = [](const Entry& entry, const std::pair<std::int64_t, std::int64_t>& cell) {
      return std::tie(entry.cell_x, entry.cell_y) < std::tie(cell.first, cell.second);
    };
    auto entry = std::lower_bound(entries_.begin(), entries_.end(), std::pair{cell_x, centre_y - 1}, is_before);
    for (; entry != entries_.end() && entry->cell_x == cell_x && entry->cell_y <= centre_y + 1; ++entry)
      if (std::hypot(entry->x - x, entry->y - y) <= distance) found.push_back(entry->tube);
  }
  std::sort(found.begin(), found.end());
  return found;
}

std::int64_t HoleGrid::cellOf(double coordinate) const {
  return static_cast<std::int64_t>(std::clamp(std::floor(coordinate / reach_), -kFarthestCell, kFarthestCell));
}

std::vector<std::vector<int>> neighboursWithin(const std::vector<Tube>& tubes, double reach) {
  const HoleGrid grid(tubes, reach);
  std::vector<std::vector<int>> neighbours(tubes.size());
  for (int i = 0; i < static_cast<int>(tubes.size()); ++i) {
    neighbours[i] = grid.findWithin(tubes[i].x, tubes[i].y, reach);
    std::erase(neighbours[i], i);
  }
  return neighbours;
}

}  // namespace tubeplan::tubesheets
