#include "deflection/equilibrium.hpp"

#include <algorithm>
#include <cmath>

namespace tubeplan::deflection {

using Eigen::Vector3d;

namespace {

struct SineAndCosine {
  double sine, cosine;
};

/// Returns sine and cosine of an angle; below 0.1 rad the series is exact to rounding, as in rotationFromVector().
SineAndCosine sineAndCosine(double angle) {
  const double t2 = angle * angle;
  if (t2 >= 0.01) return {std::sin(angle), std::cos(angle)};
  const double a = 1 - t2 * (1. / 6) * (1 - t2 * (1. / 20) * (1 - t2 * (1. / 42) * (1 - t2 * (1. / 72))));
  const double b = 0.5 - t2 * (1. / 24) * (1 - t2 * (1. / 30) * (1 - t2 * (1. / 56) * (1 - t2 * (1. / 90))));
  return {a * angle, 1 - b * t2};
}

}  // namespace

void Equilibrium::straighten() {
  for (FlexibleElement& element : elements) {
    element.deflection = {};
    element.gap.setZero();
    element.turn.setIdentity();
  }
  outboard_.resize(elements.size() * loads.size());
}

Loading<double> Equilibrium::loadingOf(std::size_t e) const {
  const FlexibleElement& element = elements[e];
  const OutboardLoad& gravity = outboard(e, 0);
  const Vector3d lever = element.turn * gravity.moment;
  Loading<double> loading{gravity.size * gravity.direction, lever.cross(gravity.direction),
                          element.weight * gravity.direction, element.chord()};
  for (std::size_t d = 1; d < loads.size(); ++d) {
    const OutboardLoad& other = outboard(e, d);
    if (loads[d].is_couple) {
      loading.moment += other.size * other.direction;
      continue;
    }
    const Vector3d arm = element.turn * other.moment;
    loading.force += other.size * other.direction;
    loading.moment += arm.cross(other.direction);
  }
  return loading;
}

clearance::GapPosition Equilibrium::gapPositionOf(std::size_t e, int axis, double moment) const {
  double moment_per_angle = 0, forces = 0;
  for (std::size_t d = 0; d < loads.size(); ++d) {
    if (loads[d].is_couple) continue;
    const OutboardLoad& load = outboard(e, d);
    const Vector3d lever = elements[e].turn * load.moment;
    // The moment about n of a force F at r changes by n . ((n x r) x F) per angle of rotation about n.
    moment_per_angle += load.direction[axis] * lever[axis] - load.direction.dot(lever);
    forces += std::abs(load.size) * load.direction.norm();
  }
  return clearance::converge(elements[e].gap_width[axis], elements[e].gap[axis], moment,
                             {moment_per_angle, forces * reach, clearances});
}

/// Bends an element that rotates about a single axis; bend() handles all other elements. Only components perpendicular
/// to the axis contribute to the moment about it. Returns an upper bound on the resulting motion of the tip [m].
double Equilibrium::turnHinge(std::size_t e) {
  FlexibleElement& element = elements[e];
  const int k = element.hinge, i = (k + 1) % 3, j = (k + 2) % 3;
  double moment = 0;
  for (std::size_t d = 0; d < loads.size(); ++d) {
    const OutboardLoad& load = outboard(e, d);
    if (loads[d].is_couple) {
      moment += load.size * load.direction[k];
      continue;
    }
    const double x = element.turn(i, i) * load.moment[i] + element.turn(i, j) * load.moment[j];
    const double y = element.turn(j, i) * load.moment[i] + element.turn(j, j) * load.moment[j];
    moment += x * load.direction[j] - y * load.direction[i];
  }
  double& angle = element.deflection.rotation[k];
  const double before = angle;
  angle = element.flexibility.compliance(k, k) * moment;
  const auto [sine, cosine] = sineAndCosine(angle);
  element.turn(i, i) = element.turn(j, j) = cosine;
  element.turn(i, j) = -sine;
  element.turn(j, i) = sine;
  return 2 * reach * std::abs(angle - before);
}

/// Bends an element; returns an upper bound on the resulting motion of the tip [m].
double Equilibrium::bend(std::size_t e, bool with_gaps) {
  FlexibleElement& element = elements[e];
  if (element.hinge >= 0) return turnHinge(e);
  const Loading<double> loading = loadingOf(e);
  const Deflection<double> before = element.deflection;
  element.deflection = element.kind->deflect(element.flexibility, loading);
  if (with_gaps)
    for (int axis = 0; axis < 3; ++axis)
      if (element.has_gap[axis]) element.gap[axis] = gapPositionOf(e, axis, loading.moment[axis]).angle;
  element.deflection.rotation += element.gap;
  element.turn = rotationFromVector<double>(element.deflection.rotation);
  return (element.deflection.displacement - before.displacement).lpNorm<1>() +
         2 * reach * (element.deflection.rotation - before.rotation).lpNorm<1>();
}

void Equilibrium::gatherInwards(bool bends) {
  for (std::size_t d = 0; d < loads.size(); ++d) {
    const DeadLoad& load = loads[d];
    double size = load.at_tip;
    Vector3d moment = load.tip_moment;
    for (std::size_t b = bodies.size(); b-- > 0;) {
      const RigidBody& body = bodies[b];
      if (!load.is_couple) moment = body.far.R * moment + size * body.far.p;
      if (d == 0) {
        moment += body.moment;
        size += body.weight;
      } else if (load.body == static_cast<int>(b)) {
        moment += load.place;
        size += 1;
      }
      if (b == 0) break;
      const std::size_t e = b - 1;
      outboard(e, d).size = size;
      outboard(e, d).moment = moment;
      if (bends && d + 1 == loads.size()) bend(e, false);
      const FlexibleElement& element = elements[e];
      if (load.is_couple) continue;
      moment = element.turn * moment + (d == 0 ? size + element.weight / 2 : size) * element.chord();
      if (d == 0) size += element.weight;
    }
  }
}

double Equilibrium::turnOutwards(bool bends) {
  double change = 0;
  for (std::size_t e = 0; e < elements.size(); ++e) {
    for (std::size_t d = 0; d < loads.size(); ++d) {
      const Vector3d& inboard = e == 0 ? loads[d].direction_B : outboard(e - 1, d).direction;
      const Vector3d far = e == 0 ? inboard : Vector3d(elements[e - 1].turn.transpose() * inboard);
      outboard(e, d).direction = bodies[e].far.R.transpose() * far;
    }
    if (bends) change += bend(e, true);
  }
  return change;
}

KinematicsStatus Equilibrium::converge(double tolerance, int max_iterations) {
  straighten();
  gatherInwards(false);
  for (iterations_ = 1; iterations_ <= max_iterations; ++iterations_) {
    const double change = turnOutwards(true);
    if (!std::isfinite(change)) return KinematicsStatus::kNotConverged;
    if (change <= tolerance) return KinematicsStatus::kConverged;
    gatherInwards(true);
  }
  return KinematicsStatus::kNotConverged;
}

void Equilibrium::carryLoads() {
  outboard_.resize(elements.size() * loads.size());
  gatherInwards(false);
  (void)turnOutwards(false);
}

PoseOf<double> Equilibrium::tip() const {
  PoseOf<double> X = bodies[0].far;
  for (std::size_t e = 0; e < elements.size(); ++e) {
    X.p += X.R * elements[e].chord();
    X.R = X.R * elements[e].turn;
    X = X * bodies[e + 1].far;
  }
  return X;
}

}  // namespace tubeplan::deflection
