#include "planner/scene/scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace tubeplan::planner {
namespace {

using Names = std::vector<std::string>;
using Problems = std::vector<SceneProblem>;

bool contains(const Names& names, const std::string& name) { return std::ranges::find(names, name) != names.end(); }

bool namesBody(const Names& allow, const Body& body) {
  return contains(allow, body.link) || contains(allow, bodyLabel(body));
}

std::set<std::string> armNames(const Scene& scene) {
  std::set<std::string> names;
  for (const Link& link : scene.links) names.insert(link.name);
  for (const Body& body : scene.bodies) names.insert(bodyLabel(body));
  return names;
}

std::string listed(const std::set<std::string>& names) { return fmt::format("one of: {}", fmt::join(names, ", ")); }

void findAllowProblems(const std::string& path, const Names& allow, const std::set<std::string>& known,
                       Problems& problems) {
  for (const std::string& name : allow)
    if (!known.contains(name)) problems.push_back({path + ": allow", name, listed(known)});
}

void findObstacleProblems(const Scene& scene, Problems& problems) {
  const std::set<std::string> arm_names = armNames(scene);
  std::set<std::string> seen;
  for (std::size_t i = 0; i < scene.obstacles.size(); ++i) {
    const Obstacle& obstacle = scene.obstacles[i];
    const std::string path = obstacle.name.empty() ? fmt::format("obstacle {}", i + 1) : "obstacle " + obstacle.name;
    if (obstacle.name.empty())
      problems.push_back({path + ": name", "nothing", "a name, which reports use"});
    else if (!seen.insert(obstacle.name).second)
      problems.push_back({path + ": name", "another obstacle has the same name"});
    if (!obstacle.shape) problems.push_back({path, "the obstacle has no shape"});
    findAllowProblems(path, obstacle.allow, arm_names, problems);
  }
}

void findBodyProblems(const Scene& scene, Problems& problems) {
  std::set<std::string> known = armNames(scene);
  for (const Obstacle& obstacle : scene.obstacles) known.insert(obstacle.name);
  for (const Body& body : scene.bodies) {
    const std::string path = "body " + bodyLabel(body);
    const bool on_row = body.frame_index >= 0 && body.frame_index < static_cast<int>(scene.links.size());
    if (!on_row || scene.links[body.frame_index].name != body.link)
      problems.push_back({path + ": link", body.link, "the name of a link of the arm"});
    if (!std::dynamic_pointer_cast<const Solid>(body.shape))
      problems.push_back({path, body.shape ? "a region cannot be part of the arm" : "the body has no shape"});
    findAllowProblems(path, body.allow, known, problems);
  }
}

}  // namespace

const std::string& bodyLabel(const Body& body) { return body.name.empty() ? body.link : body.name; }

bool mayTouch(const Obstacle& obstacle, const Body& body) {
  return namesBody(obstacle.allow, body) || contains(body.allow, obstacle.name);
}

bool mayTouch(const Body& a, const Body& b) { return namesBody(a.allow, b) || namesBody(b.allow, a); }

std::vector<SceneProblem> findSceneProblems(const Scene& scene) {
  Problems problems;
  if (!std::isfinite(scene.clearance) || scene.clearance < 0)
    problems.push_back({"clearance", fmt::format("{}", scene.clearance), "a length of zero or more"});
  findObstacleProblems(scene, problems);
  findBodyProblems(scene, problems);
  return problems;
}

bool areJudged(const Scene& scene, int a, int b) {
  const auto rowOf = [&](int body) { return scene.bodies[static_cast<std::size_t>(body)].frame_index; };
  const auto [inner, outer] = std::minmax({rowOf(a), rowOf(b)});
  const auto joints = std::count_if(scene.links.begin() + inner + 1, scene.links.begin() + outer + 1,
                                    [](const Link& link) { return link.moves; });
  const std::pair<int, int> pair = std::minmax(a, b);
  return joints > 1 && std::ranges::find(scene.inseparable, pair) == scene.inseparable.end();
}

}  // namespace tubeplan::planner
