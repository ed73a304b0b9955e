#include "app/formats/foreign/column_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

#include "app/formats/foreign/angle_fields.hpp"
#include "app/formats/foreign/foreign_heading.hpp"
#include "app/formats/foreign/joint_patterns.hpp"
#include "app/storage/input_error.hpp"
#include "tubesheets/csv_table.hpp"

namespace tubeplan::app {

namespace {

/// Returns the number of text columns before the first number, such as the collection, group and name of a tracker's
/// point.
std::size_t textsInFront(const ForeignTable& table) {
  const auto& first = table.rows.front().fields;
  const auto isNumber = [](const std::string& field) { return tubesheets::parseNumber(field).has_value(); };
  return static_cast<std::size_t>(std::find_if(first.begin(), first.end(), isNumber) - first.begin());
}

bool areDifferent(const ForeignTable& table, std::size_t column) {
  std::set<std::string> seen;
  return std::ranges::all_of(table.rows, [&](const auto& row) { return seen.insert(row.fields[column]).second; });
}

/// Returns true if a column may contain running numbers: integers that all differ.
bool areCounts(const ForeignTable& table, std::size_t column) {
  return areDifferent(table, column) && std::ranges::all_of(table.rows, [&](const auto& row) {
           return tubesheets::parseInteger(row.fields[column]).has_value();
         });
}

/// Returns the last of the `texts` text columns whose fields all differ, otherwise the last text column; std::nullopt
/// if there are no text columns.
std::optional<std::size_t> pointAmong(const ForeignTable& table, std::size_t texts) {
  for (std::size_t c = texts; c-- > 0;)
    if (areDifferent(table, c)) return c;
  return texts > 0 ? std::optional(texts - 1) : std::nullopt;
}

/// Returns headings for a table that has none, deduced from the number of columns. Text columns come first; the last of
/// them names the point. A running number may follow them before a position; it names the point if no text column
/// distinguishes the rows. The last columns are the joints, the position, or both.
std::vector<ForeignHeading> headingsByShape(const ForeignTable& table, const std::vector<ColumnTarget>& targets) {
  std::vector<std::string> joints;
  for (const auto& target : targets)
    if (target.is_joint) joints.push_back(target.aliases.front());
  const std::size_t texts = textsInFront(table), columns = table.columns.size();
  std::vector<ForeignHeading> headings(columns);
  const auto isWhole = [&](std::size_t numbers) {
    return numbers == joints.size() + 3 || (numbers == joints.size()) != (numbers == 3);
  };
  const auto point = pointAmong(table, texts);
  const bool is_named = point && areDifferent(table, *point);
  const std::size_t counted = columns - texts - 1;  // number of columns after the first numeric column
  const bool may_be_counted = !is_named && isWhole(counted) && counted != joints.size() && areCounts(table, texts);
  const bool is_counted = !isWhole(columns - texts);
  if (is_counted ? !may_be_counted : texts > 1 && may_be_counted) return headings;  // unknown or ambiguous columns
  if (is_counted)
    headings[texts].name = texts == 0 ? "id" : "point";
  else if (point)
    headings[*point].name = "point";
  std::size_t at = texts + (is_counted ? 1 : 0);
  const std::size_t numbers = columns - at;
  if (numbers != 3)
    for (const auto& joint : joints) headings[at++].name = joint;
  if (numbers != joints.size())
    for (const char* axis : {"x", "y", "z"}) headings[at++].name = axis;
  return headings;
}

/// Returns the internal name that a heading has once it is assigned to this target.
std::string settledName(const ColumnTarget& target) { return "=" + target.quantity; }

/// Renumbers joints from one if their headings are numbered from zero, such as q0 to q5 for six joints without a q6.
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

/// Names of an arm's joints in robot controllers, from the base outwards.
const std::vector<std::vector<std::string>> kControllersNames{
    {"s", "l", "u", "r", "b", "t"},
    {"s", "l", "e", "u", "r", "b", "t"},
    {"base", "shoulder", "elbow", "wrist1", "wrist2", "wrist3"},
};

/// Assigns a controller's joint names if one table has all of them, one for each joint; the heading T then means a
/// joint, not a time.
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

/// Assigns joints by their own names, which take precedence over numbers: `slide, A1, A2`. If there are as many numbers
/// as remaining joints, the numbers refer only to these: `slide, J1, J2`.
void settleNames(std::vector<std::vector<ForeignHeading>>& tables, const std::vector<ColumnTarget>& targets) {
  const auto called = [&](const std::string& name) {
    std::vector<ForeignHeading*> found;
    for (auto& headings : tables)
      for (auto& heading : headings)
        if (heading.name == name) found.push_back(&heading);
    return found;
  };
  std::vector<const ColumnTarget*> unnamed;
  bool is_any_named = false;
  for (const auto& target : targets) {
    if (!target.is_joint) continue;
    const auto found = called(target.aliases.front());
    if (found.size() == 1 && fits(target, *found.front())) {
      found.front()->name = settledName(target);
      is_any_named = true;
    } else if (isNumbered(target)) {
      unnamed.push_back(&target);
    }
  }
  if (!is_any_named) settleControllersNames(tables, unnamed);
  for (const char* word : kJointWords) {
    const auto numbered = [&](std::size_t number) { return called(fmt::format("{}{}", word, number)); };
    bool are_all = is_any_named && !unnamed.empty() && numbered(unnamed.size() + 1).empty();
    for (std::size_t number = 1; number <= unnamed.size(); ++number) are_all = are_all && numbered(number).size() == 1;
    if (!are_all) continue;
    std::vector<ForeignHeading*> columns;
    for (std::size_t number = 1; number <= unnamed.size(); ++number) columns.push_back(numbered(number).front());
    for (std::size_t k = 0; k < unnamed.size(); ++k) columns[k]->name = settledName(*unnamed[k]);
    return;
  }
}

/// Assigns joints whose headings share the words around the joint's name or number, unless a heading already names a
/// joint or several sets of columns are possible.
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

/// Assigns all joints. Numbers from zero first become numbers from one. Joints are then assigned by their own names, by
/// letters (S, L, U, R, B, T of Yaskawa) or, for the remaining joints, by numbers. If no heading names a joint,
/// jointPatterns() assigns all of them, provided that it finds only one set of columns.
void settleJoints(const std::vector<ForeignTable>& tables, std::vector<std::vector<ForeignHeading>>& headings,
                  const std::vector<ColumnTarget>& targets) {
  countFromOne(headings, static_cast<std::size_t>(std::ranges::count_if(targets, isNumbered)));
  settleNames(headings, targets);
  settlePattern(tables, headings, targets);
}

/// Renames the axes of surveyors (east, north, elevation) to x, y and z if one table has all three and no column is
/// named x, y or z.
void takeSurveyAxes(std::vector<std::vector<ForeignHeading>>& tables) {
  static const std::array<std::set<std::string>, 3> kNames{
      {{"east", "easting", "e"}, {"north", "northing", "n"}, {"elev", "elevation", "up", "height", "h"}}};
  static const std::array<std::string, 3> kAxes{"x", "y", "z"};
  for (const auto& headings : tables)
    for (const auto& heading : headings)
      if (std::ranges::find(kAxes, heading.name) != kAxes.end()) return;
  for (auto& headings : tables) {
    std::array<std::vector<ForeignHeading*>, 3> found;
    for (auto& heading : headings)
      for (std::size_t a = 0; a < 3; ++a)
        if (kNames[a].contains(heading.name)) found[a].push_back(&heading);
    if (std::ranges::any_of(found, [](const auto& columns) { return columns.size() != 1; })) continue;
    for (std::size_t a = 0; a < 3; ++a) found[a].front()->name = kAxes[a];
  }
}

}  // namespace

bool fits(const ColumnTarget& target, const ForeignHeading& heading) {
  if (heading.unit && !(target.unit && unitOfKind(heading.unit, *target.unit))) return false;
  if (heading.is_count && !target.is_joint) return false;
  return heading.name == settledName(target) ||
         std::find(target.aliases.begin(), target.aliases.end(), heading.name) != target.aliases.end();
}

const Unit* unitOf(const ForeignTable& table, const ForeignHeading& heading, UnitKind kind, const UsualUnits& usual) {
  if (heading.unit) return unitOfKind(heading.unit, kind);
  if (heading.is_count) return nullptr;
  const auto above = table.units.find(kind);
  const auto requested = usual.find(kind);
  if (above == table.units.end()) return requested == usual.end() ? nullptr : requested->second;
  if (requested != usual.end() && requested->second->name != above->second.unit->name)
    throw InputError::problem(
        table.file,
        fmt::format("the line {} states the unit {}, but --units says {}", inQuotes(above->second.line),
                    above->second.unit->name, requested->second->name),
        "leave that unit out of --units, or remove the line if it is wrong");
  return above->second.unit;
}

std::vector<ForeignHeading> columnNames(const ForeignTable& table, const std::vector<ColumnTarget>& targets) {
  if (!table.has_heading) return headingsByShape(table, targets);
  std::vector<ForeignHeading> headings;
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    headings.push_back(parseHeading(table.columns[c]));
    if (!headings.back().unit && !headings.back().is_count) headings.back().unit = unitOfForm(sixtiethForm(table, c));
  }
  return headings;
}

std::vector<std::vector<ForeignHeading>> columnNames(const std::vector<ForeignTable>& tables,
                                                     const std::vector<ColumnTarget>& targets) {
  std::vector<std::vector<ForeignHeading>> headings;
  for (const auto& table : tables) headings.push_back(columnNames(table, targets));
  settleJoints(tables, headings, targets);
  takeSurveyAxes(headings);
  return headings;
}

}  // namespace tubeplan::app
