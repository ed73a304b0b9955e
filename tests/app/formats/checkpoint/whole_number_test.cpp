// Tests of whole numbers in stored files: those within the range of the type are read, all others are refused.
#include "app/formats/checkpoint/whole_number.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace tubeplan::app {
namespace {

using nlohmann::json;

TEST(WholeNumber, ReadsWhatTheTypeHolds) {
  EXPECT_EQ(wholeNumber<int>(json::parse("-2147483648")), std::numeric_limits<int>::min());
  EXPECT_EQ(wholeNumber<int>(json::parse("2147483647")), std::numeric_limits<int>::max());
  EXPECT_EQ(wholeNumber<std::uint64_t>(json::parse("18446744073709551615")), ~std::uint64_t{0});
  EXPECT_EQ(wholeNumbers<int>(json::parse("[1, -2, 3]")), (std::vector<int>{1, -2, 3}));
}

/// All other JSON values must be refused; the first one was found by fuzzing a campaign's tally.
TEST(WholeNumber, RefusesEverythingElse) {
  for (const char* text : {"6.74407e+19", "1e300", "2.5", "3.0", "true", "\"1\"", "null", "[1]", "-1"})
    EXPECT_THROW((void)wholeNumber<std::uint64_t>(json::parse(text)), json::type_error) << text;
  for (const char* text : {"2147483648", "-2147483649", "18446744073709551615"})
    EXPECT_THROW((void)wholeNumber<int>(json::parse(text)), json::type_error) << text;
}

}  // namespace
}  // namespace tubeplan::app
