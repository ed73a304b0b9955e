#include "tubesheets/tube_choice.hpp"

#include <algorithm>
#include <cassert>
#include <limits>

namespace tubeplan::tubesheets {
namespace {

double squaredDistance(double x0, double y0, const Tube& tube) {
  return (tube.x - x0) * (tube.x - x0) + (tube.y - y0) * (tube.y - y0);
}

int findNearestToMiddle(const Sheet& sheet, const std::vector<int>& candidates) {
  double x = 0, y = 0;
  for (const int tube : candidates) {
    x += sheet.tubes[tube].x / static_cast<double>(candidates.size());
    y += sheet.tubes[tube].y / static_cast<double>(candidates.size());
  }
  return *std::min_element(candidates.begin(), candidates.end(), [&](int a, int b) {
    return squaredDistance(x, y, sheet.tubes[a]) < squaredDistance(x, y, sheet.tubes[b]);
  });
}

}  // namespace

std::vector<int> peelDepths(const Sheet& sheet) {
  const std::vector<std::vector<int>> neighbours = findNeighbours(sheet);
  std::size_t most = 0;
  for (const auto& around : neighbours) most = std::max(most, around.size());
  std::vector<std::size_t> open_neighbours(neighbours.size());
  std::vector<int> depths(neighbours.size(), 0), layer;
  for (int tube = 0; tube < static_cast<int>(neighbours.size()); ++tube) {
    open_neighbours[tube] = neighbours[tube].size();
    if (open_neighbours[tube] < most) layer.push_back(tube);
  }
  // If all tubes have the same number of neighbours (sheets of one or two tubes), all are on the periphery.
  if (layer.empty()) return std::vector<int>(neighbours.size(), 1);
  for (int depth = 1; !layer.empty(); ++depth) {
    for (const int tube : layer) depths[tube] = depth;
    std::vector<int> next;
    for (const int tube : layer)
      for (const int other : neighbours[tube])
        if (depths[other] == 0 && open_neighbours[other]-- == most) next.push_back(other);
    layer = std::move(next);
  }
  return depths;
}

std::vector<int> chooseSpread(const Sheet& sheet, const std::vector<int>& candidates, int count) {
  if (count >= static_cast<int>(candidates.size())) return candidates;
  std::vector<int> chosen;
  std::vector<double> distances(candidates.size(), std::numeric_limits<double>::infinity());
  int latest = candidates.empty() || count <= 0 ? -1 : findNearestToMiddle(sheet, candidates);
  while (static_cast<int>(chosen.size()) < count) {
    chosen.push_back(latest);
    for (std::size_t i = 0; i < candidates.size(); ++i)
      distances[i] = std::min(
          distances[i], squaredDistance(sheet.tubes[latest].x, sheet.tubes[latest].y, sheet.tubes[candidates[i]]));
    latest = candidates[std::max_element(distances.begin(), distances.end()) - distances.begin()];
  }
  std::sort(chosen.begin(), chosen.end());
  return chosen;
}

std::vector<int> chooseEvery(const std::vector<int>& candidates, int k) {
  assert(k >= 1);
  std::vector<int> chosen;
  for (std::size_t i = 0; i < candidates.size(); i += static_cast<std::size_t>(k)) chosen.push_back(candidates[i]);
  return chosen;
}

}  // namespace tubeplan::tubesheets
