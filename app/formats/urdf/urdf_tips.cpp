#include "app/formats/urdf/urdf_tips.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <ranges>
#include <span>
#include <tuple>

#include "app/storage/suggestion.hpp"

namespace tubeplan::app {

namespace {

using Link = UrdfTree::Link;

constexpr std::size_t kMostTried = 200;  // links tried as the tip; each is a reading of its chain

/// Link with the numbers of moving joints and of all joints between it and the root.
struct Behind {
  const Link* link;
  int moving, joints;
};

std::vector<Behind> linksBehindJoints(const UrdfTree& tree) {
  std::vector<Behind> links{{tree.root, 0, 0}};
  for (std::size_t k = 0; k < links.size(); ++k) {
    const Behind at = links[k];
    for (const Link* child : at.link->children)
      links.push_back({child, at.moving + (isMoving(*child->joint) ? 1 : 0), at.joints + 1});
  }
  std::erase_if(links, [](const Behind& at) { return at.moving == 0; });
  return links;
}

std::string wordsOf(const Behind& at) {
  return fmt::format("{} ({}behind {} moving joint{})", nameInLine(at.link->name),
                     at.link->children.empty() ? "an end, " : "", at.moving, at.moving == 1 ? "" : "s");
}

}  // namespace

UrdfChain chainTo(const UrdfTree& tree, const Link& tip, const std::string& file) {
  UrdfChain chain;
  for (const Link* link = &tip; link->joint; link = link->parent) {
    if (chain.size() == tree.links.size())
      throw InputError::problem(file, "the links on the way to " + inQuotes(tip.name) + " form a closed loop",
                                "arrange the links as a tree with one root");
    chain.push_back(link);
  }
  std::ranges::reverse(chain);
  return chain;
}

const Link& findTip(const UrdfTree& tree, const std::string& name, const std::string& file) {
  const auto depthOf = [&](const Link& link) {
    return std::ranges::count_if(chainTo(tree, link, file), [](const Link* at) { return isMoving(*at->joint); });
  };
  std::vector<std::string> names;
  for (const auto& [link_name, link] : tree.links) names.push_back(link_name);
  if (!name.empty()) {
    if (const auto link = tree.links.find(name); link != tree.links.end()) return link->second;
    throw TipError(InputError::problem(file, "the robot has no link " + inQuotes(name),
                                       suggestionOr(name, names, "select another link with --tip")));
  }
  UrdfChain deepest;
  for (const auto& [link_name, link] : tree.links) {
    if (!link.children.empty()) continue;
    const auto depth = depthOf(link), most = deepest.empty() ? -1 : depthOf(*deepest.front());
    if (depth > most) deepest.clear();
    if (depth >= most) deepest.push_back(&link);
  }
  if (deepest.size() == 1) return *deepest.front();
  std::vector<std::string> tips;
  for (const auto& link : deepest) tips.push_back(link->name);
  throw TipError(InputError::problem(file,
                                     fmt::format("{} links are each at the end of an equally long chain", tips.size()),
                                     "select one with --tip: " + alternatives(tips)));
}

InputChoice tipChoice(const UrdfTree& tree, const std::function<bool(const Link&)>& can_end) {
  std::vector<Behind> links = linksBehindJoints(tree);
  std::ranges::stable_sort(
      links, {}, [](const Behind& at) { return std::tuple(!at.link->children.empty(), -at.moving, -at.joints); });
  InputChoice choice{"tip", "link at the tip of the tool", {}};
  for (const Behind& at : std::span(links).first(std::min(links.size(), kMostTried)))
    if (can_end(*at.link)) choice.values.push_back({at.link->name, wordsOf(at)});
  return choice;
}

}  // namespace tubeplan::app
