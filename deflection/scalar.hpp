// The scalar types of the model: doubles, and dual numbers that carry exact derivatives through the same code.
#pragma once

#include <Eigen/Dense>

#include "deflection/dual.hpp"

namespace tubeplan::deflection {

/// Number of derivatives carried in one pass; more variables need more passes.
inline constexpr int kDualSize = 8;
using Dual = DualNumber<kDualSize>;

template <class S>
using Vector3 = Eigen::Matrix<S, 3, 1>;
template <class S>
using Matrix3 = Eigen::Matrix<S, 3, 3>;

inline double valueOf(double x) { return x; }
inline double valueOf(const Dual& x) { return x.value(); }

/// Returns true if a number is zero and all its derivatives are zero.
inline bool isConstantZero(double x) { return x == 0; }
inline bool isConstantZero(const Dual& x) { return x.value() == 0 && x.derivatives() == Dual::Derivatives{}; }

template <class Derived>
auto valuesOf(const Eigen::MatrixBase<Derived>& m) {
  return m.unaryExpr([](const typename Derived::Scalar& x) { return valueOf(x); }).eval();
}

}  // namespace tubeplan::deflection
