// Golden-section search for the minimum of a function of one variable on an interval.
#pragma once

namespace tubeplan::calibration {

/// Returns the argument between `a` and `b` that minimises `valueAt`, after the given number of golden-section steps.
template <class ValueAt>
double leastOf(const ValueAt& valueAt, double a, double b, int steps) {
  constexpr double kGolden = 0.6180339887498949;
  double c = b - kGolden * (b - a), d = a + kGolden * (b - a);
  double at_c = valueAt(c), at_d = valueAt(d);
  for (int k = 0; k < steps; ++k) {
    if (at_c < at_d)
      b = d, d = c, at_d = at_c, c = b - kGolden * (b - a), at_c = valueAt(c);
    else
      a = c, c = d, at_c = at_d, d = a + kGolden * (b - a), at_d = valueAt(d);
  }
  return (a + b) / 2;
}

}  // namespace tubeplan::calibration
