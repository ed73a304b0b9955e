// A grid which finds the holes near a point without looking at all of them.
#pragma once

#include <cstdint>
#include <vector>

#include "tubesheets/tube.hpp"

namespace tubeplan::tubesheets {

/// Square cells of side `reach` [m] over the holes with finite positions.
class HoleGrid {
 public:
  HoleGrid(const std::vector<Tube>& tubes, double reach);

  /// Returns the indices in `tubes` of the holes at most `distance` [m] (not above `reach`) from (x, y) [m], ascending.
  [[nodiscard]] std::vector<int> findWithin(double x, double y, double distance) const;

 private:
  struct Entry {
    std::int64_t cell_x, cell_y;
    int tube;
    double x, y;
  };

  [[nodiscard]] std::int64_t cellOf(double coordinate) const;

  double reach_;
  std::vector<Entry> entries_;
};

/// Returns for each hole the indices of the others within `reach` [m], ascending.
[[nodiscard]] std::vector<std::vector<int>> neighboursWithin(const std::vector<Tube>& tubes, double reach);

}  // namespace tubeplan::tubesheets
