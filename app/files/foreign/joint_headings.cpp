#include "app/files/foreign/joint_headings.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "app/files/foreign/column_names.hpp"
#include "app/files/foreign/joint_patterns.hpp"

namespace tubeplan::app {

namespace {

/// Joints counted from zero are counted from one here: q0 to q5 of six, where there is no q6.
void countFromOne(std::vector<std::vector<ForeignHeading>>& tables, std::size_t joints) {
  const auto find = [&](const std::string& name) -> ForeignHeading* {
    for (auto& headings : tables)
      for (auto& heading : headings)
        if (heading.name == name) return &heading;
    return nullptr;
  };
  for (const char* word : kJointWords) {
    std::vector<ForeignHeading*> counted;
    for (std::size_t k = 0; k < joints; ++k) counted.push_back(find(fmt::format("{}{}", word, k)));
    const bool are_all = std::all_of(counted.begin(), counted.end(), [](const auto* heading) { return heading; });
    if (!are_all || find(fmt::format("{}{}", word, joints))) continue;
    for (std::size_t k = 0; k < joints; ++k) counted[k]->name = fmt::format("{}{}", word, k + 1);
  }
}

/// What controllers call all joints of an arm, from its base.
const std::vector<std::vector<std::string>> kControllersNames{
    {"s", "l", "u", "r", "b", "t"},
    {"s", "l", "e", "u", "r", "b", "t"},
    {"base", "shoulder", "elbow", "wrist1", "wrist2", "wrist3"},
};

/// Names of a controller, where one table has each of as many as there are joints: T is no time there.
void settleControllersNames(std::vector<std::vector<ForeignHeading>>& tables,
                            const std::vector<const ColumnTarget*>& joints) {
  for (auto& headings : tables)
    for (const auto& names : kControllersNames) {
      if (names.size() != joints.size()) continue;
      std::vector<ForeignHeading*> found;
      for (const auto& name : names)
        for (auto& heading : headings)
          if (heading.name == name) found.push_back(&heading);
      const bool are_all = found.size() == names.size() && std::ranges::all_of(names, [&](const auto& name) {
                             return std::ranges::any_of(found, [&](const auto* h) { return h->name == name; });
                           });
      if (!are_all) continue;
      for (std::size_t k = 0; k < joints.size(); ++k) found[k]->name = settledName(*joints[k]);
    }
}

/// A joint's own name goes before its number among the joints: `slide, A1, A2` are no numbers. The numbers of those
/// that are left count them alone where there are as many: `slide, J1, J2`.
void settleNames(std::vector<std::vector<ForeignHeading>>& tables, const std::vector<ColumnTarget>& targets) {
  const auto called = [&](const std::string& name) {
    std::vector<ForeignHeading*> found;
    for (auto& headings : tables)
      for (auto& heading : headings)
        if (heading.name == name) found.push_back(&heading);
    return found;
  };
  std::vector<const ColumnTarget*> rest;
  bool is_any_named = false;
  for (const auto& target : targets) {
    if (!target.is_joint) continue;
    const auto found = called(target.aliases.front());
    if (found.size() == 1 && fits(target, *found.front())) {
      found.front()->name = settledName(target);
      is_any_named = true;
    } else if (isNumbered(target)) {
      rest.push_back(&target);
    }
  }
  if (!is_any_named) settleControllersNames(tables, rest);
  for (const char* word : kJointWords) {
    const auto numbered = [&](std::size_t number) { return called(fmt::format("{}{}", word, number)); };
    bool are_all = is_any_named && !rest.empty() && numbered(rest.size() + 1).empty();
    for (std::size_t number = 1; number <= rest.size(); ++number) are_all = are_all && numbered(number).size() == 1;
    if (!are_all) continue;
    std::vector<ForeignHeading*> columns;
    for (std::size_t number = 1; number <= rest.size(); ++number) columns.push_back(numbered(number).front());
    for (std::size_t k = 0; k < rest.size(); ++k) columns[k]->name = settledName(*rest[k]);
    return;
  }
}

/// Joints between the same words, where no heading is a joint's without them and one set of columns stands for all.
void settlePattern(const std::vector<ForeignTable>& tables, std::vector<std::vector<ForeignHeading>>& headings,
                   const std::vector<ColumnTarget>& targets) {
  const auto isJoint = [&](const ForeignHeading& heading) {
    return std::ranges::any_of(targets,
                               [&](const auto& target) { return isNumbered(target) && fits(target, heading); });
  };
  for (const auto& of_table : headings)
    if (std::ranges::any_of(of_table, isJoint)) return;
  const auto patterns = jointPatterns(tables, headings, targets);
  if (patterns.size() != 1) return;
  std::size_t k = 0;
  for (const auto& target : targets)
    if (isNumbered(target)) headings[patterns.front().table][patterns.front().columns[k++]].name = settledName(target);
}

}  // namespace

std::string settledName(const ColumnTarget& target) { return "=" + target.quantity; }

void settleJoints(const std::vector<ForeignTable>& tables, std::vector<std::vector<ForeignHeading>>& headings,
                  const std::vector<ColumnTarget>& targets) {
  countFromOne(headings, static_cast<std::size_t>(std::ranges::count_if(targets, isNumbered)));
  settleNames(headings, targets);
  settlePattern(tables, headings, targets);
}

}  // namespace tubeplan::app
