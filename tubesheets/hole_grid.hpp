// Spatial index of holes: finds the holes near a point without checking all of them.
#pragma once

#include <cstdint>
#include <vector>

#include "tubesheets/tube.hpp"

namespace tubeplan::tubesheets {

/// Grid of square cells with side `reach` [m] over the holes whose positions are finite.
class HoleGrid {
 public:
  HoleGrid(const std::vector<Tube>& tubes, double reach);

  /// Returns, in ascending order, the indices in `tubes` of the holes within `distance` [m] of (x, y) [m]; `distance`
  /// must not exceed `reach`.
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

/// For each hole, returns the indices of the other holes within `reach` [m], in ascending order.
[[nodiscard]] std::vector<std::vector<int>> neighboursWithin(const std::vector<Tube>& tubes, double reach);

}  // namespace tubeplan::tubesheets
