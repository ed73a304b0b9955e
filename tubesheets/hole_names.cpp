#include "tubesheets/hole_names.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <map>

#include "tubesheets/median.hpp"

namespace tubeplan::tubesheets {

using Eigen::Vector2d;

namespace {

// Smallest distance [pitches] from the expected position at which a hole is reported as misnamed.
constexpr double kOff = 0.5;
constexpr std::size_t kMost = 20;       // upper bound on the number of misnamed holes
constexpr std::size_t kLeast = 2;       // this many misnamed holes are always allowed
constexpr double kMostShare = 0.02;     // number of misnamed holes allowed, as a fraction of all holes
constexpr std::size_t kLeastInRow = 4;  // smallest number of holes that determine where a row begins

Vector2d inPlane(const Tube& tube) { return {tube.x, tube.y}; }

/// Returns the median of each coordinate, so that a few wrong coordinates have no influence.
Vector2d medianPlace(const std::vector<Vector2d>& vectors) {
  std::vector<double> x, y;
  for (const Vector2d& v : vectors) x.push_back(v.x()), y.push_back(v.y());
  return {medianOf(std::move(x)), medianOf(std::move(y))};
}

/// Returns the step from one column to the next [m]; zero if no row has two holes.
Vector2d columnStep(const Sheet& sheet) {
  std::vector<Vector2d> steps;
  for (std::size_t k = 1; k < sheet.tubes.size(); ++k) {
    const Tube &a = sheet.tubes[k - 1], &b = sheet.tubes[k];
    if (a.row == b.row) steps.push_back((inPlane(b) - inPlane(a)) / (b.column - a.column));
  }
  return steps.empty() ? Vector2d::Zero() : medianPlace(steps);
}

/// Returns the position of column 0 [m] for each row with enough holes, keyed by row number.
std::map<int, Vector2d> rowOrigins(const Sheet& sheet, const Vector2d& step) {
  std::map<int, std::vector<Vector2d>> by_row;
  for (const Tube& tube : sheet.tubes) by_row[tube.row].push_back(inPlane(tube) - tube.column * step);
  std::map<int, Vector2d> origins;
  for (const auto& [row, each] : by_row)
    if (each.size() >= kLeastInRow) origins.emplace(row, medianPlace(each));
  return origins;
}

int holeAt(const Sheet& sheet, const Vector2d& place) {
  for (std::size_t k = 0; k < sheet.tubes.size(); ++k)
    if ((inPlane(sheet.tubes[k]) - place).norm() < kOff * sheet.pitch) return static_cast<int>(k);
  return -1;
}

}  // namespace

std::vector<MisnamedHole> findMisnamedHoles(const Sheet& sheet) {
  const Vector2d step = columnStep(sheet);
  const auto origins = rowOrigins(sheet, step);
  const auto most =
      std::clamp(static_cast<std::size_t>(kMostShare * static_cast<double>(sheet.tubes.size())), kLeast, kMost);
  std::vector<MisnamedHole> found;
  for (std::size_t k = 0; k < sheet.tubes.size(); ++k) {
    const Tube& tube = sheet.tubes[k];
    const auto origin = origins.find(tube.row);
    if (origin == origins.end()) continue;
    const Vector2d expected = origin->second + tube.column * step;
    if ((inPlane(tube) - expected).norm() < kOff * sheet.pitch) continue;
    if (found.size() == most) return {};
    found.push_back({static_cast<int>(k), expected.x(), expected.y(), holeAt(sheet, expected)});
  }
  return found;
}

}  // namespace tubeplan::tubesheets
