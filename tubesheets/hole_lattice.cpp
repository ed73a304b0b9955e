#include "tubesheets/hole_lattice.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "tubesheets/hole_grid.hpp"

namespace tubeplan::tubesheets {

namespace {

constexpr double kReach = 2.6;           // pitches, that holes are compared over
constexpr double kOneStep = 0.1;         // of a pitch, that a step of the lattice may differ from it
constexpr double kAgrees = 0.1;          // pitches, and what is off by more is reported
constexpr std::size_t kEnoughAgree = 4;  // neighbours
constexpr double kMostAgree = 0.7;       // share of the neighbours

// Pitches: no other place of a lattice is as near as one within half of its shortest step.
constexpr double kSurelyShortest = 0.4;

struct Vector {
  double x = 0, y = 0;
};

Vector operator+(Vector a, Vector b) { return {a.x + b.x, a.y + b.y}; }
Vector operator-(Vector a, Vector b) { return {a.x - b.x, a.y - b.y}; }
Vector operator*(double s, Vector a) { return {s * a.x, s * a.y}; }
double dot(Vector a, Vector b) { return a.x * b.x + a.y * b.y; }
double cross(Vector a, Vector b) { return a.x * b.y - a.y * b.x; }
double lengthOf(Vector a) { return std::hypot(a.x, a.y); }

/// In pitches.
Vector placeOf(const Sheet& sheet, int tube) {
  const Tube& at = sheet.tubes[static_cast<std::size_t>(tube)];
  return {at.x / sheet.pitch, at.y / sheet.pitch};
}

std::vector<std::vector<int>> neighboursOf(const Sheet& sheet) {
  const double reach = kReach * sheet.pitch;
  const HoleGrid grid(sheet.tubes, reach);
  std::vector<std::vector<int>> neighbours;
  for (int tube = 0; tube < static_cast<int>(sheet.tubes.size()); ++tube) {
    const Tube& at = sheet.tubes[static_cast<std::size_t>(tube)];
    neighbours.push_back(grid.findWithin(at.x, at.y, reach));
    std::erase(neighbours.back(), tube);
  }
  return neighbours;
}

/// Two shortest steps of a lattice.
struct Basis {
  Vector a, b;

