#include "planner/scene/shape.hpp"

#include "planner/scene/separation.hpp"

namespace tubeplan::planner {

Separation Solid::separationFrom(const Eigen::Isometry3d& X_FB, const Solid& body) const {
  return separation(X_FB, body, Eigen::Isometry3d::Identity(), *this);
}

Separation Solid::separationFrom(const Capsule& body_F) const { return separation(body_F, *this); }

}  // namespace tubeplan::planner
