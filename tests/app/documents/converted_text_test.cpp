// Sentences keep their numbers and gain other units, or stay as they are where a unit may belong to several numbers.
#include "app/documents/converted_text.hpp"

#include <gtest/gtest.h>

#include "app/formats/units.hpp"

namespace tubeplan::app {
namespace {

TargetUnits target(const char* length, const char* angle) {
  return {findUnit(UnitKind::kLength, length), findUnit(UnitKind::kAngle, angle)};
}

struct Sentence {
  const char *written, *shown;
};

void expectEach(std::span<const Sentence> sentences, const TargetUnits& units) {
  for (const auto& [written, shown] : sentences) EXPECT_EQ(textInUnits(written, units), shown);
}

TEST(ConvertedText, numbersThatAUnitFollows) {
  constexpr Sentence kSentences[] = {
      {"the error of 0.100 in is explained", "the error of 2.54 mm is explained"},
      {"falls from 1 in to 0.5 in; the floor is 0.01 in.", "falls from 25.4 mm to 12.7 mm; the floor is 0.254 mm."},
      {"hysteresis at theta4 (half width 1.000 ± 0.100 deg)",
       "hysteresis at theta4 (half width 0.01745 ± 0.00175 rad)"},
      {"shift -1 to 2 in and turn \u22121 deg", "shift -25.4 to 50.8 mm and turn -0.0175 rad"},
      {"compliance 2.00 deg/(lbf*in)", "compliance 0.00137 rad/(lbf*mm)"},
      {"12.3456 in, as at reading P12", "313.578 mm, as at reading P12"},
      {"0.0222 in (root mean square)", "0.564 mm (root mean square)"},
      {"0.1 in more along y at -3.5 deg than at 2 deg (8 % of it)",
       "2.54 mm more along y at -0.0611 rad than at 0.0349 rad (8 % of it)"},
      {"0.02 in, 2.4 times the floor of 0.01 in.", "0.508 mm, 2.4 times the floor of 0.254 mm."},
      {"0 in to 1000 in", "0 mm to 25400 mm"},
      {"1e-3 in or more", "0.0254 mm or more"},
  };
  expectEach(kSentences, target("mm", "rad"));
}

TEST(ConvertedText, whatIsNoLengthOrAngleStays) {
  for (const char* text :
       {"5 in the mean square", "12 in all", "1.2, 3.4 in", "x 1.2, y 3.4 in", "x 1, y 3.4 in", "0.1-0.2 in", "40 lbf",
        "30 %", "tube R12C40 in 300 holes", "P12 in", "2 of 3 readings", "", "in", "0.5 percent", "of 1.2 and 3.4 in"})
    EXPECT_EQ(textInUnits(text, target("mm", "rad")), text);
}

TEST(ConvertedText, ownUnitsChangeNothing) {
  for (const char* text : {"the error of 0.100 mm", "1.50 ± 0.10 rad", "0.1234567 mm to 5 mm"})
    EXPECT_EQ(textInUnits(text, target("mm", "rad")), text);
}

}  // namespace
}  // namespace tubeplan::app
