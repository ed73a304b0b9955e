#include "deflection/effects/formula_sizes.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace tubeplan::deflection {

namespace {

constexpr int kSamples = 24;      // number of points at which a formula is evaluated
constexpr double kLinear = 1e-9;  // relative error up to which a formula is treated as linear

/// A fixed sequence of irregular numbers between -2 and 2, at which a nonlinear formula is unlikely to look linear.
class Spread {
 public:
  double next() {
    const double turn = ++count_ * 0.6180339887498949;
    return 4 * (turn - std::floor(turn)) - 2;
  }

 private:
  int count_ = 0;
};

/// Returns true if the expression is linear in the parameters that the bit mask selects, and vanishes if they are all
/// zero.
bool isLinear(const Formula& formula, unsigned mask) {
  Spread spread;
  int tried = 0;
  for (int n = 0; n < kSamples; ++n) {
    // The selected parameters are 0, u, v, u + v and -2 u at the five points; the other arguments are the same at all
    // of them.
    std::array<std::vector<double>, 5> at;
    // 1 to 1000, to cover the magnitudes of temperatures and moments as well as angles.
    const double scale = std::pow(10., n % 4);
    for (const Formula::Input& input : formula.inputs) {
      const double u = spread.next(), v = spread.next();
      const bool is_in = input.parameter >= 0 && (mask >> input.parameter & 1U) != 0;
      const double values[] = {0, u, v, u + v, -2 * u};
      const double other = input.parameter < 0 ? u * scale : u;
      for (std::size_t k = 0; k < at.size(); ++k) at[k].push_back(is_in ? values[k] : other);
    }
    std::array<double, 5> f{};
    for (std::size_t k = 0; k < at.size(); ++k) f[k] = formula.expression->value(at[k]);
    if (!std::all_of(f.begin(), f.end(), [](double x) { return std::isfinite(x); })) continue;
    const double allowed = kLinear * (std::abs(f[1]) + std::abs(f[2]) + std::abs(f[3]) + 1e-9);
    if (std::abs(f[0]) > allowed || std::abs(f[1] + f[2] - f[3]) > allowed || std::abs(f[4] + 2 * f[1]) > allowed)
      return false;
    ++tried;
  }
  return tried > 0;
}

}  // namespace

unsigned findSizes(const Formula& formula) {
  const unsigned all = 1U << formula.names.size();
  for (int count = static_cast<int>(formula.names.size()); count > 0; --count)
    for (unsigned mask = 1; mask < all; ++mask)
      if (std::popcount(mask) == count && isLinear(formula, mask)) return mask;
  return 0;
}

}  // namespace tubeplan::deflection
