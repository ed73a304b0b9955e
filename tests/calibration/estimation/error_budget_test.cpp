#include "calibration/estimation/error_budget.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "calibration/measurements/measurement_kinds.hpp"

namespace tubeplan::calibration {
namespace {

ErrorSize sizeWith(double rms) {
  ErrorSize size;
  size.rms = rms;
  size.measurements = 12;
  return size;
}

double signedSquare(double value) { return std::copysign(value * value, value); }

struct BudgetCase {
  const char* name;
  double before, after, floor;
  double explained, remainder, noise;
};

constexpr BudgetCase kBudgetCases[] = {
    {"explained down to the noise", 5, 3, 3, 4, 0, 3},
    {"explained in part", 13, 5, 3, 12, 4, 3},
    {"nothing explained", 5, 5, 3, 0, 4, 3},
    {"below the noise floor", 5, 3, 4, 4, 0, 3},
    {"worse than before", 3, 5, 3, -4, 4, 3},
    {"no noise is stated", 5, 4, std::numeric_limits<double>::quiet_NaN(), 3, 4, 0},
};

TEST(ErrorBudget, addsUpInSquares) {
  for (const BudgetCase& one : kBudgetCases) {
    SCOPED_TRACE(one.name);
    const ErrorBudget budget = errorBudget({sizeWith(one.before), sizeWith(one.after)}, {}, one.floor);
    EXPECT_TRUE(budget.is_held_out);
    EXPECT_EQ(budget.measurements, 12);
    EXPECT_EQ(budget.total, one.before);
    EXPECT_NEAR(budget.explained, one.explained, 1e-12);
    EXPECT_NEAR(budget.remainder, one.remainder, 1e-12);
    EXPECT_NEAR(budget.noise, one.noise, 1e-12);
    EXPECT_NEAR(signedSquare(budget.explained) + signedSquare(budget.remainder) + signedSquare(budget.noise),
                one.before * one.before, 1e-9);
  }
}

TEST(ErrorBudget, isOfTheFittedErrorsWhereNoneIsHeldOut) {
  const ErrorBudget budget = errorBudget({{}, sizeWith(2)}, {sizeWith(5), sizeWith(4)}, 1);
  EXPECT_FALSE(budget.is_held_out);
  EXPECT_EQ(budget.total, 5);
  EXPECT_TRUE(std::isnan(errorBudget({}, {}, 1).total));
}

TEST(ErrorBudget, isOfAnglesWhereEveryMeasurementMeasuresNothingElse) {
  EXPECT_FALSE(measureOnlyAngles({}));
  for (const MeasurementKindRow& row : measurementKinds()) {
    Measurement measurement;
    measurement.kind = row.kind;
    EXPECT_EQ(measureOnlyAngles({measurement}), row.turn_rows == row.rows) << row.name;
    Measurement place;
    place.kind = MeasurementKind::kPosition;
    EXPECT_FALSE(measureOnlyAngles({measurement, place})) << row.name;
  }
}

}  // namespace
}  // namespace tubeplan::calibration
