// Drills with the tool under a wrong tube: legs exchanged, the map mirrored, one row off, under a neighbour. None of
// them passes the confirmation.
#include <gtest/gtest.h>

#include <random>

#include "app/outage/job_desk.hpp"
#include "tests/app/outage/job_fixture.hpp"

namespace tubeplan::app {
namespace {

using tubesheets::Leg;

struct Drill {
  const char* name;
  /// Returns the tube that the tool is at when `meant` is the tube that the job means.
  TubeAddress (*at)(const TubeAddress& meant, std::mt19937_64& random);
};

TubeAddress moved(const TubeAddress& tube, int rows, int columns) {
  return {tube.generator, tube.leg, tube.row + rows, tube.column + columns};
}

constexpr int kColumns = 114;  // columns of the mock-up's sheet

const Drill kDrills[] = {
    {"legs exchanged",
     [](const TubeAddress& meant, std::mt19937_64&) {
       return TubeAddress{meant.generator, meant.leg == Leg::kHot ? Leg::kCold : Leg::kHot, meant.row, meant.column};
     }},
    {"map mirrored",
     [](const TubeAddress& meant, std::mt19937_64&) {
       return TubeAddress{meant.generator, meant.leg, meant.row, kColumns + 1 - meant.column};
     }},
    {"one row off",
     [](const TubeAddress& meant, std::mt19937_64& random) { return moved(meant, random() % 2 == 0 ? 1 : -1, 0); }},
    {"under a neighbour",
     [](const TubeAddress& meant, std::mt19937_64& random) { return moved(meant, 0, random() % 2 == 0 ? 1 : -1); }},
    {"another steam generator",
     [](const TubeAddress& meant, std::mt19937_64&) {
       return TubeAddress{"B", meant.leg, meant.row, meant.column};
     }},
};

class WrongTube : public JobTest {};

TEST_F(WrongTube, NoneOf500DrillsPassesConfirmation) {
  JobStore store(
      made("  - {name: all, tubes: 'R2-40C20-95', steam_generators: [A], tool: bobbin, confirm: position}\n"));
  const auto items = store.items();
  std::vector<TubeEnd> ends;
  for (const Leg leg : {Leg::kHot, Leg::kCold}) {
    const auto of_leg = store.endsOf("A", leg);
    ends.insert(ends.end(), of_leg.begin(), of_leg.end());
  }
  std::map<std::string, TubeEnd> by_name;
  for (const TubeEnd& end : ends) by_name[addressText(end.tube)] = end;
  const double pitch = store.sheets().front().pitch;
  std::mt19937_64 random(500);
  std::normal_distribution<double> noise(0, 0.05 * pitch);
  int confirmed = 0;
  for (int k = 0; k < 500; ++k) {
    const Drill& drill = kDrills[static_cast<std::size_t>(k) % std::size(kDrills)];
    const TubeAddress meant = items[random() % items.size()].tube, at = drill.at(meant, random);
    EXPECT_FALSE(compareRead(meant, at).is_same) << drill.name << " " << addressText(meant);
    EXPECT_FALSE(compareRead(meant, at).reason.empty());
    if (at.generator != meant.generator) continue;  // a position does not identify the steam generator
    const TubeEnd& hole = by_name.at(addressText(at));
    const auto found = comparePosition(meant, hole.x + noise(random), hole.y + noise(random), ends, pitch);
    EXPECT_FALSE(found.is_same) << drill.name << " " << addressText(meant);
    const TubeEnd& own = by_name.at(addressText(meant));
    confirmed += comparePosition(meant, own.x + noise(random), own.y + noise(random), ends, pitch).is_same;
  }
  EXPECT_EQ(confirmed, 400);  // the right tube passes every time
}

TEST_F(WrongTube, APositionBetweenHolesConfirmsNothing) {
  JobStore store(made("  - {name: all, tubes: R9-11C18-22, steam_generators: [A], tool: bobbin, confirm: position}\n"));
  const auto ends = store.endsOf("A", Leg::kHot);
  const double pitch = store.sheets().front().pitch;
  for (const TubeEnd& end : ends)
    if (end.tube == TubeAddress{"A", Leg::kHot, 9, 18})
      EXPECT_FALSE(comparePosition(end.tube, end.x + pitch / 2, end.y, ends, pitch).is_same);
}

TEST_F(WrongTube, ANameWithoutItsLegIsRefused) {
  for (const char* text : {"R12C40", "A/R12C40", "hot/R12C40", "A/hot", "A/hot/12-40-2", "/hot/R12C40", ""})
    expectSays(messageOf([&] { (void)parseAddress(text, "TUBE"); }), "TUBE");
  EXPECT_EQ(addressText(parseAddress("A/cold/R12C40", "TUBE")), "A/cold/R12C40");
}

}  // namespace
}  // namespace tubeplan::app
