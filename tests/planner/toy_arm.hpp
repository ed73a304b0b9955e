// Planar arm of capsules in the xy plane with its base at the origin, for simple collision tests.
#pragma once

#include <random>
#include <vector>

#include "planner/motion/motion_planner.hpp"
#include "tests/planner/collision_world.hpp"
#include "tests/planner/random_draws.hpp"

namespace tubeplan::planner::testing {

inline ShapePointer shape(const char* key, std::vector<double> numbers) {
  return makeShape(*findSceneShape(key), numbers).shape;
}

inline const Solid& solid(const ShapePointer& pointer) { return dynamic_cast<const Solid&>(*pointer); }

inline Eigen::Vector3d uniformVector(std::mt19937_64& generator, double low, double high) {
  const double x = uniform(generator, low, high), y = uniform(generator, low, high);
  return {x, y, uniform(generator, low, high)};
}

inline Eigen::Isometry3d uniformPose(std::mt19937_64& generator, double extent) {
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  X.translation() = uniformVector(generator, -extent, extent);
  Eigen::Vector4d q;
  do q << uniformVector(generator, -1, 1), uniform(generator, -1, 1);
  while (q.norm() > 1 || q.norm() < 0.1);
  X.linear() = Eigen::Quaterniond(q).normalized().toRotationMatrix();
  return X;
}

struct ToyArm {
  std::vector<double> lengths;
  double radius = 0.02;
  double clearance = 0;

  Scene scene(std::vector<Obstacle> obstacles) const {
    Scene scene;
    scene.clearance = clearance;
    scene.obstacles = std::move(obstacles);
    for (int i = 0; i < static_cast<int>(lengths.size()); ++i) {
      scene.links.push_back({"link" + std::to_string(i + 1), true});
      scene.bodies.push_back(
          {scene.links.back().name, i, "", shape("capsule", {0, 0, 0, lengths[i], 0, 0, radius}), {}});
    }
    return scene;
  }

  std::vector<Eigen::Isometry3d> frames(const Eigen::VectorXd& q) const {
    std::vector<Eigen::Isometry3d> X_WL;
    Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
    for (std::size_t i = 0; i < lengths.size(); ++i) {
      X.rotate(Eigen::AngleAxisd(q[i], Eigen::Vector3d::UnitZ()));
      X_WL.push_back(X);
      X.translate(Eigen::Vector3d(lengths[i], 0, 0));
    }
    return X_WL;
  }

  TravelBound travel(const CollisionWorld& world) const {
    const std::vector<double> body_reach = bodyReachOf(world.scene());
    std::vector<LinkReach> reach;
    for (std::size_t i = 0; i < lengths.size(); ++i)
      reach.push_back({lengths[i], body_reach[i], LinkReach::Joint::kRevolute});
    return travelBoundOf(reach, 1.0);
  }

  PostureClearance clearanceOf(const CollisionWorld& world) const {
    return [this, &world](const Eigen::VectorXd& q) { return world.closest(frames(q)); };
  }

  MotionProblem problem(const CollisionWorld& world, double limit = 3.0) const {
    const auto joints = static_cast<Eigen::Index>(lengths.size());
    return {Eigen::VectorXd::Constant(joints, -limit),
            Eigen::VectorXd::Constant(joints, limit),
            clearanceOf(world),
            travel(world),
            {},
            {}};
  }
};

inline const ToyArm kTwoJoints{{0.6, 0.5}, 0.02, 0.01};
inline const ToyArm kFourJoints{{0.4, 0.35, 0.3, 0.25}, 0.02, 0.01};

/// Returns the smallest margin [m] over evenly spaced postures of a straight motion, including both ends.
inline double leastSampled(const Eigen::VectorXd& q0, const Eigen::VectorXd& q1, const PostureClearance& clearance_of,
                           int samples) {
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= samples; ++i) least = std::min(least, clearance_of(q0 + double(i) / samples * (q1 - q0)).margin);
  return least;
}

}  // namespace tubeplan::planner::testing
