// Tests of the check of hole coordinates against the lattice, with and without errors in the coordinates.
#include "tubesheets/hole_lattice.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/tubesheets/example_sheets.hpp"

namespace tubeplan::tubesheets {
namespace {

class HoleLattice : public testing::TestWithParam<ExampleSheet> {
 protected:
  Sheet sheet_ = makeSheet(GetParam().description);

  void scatter(double sigma) {
    std::mt19937_64 generator(7);
    std::normal_distribution<double> error(0, sigma);
    for (Tube& tube : sheet_.tubes) {
      tube.x += error(generator);
      tube.y += error(generator);
    }
  }
  void turn(double angle) {
    for (Tube& tube : sheet_.tubes) {
      const double x = std::cos(angle) * tube.x - std::sin(angle) * tube.y;
      tube.y = std::sin(angle) * tube.x + std::cos(angle) * tube.y;
      tube.x = x;
    }
  }
};

TEST_P(HoleLattice, OfADrawingIsKept) { EXPECT_TRUE(findHolesOffLattice(sheet_).empty()); }

TEST_P(HoleLattice, ScatterOfManufactureAndATurnAreNoFault) {
  scatter(0.010 * kMetresPerInch);
  turn(0.3);
  EXPECT_TRUE(findHolesOffLattice(sheet_).empty());
}

TEST_P(HoleLattice, PartsThatAreShiftedAreNoFault) {
  scatter(0.010 * kMetresPerInch);
  for (Tube& tube : sheet_.tubes)
    if (tube.x > 5 * sheet_.pitch) tube.x += 0.37 * sheet_.pitch;
  EXPECT_TRUE(findHolesOffLattice(sheet_).empty());
}

TEST_P(HoleLattice, AHoleHalfAPitchOffIsNamedWithItsDistanceAndItsPlace) {
  scatter(0.010 * kMetresPerInch);
  const int tube = static_cast<int>(sheet_.tubes.size() / 3);
  for (const double share : {0.5, 0.2}) {
    Sheet wrong = sheet_;
    auto& hole = wrong.tubes[static_cast<std::size_t>(tube)];
    hole.x += share * sheet_.pitch;
    const auto off = findHolesOffLattice(wrong);
    ASSERT_EQ(off.size(), 1u);
    EXPECT_EQ(off[0].tube, tube);
    EXPECT_NEAR(off[0].distance, share * sheet_.pitch, 0.03 * sheet_.pitch);
    // If the hole is half a pitch off, the lattice points on both sides are equally near, and either may be reported.
    const double back = std::hypot(off[0].x - hole.x + share * sheet_.pitch, off[0].y - hole.y);
    if (share < 0.5) {
      EXPECT_NEAR(back, 0, 0.03 * sheet_.pitch);
    }
  }
}

TEST_P(HoleLattice, EveryHoleOfThreeThatAreOffIsNamed) {
  const std::size_t count = sheet_.tubes.size();
  for (const std::size_t tube : {count / 4, count / 2, count / 2 + 1}) sheet_.tubes[tube].y += 0.3 * sheet_.pitch;
  EXPECT_EQ(findHolesOffLattice(sheet_).size(), 3u);
}

INSTANTIATE_TEST_SUITE_P(All, HoleLattice, testing::ValuesIn(exampleSheets()),
                         [](const auto& info) { return info.param.name; });

TEST(FewHoles, MakeNoLattice) {
  Sheet sheet = makeSheet(smallDescription());
  sheet.tubes.resize(3);
  sheet.tubes[1].y += 0.3 * sheet.pitch;
  EXPECT_TRUE(findHolesOffLattice(sheet).empty());
}

}  // namespace
}  // namespace tubeplan::tubesheets
