#include "tubesheets/layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "tubesheets/layouts.hpp"
#include "tubesheets/length_unit.hpp"

namespace tubeplan::tubesheets {
namespace {

constexpr double kMostPitchesInRadius = 500;  // about 800,000 holes; real sheets have 16,000
constexpr int kMostLines = 10000;             // largest number of rows, and of columns

double numberAt(const Layout& layout, const LayoutKey& key) {
  return std::visit([&](auto field) { return static_cast<double>(layout.*field); }, key.field);
}

void findKeyProblems(const Layout& layout, const LayoutType& type, std::vector<Problem>& problems) {
  for (const LayoutKey& key : type.keys) {
    const double number = numberAt(layout, key);
    const bool is_good = std::isfinite(number) && (key.required ? number > 0 : number >= 0);
    const bool is_count = std::holds_alternative<int Layout::*>(key.field);
    const std::string found = is_count ? fmt::format("{}", number) : fmt::format("{} m", number);
    const std::string limit = key.required ? "a number above zero" : "zero or more";
    if (!is_good) problems.push_back({std::string(key.name), found, limit, std::string(key.meaning)});
    if (is_good && is_count && number > kMostLines)
      problems.push_back({std::string(key.name), found, fmt::format("at most {}", kMostLines), ""});
  }
}

void findSizeProblems(const Layout& layout, const LayoutType& type, std::vector<Problem>& problems) {
  if (layout.radius / layout.pitch > kMostPitchesInRadius)
    problems.push_back({"radius", fmt::format("{:.6g} pitches", layout.radius / layout.pitch),
                        fmt::format("at most {}", kMostPitchesInRadius), "check the units of pitch and radius"});
  if (layout.stay_radius >= layout.radius)
    problems.push_back({"stay_radius", fmt::format("{:.6g} m", layout.stay_radius),
                        fmt::format("less than the radius, {:.6g} m", layout.radius), ""});
  if (layout.columns > 0 && type.columns_modulo_two >= 0 && layout.columns % 2 != type.columns_modulo_two)
    problems.push_back({"columns", fmt::format("{}", layout.columns), "an odd number, because one column lies on x = 0",
                        "leave out `columns` to have the number derived"});
}

// Reports a layout without holes, and a stated number of columns that does not fit within the radius. In the latter
// case, all column numbers would be shifted, so that names would refer to the wrong tubes.
void findNumberingProblems(const Layout& layout, const LayoutType& type, std::vector<Problem>& problems) {
  const std::vector<Tube> tubes = type.make_tubes(layout);
  if (tubes.empty()) {
    problems.push_back({"layout", "no holes", "at least one hole within the radius", "check first_row against radius"});
    return;
  }
  int first = layout.columns;
  for (const Tube& tube : tubes) first = std::min(first, tube.column);
  if (first > 1)
    problems.push_back(
        {"columns", fmt::format("{}", layout.columns),
         fmt::format("at most {}, because no more fit within the radius", layout.columns - 2 * (first - 1)),
         "leave out `columns` to have the number derived"});
}

}  // namespace

std::vector<Problem> findLayoutProblems(const Layout& layout) {
  std::vector<Problem> problems;
  const LayoutType* type = findLayoutType(layout.type);
  if (type == nullptr) return {{"type", "\"" + layout.type + "\"", "one of " + layoutTypeNames(), ""}};
  findKeyProblems(layout, *type, problems);
  if (problems.empty()) findSizeProblems(layout, *type, problems);
  if (problems.empty()) findNumberingProblems(layout, *type, problems);
  return problems;
}

std::vector<Tube> makeTubes(const Layout& layout) {
  assert(findLayoutProblems(layout).empty());
  std::vector<Tube> tubes = findLayoutType(layout.type)->make_tubes(layout);
  for (Tube& tube : tubes) {
    tube.x = snapLength(tube.x);
    tube.y = snapLength(tube.y);
  }
  return tubes;
}

}  // namespace tubeplan::tubesheets
