#include "tubesheets/manway.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "tests/tubesheets/example_sheets.hpp"
#include "tubesheets/sheet.hpp"

namespace tubeplan::tubesheets {
namespace {

std::string firstProblem(const Manway& manway, Leg leg) {
  const auto problems = findManwayProblems(manway, leg);
  return problems.empty() ? "" : problems.front().what + ": " + problems.front().expected;
}

const Manway kHotManway{{-0.84, 0.84, -1.07}, 0.4};

TEST(Manway, liesInItsDirectionFromTheMiddle) {
  EXPECT_TRUE(kHotManway.direction().isApprox(Eigen::Vector2d(-1, 1) / std::sqrt(2.)));
}

TEST(Manway, isInItsOwnLeg) {
  EXPECT_EQ(firstProblem(kHotManway, Leg::kHot), "");
  EXPECT_EQ(firstProblem(kHotManway, Leg::kFull), "");
  EXPECT_EQ(firstProblem(kHotManway, Leg::kCold), "manway.center: y below 0 in the cold leg");
  EXPECT_EQ(firstProblem({{-0.84, -0.84, -1.07}, 0.4}, Leg::kCold), "");
  EXPECT_EQ(firstProblem({{-0.84, -0.84, -1.07}, 0.4}, Leg::kHot), "manway.center: y above 0 in the hot leg");
}

TEST(Manway, refusesWhatIsNoOpeningInTheBowl) {
  for (const double diameter : {0., -0.4, kNan, std::numeric_limits<double>::infinity(), 5.})
    EXPECT_TRUE(firstProblem({kHotManway.centre, diameter}, Leg::kHot).starts_with("manway.diameter")) << diameter;
  EXPECT_TRUE(firstProblem({{-0.84, 0.84, 1.07}, 0.4}, Leg::kHot).starts_with("manway.center: z below 0"));
  EXPECT_TRUE(firstProblem({{-0.84, 0.84, 0}, 0.4}, Leg::kHot).starts_with("manway.center: z below 0"));
  EXPECT_TRUE(firstProblem({{0, 0, -1.5}, 0.4}, Leg::kFull).starts_with("manway.center: a place beside"));
  EXPECT_TRUE(firstProblem({{kNan, 0.84, -1}, 0.4}, Leg::kHot).starts_with("manway.center: a finite place"));
  EXPECT_TRUE(firstProblem({{1e9, 0.84, -1}, 0.4}, Leg::kHot).starts_with("manway.center: a finite place"));
}

TEST(Manway, belongsToItsSheetAndNotToItsFingerprint) {
  SheetDescription description = smallDescription();
  const std::string without = makeSheet(description).fingerprint();
  description.manway = kHotManway;
  const Sheet sheet = makeSheet(description);
  EXPECT_EQ(sheet.fingerprint(), without);
  ASSERT_TRUE(sheet.manway.has_value());
  EXPECT_TRUE(findSheetProblems(sheet).empty());
  description.manway->diameter = -1;
  EXPECT_EQ(findSheetProblems(makeSheet(description)).size(), 1u);
}

}  // namespace
}  // namespace tubeplan::tubesheets
