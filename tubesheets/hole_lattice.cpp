#include "tubesheets/hole_lattice.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "tubesheets/hole_grid.hpp"

namespace tubeplan::tubesheets {

using Eigen::Vector2d;

namespace {

constexpr double kReach = 2.6;  // distance over which holes are compared, in pitches
// largest deviation of a lattice step's length from the pitch, as a fraction of the pitch
constexpr double kOneStep = 0.1;
constexpr double kAgrees = 0.1;          // smallest deviation from the lattice that is reported, in pitches
constexpr std::size_t kEnoughAgree = 4;  // smallest number of neighbours that must agree
constexpr double kMostAgree = 0.7;       // smallest fraction of the neighbours that must agree

// A remainder shorter than this [pitches] cannot be improved, because it is less than half of the shortest lattice
// step.
constexpr double kProvablyShortest = 0.4;

double cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Returns a hole's position, in pitches.
Vector2d placeOf(const Sheet& sheet, int tube) {
  const Tube& at = sheet.tubes[static_cast<std::size_t>(tube)];
  return {at.x / sheet.pitch, at.y / sheet.pitch};
}

/// The two shortest independent steps of a lattice, in pitches.
struct Basis {
  Vector2d a, b;

  /// Subtracts whole lattice steps from a difference of positions and returns the shortest vector that can remain. If
  /// the two steps are oblique, rounding may be one step off, so the neighbouring remainders are also tried.
  [[nodiscard]] Vector2d remainder(const Vector2d& difference) const {
    const double area = cross(a, b);
    const double s = std::round(cross(difference, b) / area), t = std::round(cross(a, difference) / area);
    Vector2d shortest = difference - (s * a + t * b);
    const Vector2d rounded = shortest;
    if (rounded.norm() < kProvablyShortest) return rounded;
    for (const double i : {-1., 0., 1.})
      for (const double k : {-1., 0., 1.})
        if (const Vector2d other = rounded + i * a + k * b; other.norm() < shortest.norm()) shortest = other;
    return shortest;
  }
};

/// Returns the mean of the steps in the most common direction, with opposite steps reversed; std::nullopt if there are
/// no steps.
std::optional<Vector2d> commonStep(const std::vector<Vector2d>& steps) {
  constexpr int kBins = 180;  // bins of one degree over half a turn
  constexpr double kNearBin = 2 * std::numbers::pi / kBins;
  std::array<int, kBins> counts{};
  const auto angleOf = [](const Vector2d& step) { return std::atan2(step.y(), step.x()); };
  for (const Vector2d& step : steps) {
    const double turns = angleOf(step) / std::numbers::pi + 1;
    ++counts[static_cast<std::size_t>(std::lround(turns * kBins)) % kBins];
  }
  const auto most = std::ranges::max_element(counts);
  if (*most == 0) return std::nullopt;
  const double angle = std::numbers::pi * static_cast<double>(most - counts.begin()) / kBins;
  const Vector2d direction{std::cos(angle), std::sin(angle)};
  Vector2d sum = Vector2d::Zero();
  int count = 0;
  for (const Vector2d& step : steps) {
    if (std::abs(cross(direction, step)) > std::sin(kNearBin) * step.norm()) continue;
    sum += (direction.dot(step) < 0 ? -1. : 1.) * step;
    ++count;
  }
  return (1. / count) * sum;
}

std::optional<Basis> basisOf(const Sheet& sheet, const std::vector<std::vector<int>>& neighbours) {
  constexpr double kAcross = 0.7;  // smallest sine of the angle between the two basis steps
  std::vector<Vector2d> steps;
  for (int tube = 0; tube < static_cast<int>(neighbours.size()); ++tube)
    for (const int other : neighbours[static_cast<std::size_t>(tube)]) {
      const Vector2d step = placeOf(sheet, other) - placeOf(sheet, tube);
      if (other > tube && std::abs(step.norm() - 1) < kOneStep) steps.push_back(step);
    }
  const auto first = commonStep(steps);
  if (!first) return std::nullopt;
  std::erase_if(steps, [&](const Vector2d& step) { return std::abs(cross(*first, step)) < kAcross; });
  const auto second = commonStep(steps);
  if (!second) return std::nullopt;
  return Basis{*first, *second};
}

/// For each neighbour, returns the shift [pitches] from the hole to the nearest point of that neighbour's lattice.
std::vector<Vector2d> shiftsOf(const Sheet& sheet, const Basis& basis, int tube, const std::vector<int>& neighbours) {
  std::vector<Vector2d> shifts;
  for (const int other : neighbours) shifts.push_back(basis.remainder(placeOf(sheet, other) - placeOf(sheet, tube)));
  return shifts;
}

/// Returns true if at least half of the neighbours agree with the hole's position.
bool isOnLattice(const std::vector<Vector2d>& shifts) {
  const auto agree = std::ranges::count_if(shifts, [](const Vector2d& shift) { return shift.norm() < kAgrees; });
  return 2 * static_cast<std::size_t>(agree) >= shifts.size();
}

/// Returns the mean of the shifts that agree with each other; std::nullopt if they are too few or too small a fraction
/// of all shifts.
std::optional<Vector2d> agreedShift(const Basis& basis, const std::vector<Vector2d>& shifts) {
  for (const Vector2d& centre : shifts) {
    Vector2d sum = Vector2d::Zero();
    std::size_t count = 0;
    for (const Vector2d& shift : shifts) {
      // Shifts are compared modulo lattice steps, because a shift of half a step may point to either of two lattice
      // points.
      const Vector2d remainder = basis.remainder(shift - centre);
      if (remainder.norm() >= kAgrees) continue;
      sum += centre + remainder;
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
  const auto neighbours = neighboursWithin(sheet.tubes, kReach * sheet.pitch);
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
    if (!shift || shift->norm() < kAgrees) continue;
    const Vector2d place = placeOf(sheet, tube) + *shift;
    found.push_back({tube, shift->norm() * sheet.pitch, place.x() * sheet.pitch, place.y() * sheet.pitch});
  }
  return found;
}

}  // namespace tubeplan::tubesheets
