#include "deflection/inverse/loop_closure.hpp"

#include <Eigen/Geometry>
#include <cmath>

namespace tubeplan::deflection {

namespace {

using Eigen::Matrix3d, Eigen::Vector3d;
using Line = Eigen::Matrix<double, kLineSize, kLineSize>;
enum : int { kAxis = 0, kPlace = 3, kMoment = 6, kInverse = 9, kSquare = 12, kAlong = 13, kOne = 14 };

Matrix3d crossOf(const Vector3d& t) {
  Matrix3d m;
  m << 0, -t.z(), t.y(), t.z(), 0, -t.x(), -t.y(), t.x(), 0;
  return m;
}

/// Returns a matrix that rotates the four vector quantities and multiplies the three scalar quantities by `factor`.
Line turning(const Matrix3d& R, double factor) {
  Line m = Line::Zero();
  for (const int at : {kAxis, kPlace, kMoment, kInverse}) m.block<3, 3>(at, at) = R;
  m.diagonal().tail<3>().setConstant(factor);
  return m;
}

/// Return the linear and the quadratic part of the matrix of a translation by t.
Line linearInShift(const Vector3d& t) {
  Line m = Line::Zero();
  m.block<3, 1>(kPlace, kOne) = t;
  m.block<3, 3>(kMoment, kAxis) = crossOf(t);
  m.block<3, 3>(kInverse, kMoment) = -2 * crossOf(t);
  m.block<3, 1>(kInverse, kAlong) = -2 * t;
  m.block<1, 3>(kSquare, kPlace) = 2 * t.transpose();
  m.block<1, 3>(kAlong, kAxis) = t.transpose();
  return m;
}

Line quadraticInShift(const Vector3d& t) {
  Line m = Line::Zero();
  m.block<3, 3>(kInverse, kAxis) = t.squaredNorm() * Matrix3d::Identity() - 2 * t * t.transpose();
  m(kSquare, kOne) = t.squaredNorm();
  return m;
}

Line shift(const Vector3d& t) { return Line::Identity() + linearInShift(t) + quadraticInShift(t); }

JointTerms<kLineSize> termsOf(const Vector3d& point, const Vector3d& direction, bool slides, double sense) {
  if (slides) return {Line::Identity(), linearInShift(sense * direction), quadraticInShift(direction)};
  const Matrix3d along = direction * direction.transpose();
  const Line to = shift(point), from = shift(-point);
  return {to * turning(along, 1) * from, to * turning(Matrix3d::Identity() - along, 0) * from,
          to * turning(sense * crossOf(direction), 0) * from};
}

template <int Size>
Eigen::Matrix<double, Size, Size> ownPart(const Line& m) {
  if constexpr (Size == kLineSize) {
    return m;
  } else {
    constexpr std::array<int, kPlaceSize> own{kPlace, kPlace + 1, kPlace + 2, kSquare, kOne};
    return m(own, own);
  }
}

}  // namespace

Closure<kLineSize> lineClosure(const Vector3d& p, const Vector3d& l) {
  Closure<kLineSize> v;
  v << l, p, p.cross(l), p.squaredNorm() * l - 2 * p.dot(l) * p, p.squaredNorm(), p.dot(l), 1;
  return v;
}

Closure<kPlaceSize> placeClosure(const Vector3d& p) {
  Closure<kPlaceSize> v;
  v << p, p.squaredNorm(), 1;
  return v;
}

template <int Size>
JointClosure<Size> jointClosure(const AxesAtZero& axes, std::size_t k) {
  const auto forward = termsOf(axes.point[k], axes.direction[k], axes.slides[k], 1),
             backward = termsOf(axes.point[k], axes.direction[k], axes.slides[k], -1);
  JointClosure<Size> joint;
  joint.slides = axes.slides[k];
  for (std::size_t t = 0; t < 3; ++t) {
    joint.forward[t] = ownPart<Size>(forward[t]);
    joint.backward[t] = ownPart<Size>(backward[t]);
  }
  return joint;
}

template <int Size>
JointTerms<Size> byHalfTangent(const JointClosure<Size>& joint, double zero) {
  const auto& [constant, first, second] = joint.forward;
  if (joint.slides) return {constant + zero * first + zero * zero * second, first + 2 * zero * second, second};
  const double c = std::cos(zero), s = std::sin(zero);
  return {constant + c * first + s * second, 2 * (c * second - s * first), constant - c * first - s * second};
}

template JointClosure<kLineSize> jointClosure(const AxesAtZero&, std::size_t);
template JointClosure<kPlaceSize> jointClosure(const AxesAtZero&, std::size_t);
template JointTerms<kLineSize> byHalfTangent(const JointClosure<kLineSize>&, double);
template JointTerms<kPlaceSize> byHalfTangent(const JointClosure<kPlaceSize>&, double);

}  // namespace tubeplan::deflection
