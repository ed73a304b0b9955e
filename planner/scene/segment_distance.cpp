#include "planner/scene/segment_distance.hpp"

#include <algorithm>
#include <cmath>

namespace tubeplan::planner {
namespace {

using Eigen::Vector3d;

constexpr double kFinestStep = 1e-15;  // smallest Newton step, as a fraction of the segment's length
constexpr int kMostSteps = 100;

/// Half the slope of the squared distance along the segment, and its derivative.
struct Slope {
  double slope, curvature;
};

/// Returns the position along the segment, from 0 to 1, where the slope is zero; an end if the slope has one sign
/// throughout.
template <class SlopeAt>
double levelPlace(const SlopeAt& slope_at) {
  const Slope start = slope_at(0.0), end = slope_at(1.0);
  if (start.slope >= 0) return 0;
  if (end.slope <= 0) return 1;
  double low = 0, high = 1, s = start.slope / (start.slope - end.slope);
  for (int step = 0; step < kMostSteps; ++step) {
    const Slope current = slope_at(s);
    if (current.slope == 0) return s;
    (current.slope < 0 ? low : high) = s;
    double next = s - current.slope / current.curvature;
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    if (std::abs(next - s) <= kFinestStep) return next;
    s = next;
  }
  return s;
}

}  // namespace

SegmentNearest nearestToBox(const Vector3d& from, const Vector3d& to, const Vector3d& half) {
  const Vector3d along = to - from;
  const auto slopeAt = [&](double s) {
    Slope sum{0, 0};
    for (int k = 0; k < 3; ++k) {
      const double p = from[k] + s * along[k], beyond = std::abs(p) - half[k];
      if (beyond <= 0) continue;
      sum.slope += along[k] * std::copysign(beyond, p);
      sum.curvature += along[k] * along[k];
    }
    return sum;
  };
  const Vector3d nearest = from + levelPlace(slopeAt) * along;
  return {nearest, nearest.cwiseMin(half).cwiseMax(-half)};
}

SegmentNearest nearestToCylinder(const Vector3d& from, const Vector3d& to, double radius, double half_length) {
  const Vector3d along = to - from;
  const double across = along.head<2>().squaredNorm();
  const auto slopeAt = [&](double s) {
    Slope sum{0, 0};
    const Vector3d p = from + s * along;
    const double beyond_end = std::abs(p.z()) - half_length, r = p.head<2>().norm();
    if (beyond_end > 0) {
      sum.slope += along.z() * std::copysign(beyond_end, p.z());
      sum.curvature += along.z() * along.z();
    }
    if (r > radius) {
      const double outwards = along.head<2>().dot(p.head<2>()) / r;
      sum.slope += outwards * (r - radius);
      sum.curvature += across - radius / r * (across - outwards * outwards);
    }
    return sum;
  };
  const Vector3d nearest = from + levelPlace(slopeAt) * along;
  const double r = nearest.head<2>().norm();
  Vector3d on_solid = nearest;
  if (r > radius) on_solid.head<2>() *= radius / r;
  on_solid.z() = std::clamp(nearest.z(), -half_length, half_length);
  return {nearest, on_solid};
}

}  // namespace tubeplan::planner
