// Dual numbers: a value with its derivatives with respect to N variables, carried through ordinary arithmetic
// (forward-mode automatic differentiation).
//
// Eigen's AutoDiffScalar is several times slower here, because the compiler does not unroll its small loops.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>

namespace tubeplan::deflection {

template <int N>
class DualNumber {
 public:
  using Derivatives = std::array<double, N>;

  DualNumber() : DualNumber(0.) {}
  DualNumber(double value) : value_(value), derivatives_{} {}  // NOLINT: a constant is a dual number

  [[nodiscard]] double value() const { return value_; }
  [[nodiscard]] const Derivatives& derivatives() const { return derivatives_; }
  [[nodiscard]] Derivatives& derivatives() { return derivatives_; }

  DualNumber& operator+=(const DualNumber& b) { return combine(value_ + b.value_, 1, b, 1); }
  DualNumber& operator-=(const DualNumber& b) { return combine(value_ - b.value_, 1, b, -1); }
  DualNumber& operator*=(const DualNumber& b) { return combine(value_ * b.value_, b.value_, b, value_); }
  DualNumber& operator/=(const DualNumber& b) {
    const double inverse = 1 / b.value_, quotient = value_ * inverse;
    return combine(quotient, inverse, b, -quotient * inverse);
  }
  DualNumber operator-() const { return scaled(-value_, -1); }

  friend DualNumber operator+(DualNumber a, const DualNumber& b) { return a += b; }
  friend DualNumber operator-(DualNumber a, const DualNumber& b) { return a -= b; }
  friend DualNumber operator*(DualNumber a, const DualNumber& b) { return a *= b; }
  friend DualNumber operator/(DualNumber a, const DualNumber& b) { return a /= b; }
  friend DualNumber operator*(const DualNumber& a, double b) { return a.scaled(a.value_ * b, b); }
  friend DualNumber operator*(double a, const DualNumber& b) { return b.scaled(a * b.value_, a); }
  friend DualNumber operator/(const DualNumber& a, double b) { return a.scaled(a.value_ / b, 1 / b); }

  // Comparisons ignore the derivatives, because they only choose a branch of the code.
  friend bool operator<(const DualNumber& a, const DualNumber& b) { return a.value_ < b.value_; }
  friend bool operator>(const DualNumber& a, const DualNumber& b) { return a.value_ > b.value_; }
  friend bool operator<=(const DualNumber& a, const DualNumber& b) { return a.value_ <= b.value_; }
  friend bool operator>=(const DualNumber& a, const DualNumber& b) { return a.value_ >= b.value_; }
  friend bool operator==(const DualNumber& a, const DualNumber& b) { return a.value_ == b.value_; }
  friend bool operator!=(const DualNumber& a, const DualNumber& b) { return a.value_ != b.value_; }

  friend DualNumber sqrt(const DualNumber& a) {
    const double root = std::sqrt(a.value_);
    return a.scaled(root, 0.5 / root);
  }
  friend DualNumber sin(const DualNumber& a) { return a.scaled(std::sin(a.value_), std::cos(a.value_)); }
  friend DualNumber cos(const DualNumber& a) { return a.scaled(std::cos(a.value_), -std::sin(a.value_)); }
  friend DualNumber abs(const DualNumber& a) { return a.value_ < 0 ? -a : a; }

 private:
  /// Returns a dual number with the given value and derivatives multiplied by `slope`: the chain rule for one argument.
  [[nodiscard]] DualNumber scaled(double value, double slope) const {
    DualNumber result(value);
    for (int k = 0; k < N; ++k) result.derivatives_[k] = slope * derivatives_[k];
    return result;
  }

  /// Sets the value to `value`, and the derivatives by the chain rule for two arguments: this number and `b`.
  DualNumber& combine(double value, double slope, const DualNumber& b, double slope_b) {
    value_ = value;
    for (int k = 0; k < N; ++k) derivatives_[k] = slope * derivatives_[k] + slope_b * b.derivatives_[k];
    return *this;
  }

  double value_;
  Derivatives derivatives_;
};

}  // namespace tubeplan::deflection

namespace Eigen {

template <int N>
struct NumTraits<tubeplan::deflection::DualNumber<N>> : NumTraits<double> {
  using Real = tubeplan::deflection::DualNumber<N>;
  using NonInteger = Real;
  using Nested = const Real&;
  using Literal = Real;
  enum { RequireInitialization = 1, ReadCost = 1 + N, AddCost = 1 + N, MulCost = 3 * N };
};

template <int N, class BinaryOp>
struct ScalarBinaryOpTraits<tubeplan::deflection::DualNumber<N>, double, BinaryOp> {
  using ReturnType = tubeplan::deflection::DualNumber<N>;
};
template <int N, class BinaryOp>
struct ScalarBinaryOpTraits<double, tubeplan::deflection::DualNumber<N>, BinaryOp> {
  using ReturnType = tubeplan::deflection::DualNumber<N>;
};

}  // namespace Eigen
