// Tests of the check of hole names against positions: maps with exchanged names, and maps with other numbering schemes.
#include "tubesheets/hole_names.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/tubesheets/example_sheets.hpp"

namespace tubeplan::tubesheets {
namespace {

class HoleNames : public testing::TestWithParam<ExampleSheet> {
 protected:
  Sheet sheet_ = makeSheet(GetParam().description);

  /// Exchanges the positions of holes `a` and `b`.
  void exchange(std::size_t a, std::size_t b) {
    std::swap(sheet_.tubes[a].x, sheet_.tubes[b].x);
    std::swap(sheet_.tubes[a].y, sheet_.tubes[b].y);
  }
};

TEST_P(HoleNames, OfADrawingAreRight) { EXPECT_TRUE(findMisnamedHoles(sheet_).empty()); }

TEST_P(HoleNames, ScatterOfManufactureATurnAndAMirrorAreNoFault) {
  std::mt19937_64 generator(7);
  std::normal_distribution<double> error(0, 0.010 * kMetresPerInch);
  for (Tube& tube : sheet_.tubes) {
    const double x = tube.x + error(generator), y = tube.y + error(generator);
    tube.x = -std::cos(0.3) * x - std::sin(0.3) * y;
    tube.y = -std::sin(0.3) * x + std::cos(0.3) * y;
  }
  EXPECT_TRUE(findMisnamedHoles(sheet_).empty());
}

TEST_P(HoleNames, TwoThatAreExchangedAreNamedWithOneAnother) {
  const std::size_t k = sheet_.tubes.size() / 3;
  exchange(k, k + 1);
  const auto found = findMisnamedHoles(sheet_);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].tube, static_cast<int>(k));
  EXPECT_EQ(found[0].tube_at_position, static_cast<int>(k + 1));
  EXPECT_EQ(found[1].tube_at_position, static_cast<int>(k));
}

TEST_P(HoleNames, TwoOfNeighbouringRowsThatAreExchangedAreNamed) {
  const std::size_t k = sheet_.tubes.size() / 2;
  const auto above = std::find_if(sheet_.tubes.begin() + static_cast<std::ptrdiff_t>(k), sheet_.tubes.end(),
                                  [&](const Tube& tube) { return tube.row == sheet_.tubes[k].row + 1; });
  ASSERT_NE(above, sheet_.tubes.end());
  exchange(k, static_cast<std::size_t>(above - sheet_.tubes.begin()));
  EXPECT_EQ(findMisnamedHoles(sheet_).size(), 2u);
}

TEST_P(HoleNames, RowsThatCountOnAcrossALaneAreNoFault) {
  for (Tube& tube : sheet_.tubes)
    if (tube.x > 0) tube.x += 3 * sheet_.pitch;
  EXPECT_TRUE(findMisnamedHoles(sheet_).empty());
}

INSTANTIATE_TEST_SUITE_P(All, HoleNames, testing::ValuesIn(exampleSheets()),
                         [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace tubeplan::tubesheets
