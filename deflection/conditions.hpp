// Table of the conditions under which a measurement is taken, such as temperature and time. To add a condition, add a
// row: file readers and writers, simulation, formulas and diagnosis iterate over the table. Only the laws of effects
// refer to a particular condition.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "deflection/quantity.hpp"

namespace tubeplan::deflection {

/// Conditions, in the order of the table below.
enum class Condition { kTemperature, kTime };

/// Dependence of an unmodelled error on a condition.
enum class Course {
  kProportional,  ///< proportional to the condition's value
  kSlow,          ///< any slow change over the condition's range, such as a drift, a step or an oscillation
};

/// Range of a condition over which effects are plotted, relative to its usual value. If both ends are equal, no effect
/// is plotted.
struct ConditionSweep {
  double low = 0, high = 0;
  double otherwise = 0;  ///< value while another variable is swept, relative to the usual value
};

/// Slow variation of a simulated condition about its usual value. If both members are zero, the condition is not
/// simulated.
struct ConditionSwing {
  double amplitude = 0;
  double flutter = 0;  ///< standard deviation of the random part, drawn independently for each measurement
};

/// One row of the table. All values are in internal units.
struct ConditionKind {
  Condition condition;
  const char* name;   ///< key in JSON, symbol in formulas, and column name without the unit
  const char* words;  ///< noun in sentences such as "the error depends on time"
  ValueUnit unit = {};
  std::array<const char*, 2> aliases{};  ///< other column names, used in tables of other programs, in lower case
  double least = -std::numeric_limits<double>::infinity();
  const char* least_words = "";  ///< description of the smallest possible value
  double usual = 0;              ///< value assumed if none is stated
  bool is_of_drawing = false;    ///< true if an arm file may state the nominal value as reference_NAME
  Course course = Course::kProportional;
  bool moves_tool = true;  ///< true if an unmodelled error that depends on the condition may also lie in the tool
  ConditionSweep sweep = {};
  ConditionSwing swing = {};
  double change = 0;              ///< change of the condition that would help to distinguish causes; 0 if none
  const char* change_words = "";  ///< instruction to the user to make that change
};

inline constexpr std::array kConditionKinds{
    ConditionKind{.condition = Condition::kTemperature,
                  .name = "temperature",
                  .words = "the temperature",
                  .unit = {Quantity::kTemperature},
                  .aliases = {"temp"},
                  .least = 0,
                  .least_words = "absolute zero",
                  .usual = 293.15,
                  .is_of_drawing = true,
                  .sweep = {-20, 20, 10},
                  .swing = {6, 0.3},
                  .change = 10,
                  .change_words = "measure about 10 K warmer"},
    ConditionKind{.condition = Condition::kTime,
                  .name = "time",
                  .words = "time",
                  .unit = {Quantity::kTime},
                  .aliases = {"timestamp", "t"},
                  .course = Course::kSlow,
                  .moves_tool = false,
                  .sweep = {0, 4 * 3600, 3 * 3600}},
};

[[nodiscard]] constexpr const ConditionKind& kindOf(Condition condition) {
  return kConditionKinds[static_cast<std::size_t>(condition)];
}

static_assert([] {
  for (const ConditionKind& kind : kConditionKinds)
    if (&kindOf(kind.condition) != &kind) return false;
  return true;
}());

/// One value of type T for each condition, in the table's order.
template <class T>
struct OfEachCondition {
  std::array<T, kConditionKinds.size()> all{};

  [[nodiscard]] constexpr T& operator[](Condition condition) { return all[static_cast<std::size_t>(condition)]; }
  [[nodiscard]] constexpr const T& operator[](Condition condition) const {
    return all[static_cast<std::size_t>(condition)];
  }
};

/// One value of each condition, in internal units; NaN if not stated.
struct ConditionValues : OfEachCondition<double> {
  constexpr ConditionValues() { all.fill(std::numeric_limits<double>::quiet_NaN()); }

  [[nodiscard]] bool states(Condition condition) const { return std::isfinite((*this)[condition]); }
};

[[nodiscard]] constexpr ConditionValues usualConditions() {
  ConditionValues values;
  for (const ConditionKind& kind : kConditionKinds) values[kind.condition] = kind.usual;
  return values;
}

}  // namespace tubeplan::deflection
