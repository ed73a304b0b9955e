#include "tubesheets/manway.hpp"

#include <fmt/format.h>

#include <cmath>

namespace tubeplan::tubesheets {
namespace {

constexpr double kFarthest = 100;  // largest coordinate of the centre [m]
constexpr double kAside = 1e-6;    // smallest distance of the centre from the sheet's axis [m]

std::string placeOf(const Manway& manway) {
  return fmt::format("({:.6g}, {:.6g}, {:.6g}) m", manway.centre.x(), manway.centre.y(), manway.centre.z());
}

}  // namespace

std::vector<Problem> findManwayProblems(const Manway& manway, Leg leg) {
  const std::string centre = "manway.center";
  if (!(manway.centre.cwiseAbs().maxCoeff() <= kFarthest) || !manway.centre.allFinite())
    return {{centre, placeOf(manway), fmt::format("a finite place within {} m of the sheet's middle", kFarthest), ""}};
  std::vector<Problem> problems;
  const double side = leg == Leg::kHot ? 1 : -1;
  if (!(manway.centre.z() < 0))
    problems.push_back(
        {centre, placeOf(manway), "z below 0, because the bowl hangs below the sheet", "reverse its sign"});
  if (manway.centre.head<2>().norm() < kAside)
    problems.push_back({centre, placeOf(manway), "a place beside the line straight below the sheet's middle", ""});
  else if (leg != Leg::kFull && !(side * manway.centre.y() > 0))
    problems.push_back({centre, placeOf(manway),
                        fmt::format("y {} 0 in the {} leg", side > 0 ? "above" : "below", legName(leg)),
                        "each leg has a manway of its own"});
  if (!std::isfinite(manway.diameter) || manway.diameter <= 0 || manway.diameter >= 2 * manway.centre.norm())
    problems.push_back(
        {"manway.diameter", fmt::format("{:.6g} m", manway.diameter),
         fmt::format("a length above zero and below twice the distance from the sheet's middle, {:.6g} m",
                     2 * manway.centre.norm()),
         ""});
  return problems;
}

}  // namespace tubeplan::tubesheets
