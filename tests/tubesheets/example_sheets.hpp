// Tube sheets for the tests of this folder, some published and some fitted, with dimensions in inches as published.
#pragma once

#include <limits>
#include <ostream>
#include <string>
#include <vector>

#include "tubesheets/sheet.hpp"

namespace tubeplan::tubesheets {

inline constexpr double kMetresPerInch = 0.0254;
inline constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// Returns a layout from dimensions in inches.
inline Layout layoutInInches(const std::string& type, double pitch, double first_row, double radius,
                             double stay_radius = 0, int rows = 0, int columns = 0) {
  return {type,
          pitch * kMetresPerInch,
          first_row * kMetresPerInch,
          radius * kMetresPerInch,
          stay_radius * kMetresPerInch,
          rows,
          columns};
}

struct ExampleSheet {
  std::string name;
  SheetDescription description;
  int holes, rows, columns;
};

inline void PrintTo(const ExampleSheet& example, std::ostream* out) { *out << example.name; }

inline ExampleSheet example(const std::string& name, const Layout& layout, double hole, Leg leg, int holes, int rows,
                            int columns) {
  return {name, {name, layout, hole * kMetresPerInch, leg, ViewedFrom::kBelow}, holes, rows, columns};
}

/// Returns seven sheets with their hole counts; `columns` is 0 if the number of columns is not published.
inline std::vector<ExampleSheet> exampleSheets() {
  return {
      example("W44", layoutInInches("square", 1.234, 2.19, 57.23, 0, 45, 92), 0.885, Leg::kHot, 3260, 45, 92),
      example("W51", layoutInInches("square", 1.28125, 2.19, 60.49, 0, 46, 94), 0.885, Leg::kHot, 3388, 46, 94),
      example("WD3", layoutInInches("square", 1.0625, 2.28, 60.39, 0, 49, 114), 0.760, Leg::kHot, 4674, 49, 114),
      example("WF", layoutInInches("square", 0.980, 2.20, 59.739, 0, 59, 122), 0.698, Leg::kHot, 5626, 59, 122),
      example("CE3410", layoutInInches("triangular", 1.0, 2.0, 73.68, 12), 0.760, Leg::kHot, 9350, 83, 295),
      example("EPR", layoutInInches("triangular", 27.43 / 25.4, 2.2, 63.08), 0.760, Leg::kHot, 5979, 0, 0),
      example("OTSG", layoutInInches("disc", 0.875, 0, 57.25), 0.635, Leg::kFull, 15529, 151, 131),
  };
}

/// Returns the description of the mock-up's hot leg, which has 4,674 holes.
inline SheetDescription mockupDescription() { return exampleSheets()[2].description; }

/// Returns a half-disc of 8 columns and 4 rows on a square lattice of pitch 1 in, small enough to count by hand: rows 1
/// and 2 have columns 1 to 8, row 3 has columns 2 to 7, and row 4 has columns 3 to 6.
inline SheetDescription smallDescription() {
  return {"small", layoutInInches("square", 1.0, 0.5, 4.0), 0.7 * kMetresPerInch, Leg::kHot, ViewedFrom::kBelow};
}

}  // namespace tubeplan::tubesheets
