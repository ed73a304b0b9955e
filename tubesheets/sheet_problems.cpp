// findSheetProblems(): one small check per fault.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "tubesheets/hole_grid.hpp"
#include "tubesheets/median.hpp"
#include "tubesheets/sheet.hpp"

namespace tubeplan::tubesheets {
namespace {

constexpr std::size_t kMostProblems = 20;
constexpr double kFarthestHole = 100;  // largest coordinate of a hole [m]
// Accepted range of the spacing, in pitches. A mistaken unit changes the spacing by a factor of 2.54 or more.
constexpr double kLeastSpacing = 0.6, kMostSpacing = 2.2;

std::string nameOf(const Tube& tube) { return tubeName(tube.row, tube.column); }

std::string placeOf(const Tube& tube) { return fmt::format("({:.6g}, {:.6g}) m", tube.x, tube.y); }

bool isGoodPlace(const Tube& tube) { return std::abs(tube.x) <= kFarthestHole && std::abs(tube.y) <= kFarthestHole; }

void findNumberProblems(const Sheet& sheet, std::vector<Problem>& problems) {
  if (!std::isfinite(sheet.pitch) || sheet.pitch <= 0)
    problems.push_back({"pitch", fmt::format("{} m", sheet.pitch), "a number above zero", ""});
  if (!std::isfinite(sheet.hole_diameter) || sheet.hole_diameter <= 0 || sheet.hole_diameter >= sheet.pitch)
    problems.push_back({"hole_diameter", fmt::format("{} m", sheet.hole_diameter),
                        fmt::format("a length above zero and below the pitch, {} m", sheet.pitch), ""});
  if (sheet.tubes.empty()) problems.push_back({"sheet", "no holes", "at least one hole", ""});
}

void findPlaceProblems(const Sheet& sheet, std::vector<Problem>& problems) {
  for (const Tube& tube : sheet.tubes) {
    if (problems.size() >= kMostProblems) return;
    if (tube.row < 1 || tube.column < 1)
      problems.push_back({nameOf(tube), "a row or column below 1", "rows and columns counted from 1", ""});
    if (!isGoodPlace(tube))
      problems.push_back({nameOf(tube), placeOf(tube),
                          fmt::format("a finite place within {} m of the centre", kFarthestHole),
                          "check the unit in the column's name"});
  }
}

void findOrderProblems(const Sheet& sheet, std::vector<Problem>& problems) {
  for (std::size_t i = 1; i < sheet.tubes.size() && problems.size() < kMostProblems; ++i) {
    const Tube &before = sheet.tubes[i - 1], &tube = sheet.tubes[i];
    if (before.row == tube.row && before.column == tube.column)
      problems.push_back({nameOf(tube), "two holes have this name, at " + placeOf(before) + " and " + placeOf(tube), "",
                          "remove one, or correct its row or column"});
    if (before.row > tube.row || (before.row == tube.row && before.column > tube.column))
      problems.push_back({nameOf(tube),
                          "the hole is listed after " + nameOf(before) + ", but holes go by row, then by column", "",
                          "use makeSheet"});
  }
}

void findLegProblems(const Sheet& sheet, std::vector<Problem>& problems) {
  if (sheet.leg == Leg::kFull) return;
  const double side = sheet.leg == Leg::kHot ? 1 : -1;
  for (const Tube& tube : sheet.tubes) {
    if (problems.size() >= kMostProblems) return;
    if (isGoodPlace(tube) && side * tube.y <= 0)
      problems.push_back({nameOf(tube), fmt::format("y = {:.6g} m", tube.y),
                          fmt::format("y {} 0 in the {} leg", side > 0 ? "above" : "below", legName(sheet.leg)),
                          "a map of the other leg is the mirror image of this one"});
  }
}

void findOverlaps(const Sheet& sheet, std::vector<Problem>& problems) {
  const HoleGrid grid(sheet.tubes, sheet.hole_diameter);
  for (int i = 0; i < static_cast<int>(sheet.tubes.size()); ++i) {
    const Tube& tube = sheet.tubes[i];
    if (!isGoodPlace(tube)) continue;
    for (const int other : grid.findWithin(tube.x, tube.y, sheet.hole_diameter)) {
      if (other <= i) continue;
      if (problems.size() >= kMostProblems) return;
      const double distance = std::hypot(sheet.tubes[other].x - tube.x, sheet.tubes[other].y - tube.y);
      problems.push_back(
          {nameOf(tube) + " and " + nameOf(sheet.tubes[other]),
           fmt::format("the holes overlap: their centres are {:.6g} m apart, and the hole diameter is {:.6g} m",
                       distance, sheet.hole_diameter),
           "", "correct their coordinates or the hole diameter"});
    }
  }
}

std::optional<double> findMedianSpacing(const Sheet& sheet) {
  std::vector<double> spacings;
  for (std::size_t i = 1; i < sheet.tubes.size(); ++i) {
    const Tube &before = sheet.tubes[i - 1], &tube = sheet.tubes[i];
    // adjacent columns on triangular lattices differ by 2
    const bool are_adjacent = before.row == tube.row && tube.column - before.column <= 2;
    if (are_adjacent) spacings.push_back(std::hypot(tube.x - before.x, tube.y - before.y));
  }
  if (spacings.empty()) return std::nullopt;
  return medianOf(std::move(spacings));
}

void findSpacingProblems(const Sheet& sheet, std::vector<Problem>& problems) {
  const std::optional<double> spacing = findMedianSpacing(sheet);
  if (!spacing || (*spacing >= kLeastSpacing * sheet.pitch && *spacing <= kMostSpacing * sheet.pitch)) return;
  problems.insert(problems.begin(), {"spacing", fmt::format("holes {:.6g} m apart along a row", *spacing),
                                     fmt::format("about the pitch, {:.6g} m", sheet.pitch),
                                     "check the unit in the column's name, and the pitch"});
}

// Returns the distance to the nearest other hole [m] for each hole that has one within `reach` [m].
std::vector<double> nearestWithin(const Sheet& sheet, double reach) {
  const HoleGrid grid(sheet.tubes, reach);
  std::vector<double> distances;
  for (int i = 0; i < static_cast<int>(sheet.tubes.size()); ++i) {
    const Tube& tube = sheet.tubes[i];
    double nearest = reach;
    for (const int other : grid.findWithin(tube.x, tube.y, reach))
      if (other != i)
        nearest = std::min(nearest, std::hypot(sheet.tubes[other].x - tube.x, sheet.tubes[other].y - tube.y));
    if (nearest < reach) distances.push_back(nearest);
  }
  return distances;
}

// Checks the pitch against the distances from each hole to the nearest one. With a wrong pitch, no hole would have
// neighbours one pitch away, so every hole would seem to be on the periphery.
void findPitchProblems(const Sheet& sheet, std::vector<double> distances, std::vector<Problem>& problems) {
  constexpr double kAsDrawn = 0.02;  // largest deviation of the median distance from the pitch, as a fraction
  // Overlapping holes are reported separately.
  std::erase_if(distances, [&](double distance) { return distance < sheet.hole_diameter; });
  // The typical spacing is unknown if most holes are isolated.
  if (distances.size() < 2 || 2 * distances.size() < sheet.tubes.size()) return;
  const double distance = medianOf(distances);
  if (std::abs(distance - sheet.pitch) <= kAsDrawn * sheet.pitch) return;
  problems.insert(problems.begin(), {"pitch",
                                     fmt::format("most holes are {:.6g} m from the nearest, but the pitch is {:.6g} m",
                                                 distance, sheet.pitch),
                                     "", "correct the pitch, or the unit in the column's name"});
}

// Reports coordinates that are probably in millimetres but were read as inches: the typical distance between nearest
// holes is a whole multiple of 25.4 pitches, but not of the pitch.
void findUnitProblems(const Sheet& sheet, std::vector<Problem>& problems) {
  constexpr double kExact = 1e-3, kFar = 300;  // relative tolerance of a multiple; largest distance in pitches
  constexpr std::size_t kMostComparedTubes = 500;
  if (sheet.tubes.size() < 4) return;
  std::vector<double> distances;
  for (std::size_t i = 0; i < std::min(sheet.tubes.size(), kMostComparedTubes); ++i) {
    double nearest = kFar * sheet.pitch;
    for (std::size_t k = 0; k < sheet.tubes.size(); ++k)
      if (k != i)
        nearest =
            std::min(nearest, std::hypot(sheet.tubes[k].x - sheet.tubes[i].x, sheet.tubes[k].y - sheet.tubes[i].y));
    distances.push_back(nearest / sheet.pitch);
  }
  const double pitches = medianOf(distances);
  const auto isMultipleOf = [&](double unit) {
    const double times = pitches / unit;
    return times > 0.5 && std::abs(times - std::round(times)) < kExact * times;
  };
  if (pitches >= kFar || isMultipleOf(1) || !isMultipleOf(25.4)) return;
  problems.insert(problems.begin(),
                  {"spacing", fmt::format("holes {:.6g} m apart, {:.4g} pitches", pitches * sheet.pitch, pitches),
                   "a whole number of pitches", "they may be in millimetres: check the unit in the column's name"});
}

// Checks the distances between nearest holes: against the pitch if they are near, and for a wrong unit if all are far.
void findNeighbourProblems(const Sheet& sheet, std::vector<Problem>& problems) {
  constexpr double kNear = 1.6;  // largest distance between near holes, in pitches
  auto distances = nearestWithin(sheet, kMostSpacing * sheet.pitch);
  if (distances.empty()) {
    findUnitProblems(sheet, problems);
    return;
  }
  std::erase_if(distances, [&](double distance) { return !(distance < kNear * sheet.pitch); });
  findPitchProblems(sheet, std::move(distances), problems);
}

}  // namespace

std::vector<Problem> findSheetProblems(const Sheet& sheet) {
  std::vector<Problem> problems;
  findNumberProblems(sheet, problems);
  if (!problems.empty()) return problems;
  findPlaceProblems(sheet, problems);
  findOrderProblems(sheet, problems);
  if (!problems.empty()) return problems;
  findSpacingProblems(sheet, problems);
  if (problems.empty()) findNeighbourProblems(sheet, problems);
  findLegProblems(sheet, problems);
  findOverlaps(sheet, problems);
  if (sheet.manway)
    for (const Problem& problem : findManwayProblems(*sheet.manway, sheet.leg)) problems.push_back(problem);
  return problems;
}

}  // namespace tubeplan::tubesheets