  /// What is left of a difference of places after whole steps: the shortest. Rounding gives it but for one step, where
  /// the two are not at right angles.
  [[nodiscard]] Vector remainder(Vector difference) const {
    const double area = cross(a, b);
    const double s = std::round(cross(difference, b) / area), t = std::round(cross(a, difference) / area);
    Vector shortest = difference - (s * a + t * b);
    const Vector rounded = shortest;
    if (lengthOf(rounded) < kSurelyShortest) return rounded;
    for (const double i : {-1., 0., 1.})
      for (const double k : {-1., 0., 1.})
        if (const Vector other = rounded + i * a + k * b; lengthOf(other) < lengthOf(shortest)) shortest = other;
    return shortest;
  }
};

/// Of the steps from hole to hole: the direction that most have, and the mean of those.
std::optional<Vector> commonStep(const std::vector<Vector>& steps) {
  constexpr int kBins = 180;  // of a degree, over half a turn
  constexpr double kNearBin = 2 * std::numbers::pi / kBins;
  std::array<int, kBins> counts{};
  const auto angleOf = [](Vector step) { return std::atan2(step.y, step.x); };
  for (const Vector& step : steps) {
    const double turns = angleOf(step) / std::numbers::pi + 1;
    ++counts[static_cast<std::size_t>(std::lround(turns * kBins)) % kBins];
  }
  const auto most = std::ranges::max_element(counts);
  if (*most == 0) return std::nullopt;
  const double angle = std::numbers::pi * static_cast<double>(most - counts.begin()) / kBins;
  const Vector direction{std::cos(angle), std::sin(angle)};
  Vector sum;
  int count = 0;
  for (const Vector& step : steps) {
    if (std::abs(cross(direction, step)) > std::sin(kNearBin) * lengthOf(step)) continue;
    sum = sum + (dot(direction, step) < 0 ? -1. : 1.) * step;
    ++count;
  }
  return (1. / count) * sum;
}

std::optional<Basis> basisOf(const Sheet& sheet, const std::vector<std::vector<int>>& neighbours) {
  constexpr double kAcross = 0.7;  // sine of the angle between two steps of a lattice, at least
  std::vector<Vector> steps;
  for (int tube = 0; tube < static_cast<int>(neighbours.size()); ++tube)
    for (const int other : neighbours[static_cast<std::size_t>(tube)]) {
      const Vector step = placeOf(sheet, other) - placeOf(sheet, tube);
      if (other > tube && std::abs(lengthOf(step) - 1) < kOneStep) steps.push_back(step);
    }
  const auto first = commonStep(steps);
  if (!first) return std::nullopt;
  std::erase_if(steps, [&](Vector step) { return std::abs(cross(*first, step)) < kAcross; });
  const auto second = commonStep(steps);
  if (!second) return std::nullopt;
  return Basis{*first, *second};
}

/// The places of the lattice that a hole is nearest to, as each neighbour has it, less the hole's own.
std::vector<Vector> shiftsOf(const Sheet& sheet, const Basis& basis, int tube, const std::vector<int>& neighbours) {
  std::vector<Vector> shifts;
  for (const int other : neighbours) shifts.push_back(basis.remainder(placeOf(sheet, other) - placeOf(sheet, tube)));
  return shifts;
}

/// Whether most of the holes about it have the hole where it is.
bool isOnLattice(const std::vector<Vector>& shifts) {
  const auto agree = std::ranges::count_if(shifts, [](Vector shift) { return lengthOf(shift) < kAgrees; });
  return 2 * static_cast<std::size_t>(agree) >= shifts.size();
}

/// The mean of the shifts that agree with one another, where they are enough and most of them.
std::optional<Vector> agreedShift(const Basis& basis, const std::vector<Vector>& shifts) {
  for (const Vector& centre : shifts) {
    Vector sum;
    std::size_t count = 0;
    for (const Vector& shift : shifts) {
      // Half a pitch off is so to either side.
      const Vector beside = basis.remainder(shift - centre);
      if (lengthOf(beside) >= kAgrees) continue;
      sum = sum + centre + beside;
      ++count;
    }
    if (count >= kEnoughAgree && static_cast<double>(count) >= kMostAgree * static_cast<double>(shifts.size()))
      return (1. / static_cast<double>(count)) * sum;
  }
  return std::nullopt;
}

}  // namespace

std::vector<HoleOffLattice> findHolesOffLattice(const Sheet& sheet) {
  std::vector<HoleOffLattice> found;
  const auto neighbours = neighboursOf(sheet);
  const auto basis = basisOf(sheet, neighbours);
  if (!basis) return found;
  std::vector<char> is_on;
  for (int tube = 0; tube < static_cast<int>(sheet.tubes.size()); ++tube)
    is_on.push_back(isOnLattice(shiftsOf(sheet, *basis, tube, neighbours[static_cast<std::size_t>(tube)])));
  for (int tube = 0; tube < static_cast<int>(sheet.tubes.size()); ++tube) {
    if (is_on[static_cast<std::size_t>(tube)]) continue;
    std::vector<int> good = neighbours[static_cast<std::size_t>(tube)];
    std::erase_if(good, [&](int other) { return !is_on[static_cast<std::size_t>(other)]; });
    const auto shift = agreedShift(*basis, shiftsOf(sheet, *basis, tube, good));
    if (!shift || lengthOf(*shift) < kAgrees) continue;
    const Vector place = placeOf(sheet, tube) + *shift;
    found.push_back({tube, lengthOf(*shift) * sheet.pitch, place.x * sheet.pitch, place.y * sheet.pitch});
  }
  return found;
}

}  // namespace tubeplan::tubesheets
