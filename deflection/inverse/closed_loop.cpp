#include "deflection/inverse/closed_loop.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>
#include <cassert>
#include <cmath>
#include <complex>

namespace tubeplan::deflection {

namespace {

using Eigen::Dynamic, Eigen::Index, Eigen::Matrix, Eigen::Vector3d, Eigen::VectorXd;
constexpr double kMoved = 1e-4;  ///< perturbation of the axes [fraction of the reach, rad]

/// Returns the n-th number of a low-discrepancy sequence in (-1, 1).
double drawn(int n) { return 2 * std::fmod(0.5 + n * 0.6180339887498949, 1.) - 1; }

Vector3d drawnVector(int n) { return {drawn(3 * n + 1), drawn(3 * n + 2), drawn(3 * n + 3)}; }

/// Returns the chain with lengths in units of the reach and slightly perturbed axes.
AxesAtZero movedALittle(AxesAtZero axes, double reach) {
  for (std::size_t k = 0; k < axes.point.size(); ++k) {
    const int n = static_cast<int>(k);
    axes.point[k] = axes.point[k] / reach + kMoved * drawnVector(2 * n);
    axes.direction[k] = (axes.direction[k] + kMoved * drawnVector(2 * n + 1)).normalized();
  }
  axes.tip /= reach;
  return axes;
}

/// Matrices for both sizes of loop, without allocation. The solvers are compiled for this single type, because
/// instances for fixed sizes take ten times as long to compile.
using Matrices = Matrix<double, Dynamic, Dynamic, 0, 14, 12>;
using Companion = Matrix<double, Dynamic, Dynamic, 0, 24, 24>;

/// Returns the roots x at which the matrix polynomial a + b x + c x^2 is singular. The polynomial only has to be
/// regular at x = -1, because of the substitution x = (1 + y) / (1 - y).
std::vector<std::complex<double>> rootsOf(const std::array<Matrices, 3>& polynomial) {
  const auto& [a, b, c] = polynomial;
  const Index n = a.rows();
  const Eigen::PartialPivLU<Companion> lead(a - b + c);
  Companion companion = Companion::Zero(2 * n, 2 * n);
  companion.topRightCorner(n, n).setIdentity();
  companion.bottomLeftCorner(n, n) = -lead.solve(Companion(a + b + c));
  companion.bottomRightCorner(n, n) = -lead.solve(Companion(2 * (c - a)));
  if (!companion.allFinite()) return {};
  const Eigen::EigenSolver<Companion> eigen(companion, false);
  if (eigen.info() != Eigen::Success) return {};
  std::vector<std::complex<double>> roots;
  for (const std::complex<double>& y : eigen.eigenvalues()) roots.push_back((1. + y) / (1. - y));
  return roots;
}

/// Returns the null vector of a nearly singular matrix.
Matrix<double, Dynamic, 1, 0, 12, 1> nullVector(Matrices m) {
  const Index n = m.rows();
  m.rowwise().normalize();
  const Eigen::ColPivHouseholderQR<Matrices> qr(m);
  Matrix<double, Dynamic, 1, 0, 12, 1> v = Matrix<double, Dynamic, 1, 0, 12, 1>::Ones(n);
  const Matrices R = qr.matrixR();
  v.head(n - 1) = -R.topLeftCorner(n - 1, n - 1).triangularView<Eigen::Upper>().solve(R.col(n - 1).head(n - 1));
  return qr.colsPermutation() * v;
}

template <int Size>
Closure<Size> closureOf(const Vector3d& p, const Vector3d& l) {
  if constexpr (Size == kLineSize)
    return lineClosure(p, l);
  else
    return placeClosure(p);
}

}  // namespace

template <int Size>
struct ClosedLoop<Size>::Sides {
  Outer outer;
  /// Decomposition of the outer joints' terms, without the constant term and without the trivial equation of the
  /// quantity 1.
  Eigen::ColPivHouseholderQR<Matrices> outer_solver;
  std::array<Matrices, 3> polynomial;
};

template <int Size>
ClosureChain<Size> closureChain(const AxesAtZero& given, double reach) {
  const AxesAtZero axes = movedALittle(given, reach);
  ClosureChain<Size> chain{{}, closureOf<Size>(axes.tip, axes.tool_axis), reach};
  for (std::size_t k = 0; k < axes.point.size(); ++k) chain.joints.push_back(jointClosure<Size>(axes, k));
  return chain;
}

template <int Size>
ClosureChain<Size> withJointHeld(ClosureChain<Size> chain, std::size_t k, double reading) {
  const JointClosure<Size>& held = chain.joints[k];
  const double at = reading / chain.reach, first = held.slides ? at : std::cos(reading),
               second = held.slides ? at * at : std::sin(reading);
  const auto forward = (held.forward[0] + first * held.forward[1] + second * held.forward[2]).eval(),
             backward = (held.backward[0] + first * held.backward[1] + second * held.backward[2]).eval();
  if (k + 1 == chain.joints.size()) {
    chain.tool = (forward * chain.tool).eval();
  } else {
    for (auto& term : chain.joints[k + 1].forward) term = (forward * term).eval();
    for (auto& term : chain.joints[k + 1].backward) term = (term * backward).eval();
  }
  chain.joints.erase(chain.joints.begin() + static_cast<std::ptrdiff_t>(k));
  return chain;
}

template <int Size>
ClosedLoop<Size>::ClosedLoop(const ClosureChain<Size>& chain) : reach_(chain.reach) {
  assert(chain.joints.size() == kJoints);
  std::array<JointTerms<Size>, kJoints> terms;
  for (std::size_t k = 0; k < kJoints; ++k) {
    slides_[k] = chain.joints[k].slides;
    // The half-angle tangent is infinite half a turn away from this value. A quasi-random value makes a root there
    // unlikely.
    zero_[k] = slides_[k] ? 0.1 : 1 + 2 * drawn(static_cast<int>(k) + 40);
    if (k < kOuter)
      outer_[k] = chain.joints[k];
    else
      terms[k] = byHalfTangent(chain.joints[k], zero_[k]);
  }
  for (int a = 0; a < 3; ++a)
    for (int i = 0; i < kInnerTerms; ++i) {
      const auto &first = terms[kOuter][static_cast<std::size_t>(a)],
                 &last = terms[kJoints - 1][static_cast<std::size_t>(i % 3)];
      const int column = a * kInnerTerms + i;
      inner_weight_[column] = weightOf(slides_[kOuter])[a] * weightOf(slides_[kJoints - 1])[i % 3];
      if constexpr (kEliminated == 2) {
        inner_.col(column) = first * (terms[kOuter + 1][static_cast<std::size_t>(i / 3)] * (last * chain.tool));
        inner_weight_[column] *= weightOf(slides_[kOuter + 1])[i / 3];
      } else {
        inner_.col(column) = first * (last * chain.tool);
      }
    }
}

/// Returns the goal moved back by the outer joints, one column for each product of the joints' terms; column 0 belongs
/// to the constant term.
template <int Size>
auto ClosedLoop<Size>::outerSide(const Vector3d& p_B, const Vector3d& axis_B) const -> Outer {
  const Closure<Size> goal = closureOf<Size>(p_B / reach_, axis_B);
  Outer side;
  for (int a = 0; a < 3; ++a) {
    const Closure<Size> first = outer_[0].backward[static_cast<std::size_t>(a)] * goal;
    if constexpr (kOuter == 2)
      for (int b = 0; b < 3; ++b) side.col(3 * a + b) = outer_[1].backward[static_cast<std::size_t>(b)] * first;
    else
      side.col(a) = first;
  }
  return side;
}

/// Sets the readings of the joints next to the tool at a root x, from the null vector v there. The entries of v are
/// products of powers of the eliminated joints' unknowns; powers of the last joint's unknown are adjacent.
template <int Size>
void ClosedLoop<Size>::setInner(const Unknowns& v, double x, VectorXd& q) const {
  const auto set = [&](std::size_t joint, double numerator, double denominator) {
    q[static_cast<Eigen::Index>(joint)] =
        zero_[joint] + (slides_[joint] ? numerator / denominator : 2 * std::atan2(numerator, denominator));
  };
  // Sets a joint from the ratio of two successive powers of its unknown, `step` entries apart, at the pair with the
  // largest magnitude.
  const auto setRatio = [&](std::size_t joint, int step, int powers) {
    int best = 0;
    for (int i = 0; i + step < kUnknowns; ++i)
      if ((i / step) % powers != powers - 1 && std::hypot(v[i], v[i + step]) > std::hypot(v[best], v[best + step]))
        best = i;
    set(joint, v[best + step], v[best]);
  };
  set(kOuter, x, 1);
  setRatio(kJoints - 1, 1, kEliminated == 2 ? 3 : 4);
  if constexpr (kEliminated == 2) setRatio(kOuter + 1, 3, 4);
}

/// Returns the tool's side of the loop at readings q.
template <int Size>
Closure<Size> ClosedLoop<Size>::innerSide(const VectorXd& q) const {
  const auto termsOf = [&](std::size_t joint) -> Vector3d {
    const double off = q[static_cast<Eigen::Index>(joint)] - zero_[joint];
    if (slides_[joint]) return {1, off, off * off};
    const double c = std::cos(off / 2), s = std::sin(off / 2);
    return {c * c, c * s, s * s};
  };
  const Vector3d first = termsOf(kOuter), middle = termsOf(kOuter + kEliminated - 1), last = termsOf(kJoints - 1);
  Eigen::Matrix<double, 3 * kInnerTerms, 1> terms;
  for (int a = 0; a < 3; ++a)
    for (int i = 0; i < kInnerTerms; ++i)
      terms[a * kInnerTerms + i] = first[a] * last[i % 3] * (kEliminated == 2 ? middle[i / 3] : 1);
  return inner_ * terms;
}

template <int Size>
VectorXd ClosedLoop<Size>::readingsAt(const Sides& sides, double x) const {
  VectorXd q(kJoints);
  setInner(nullVector(sides.polynomial[0] + x * (sides.polynomial[1] + x * sides.polynomial[2])), x, q);
  // With the inner readings known, the equations are linear in the outer joints' terms other than the constant one.
  const Matrix<double, kOuterTerms - 1, 1> outer =
      sides.outer_solver.solve((innerSide(q) - sides.outer.col(0)).template head<Size - 1>());
  const auto set = [&](std::size_t joint, int first, int second) {
    q[static_cast<Eigen::Index>(joint)] = slides_[joint] ? outer[first] : std::atan2(outer[second], outer[first]);
  };
  constexpr int kStep = kOuter == 2 ? 3 : 1;  // index distance between terms of the first joint
  set(0, kStep - 1, 2 * kStep - 1);
  if constexpr (kOuter == 2) set(1, 0, 1);
  for (std::size_t joint = 0; joint < kJoints; ++joint)
    if (slides_[joint]) q[static_cast<Eigen::Index>(joint)] *= reach_;
  return q;
}

template <int Size>
void ClosedLoop<Size>::addRoots(const Vector3d& p_B, const Vector3d& axis_B, double most_imaginary,
                                std::vector<VectorXd>& roots) const {
  Sides sides;
  sides.outer = outerSide(p_B, axis_B);
  sides.outer_solver.setThreshold(1e-13);
  sides.outer_solver.compute(sides.outer.template topRightCorner<Size - 1, kOuterTerms - 1>());
  Matrix<double, Size - 1, 3 * kInnerTerms> equations =
      inner_.template topRows<Size - 1>() - sides.outer.col(0).template head<Size - 1>() * inner_weight_;
  equations.applyOnTheLeft(sides.outer_solver.householderQ().adjoint());
  const Eigen::Matrix<double, kEquations, 3 * kInnerTerms> inner_equations =
      equations.template bottomRows<kEquations>();
  for (int a = 0; a < 3; ++a) {
    auto& m = sides.polynomial[static_cast<std::size_t>(a)];
    m.setZero(kUnknowns, kUnknowns);
    // Number of columns by which the terms shift if the equations are multiplied by the eliminated joint's unknown.
    constexpr int kNext = kUnknowns - kInnerTerms;
    const auto terms = inner_equations.template middleCols<kInnerTerms>(a * kInnerTerms);
    m.template topLeftCorner<kEquations, kInnerTerms>() = terms;
    m.template block<kEquations, kInnerTerms>(kEquations, kNext) = terms;
  }
  for (const std::complex<double>& x : rootsOf(sides.polynomial)) {
    if (x.imag() < 0) continue;
    const double imaginary = slides_[kOuter] ? x.imag() : 2 * x.imag() / (1 + x.real() * x.real());
    if (!(imaginary <= most_imaginary)) continue;
    // If the perturbation of the axes has made two roots complex, the real roots of the unperturbed chain may lie on
    // either side.
    for (const double side : {-1., 1.}) {
      VectorXd q = readingsAt(sides, x.real() + side * x.imag());
      if (q.allFinite()) roots.push_back(std::move(q));
      if (x.imag() == 0) break;
    }
  }
}

template ClosureChain<kLineSize> closureChain(const AxesAtZero&, double);
template ClosureChain<kPlaceSize> closureChain(const AxesAtZero&, double);
template ClosureChain<kLineSize> withJointHeld(ClosureChain<kLineSize>, std::size_t, double);
template ClosureChain<kPlaceSize> withJointHeld(ClosureChain<kPlaceSize>, std::size_t, double);
template class ClosedLoop<kLineSize>;
template class ClosedLoop<kPlaceSize>;

}  // namespace tubeplan::deflection
