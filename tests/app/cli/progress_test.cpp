#include "app/cli/progress.hpp"

#include <gtest/gtest.h>

namespace tubeplan::app {
namespace {

TEST(Progress, saysHowFarHowFastAndHowLong) {
  EXPECT_EQ(progressLine("planning", 30, 60, 2.0, 80),
            "planning [###############---------------] 30/60  15.0/s  0:02 left");
  EXPECT_EQ(progressLine("planning", 0, 60, 0.0, 80), "planning [------------------------------] 0/60  0.0/s  ");
  EXPECT_EQ(progressLine("planning", 60, 60, 60.0, 80),
            "planning [##############################] 60/60  1.0/s  0:00 left");
}

TEST(Progress, namesWorkOfUnknownLength) {
  EXPECT_EQ(progressLine("fit", 0, 0, 3.0, 80), "fit ...");
  EXPECT_EQ(progressLine("fit", 0, 0, 3.0, 2), "fi");
}

TEST(Progress, fitsAnyWidth) {
  for (int width = 0; width < 100; ++width)
    EXPECT_LE(static_cast<int>(progressLine("planning", 7, 60, 1.5, width).size()), width);
  EXPECT_NE(progressLine("planning", 1, 600, 1.0, 200).find("9:59 left"), std::string::npos);
}

TEST(Progress, isSilentWhereThereIsNoTerminal) {
  testing::internal::CaptureStderr();
  {
    Progress progress("planning", 3);
    for (std::size_t i = 0; i <= 3; ++i) progress.update(i);
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace tubeplan::app
