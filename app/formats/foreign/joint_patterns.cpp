#include "app/formats/foreign/joint_patterns.hpp"

#include <algorithm>
#include <cctype>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "app/storage/lower_case.hpp"

namespace tubeplan::app {

namespace {

/// Words of a name, each of lower-case letters or of digits: left, arm, j, 1 for "left_arm/J1".
using NameWords = std::vector<std::string>;

const std::set<std::string> kJointWordsAnywhere{"joint",    "joints",    "axis", "axes",    "angle", "angles",
                                                "position", "positions", "pos",  "encoder", "theta", "jt"};
const std::set<std::string> kJointLetters{"j", "a", "q"};  // letters directly before a joint's number

/// Words in headings that denote quantities of a joint other than the joint's reading.
const std::set<std::string> kOtherQuantities{"velocity", "velocities", "vel",   "speed",  "acceleration", "acc",
                                             "effort",   "efforts",    "eff",   "torque", "torques",      "tau",
                                             "current",  "currents",   "force", "forces", "temperature",  "temp",
                                             "error",    "sigma",      "dir",   "near",   "limit",        "pwm"};

bool isLetter(char c) { return std::isalpha(static_cast<unsigned char>(c)) || static_cast<unsigned char>(c) > 127; }
bool isDigit(char c) { return c >= '0' && c <= '9'; }

NameWords wordsOf(const std::string& text) {
  NameWords words;
  char before = ' ';
  for (const char c : text) {
    const bool continues =
        (isLetter(c) && isLetter(before) &&
         !(std::isupper(static_cast<unsigned char>(c)) && std::islower(static_cast<unsigned char>(before)))) ||
        (isDigit(c) && isDigit(before));
    if (isLetter(c) || isDigit(c)) {
      if (!continues) words.emplace_back();
      words.back() += c;
    }
    before = c;
  }
  for (auto& word : words) word = lowerCase(word);
  return words;
}

/// Returns the words of a heading without the word that states its unit.
NameWords wordsOf(const std::string& column, const ForeignHeading& heading) {
  NameWords words = wordsOf(column);
  if (heading.unit && !words.empty() && isUnitWord(words.back())) words.pop_back();
  return words;
}

/// Returns the names without those first and last words that all of them have in common.
std::vector<NameWords> withoutShared(std::vector<NameWords> names) {
  const auto areAlike = [&](auto word) {
    return std::ranges::all_of(
        names, [&](const NameWords& name) { return name.size() > 1 && word(name) == word(names.front()); });
  };
  while (areAlike([](const NameWords& name) { return name.front(); }))
    for (auto& name : names) name.erase(name.begin());
  while (areAlike([](const NameWords& name) { return name.back(); }))
    for (auto& name : names) name.pop_back();
  return names;
}

bool isPlainNumber(const NameWords& words) { return words.size() == 1 && isDigit(words.front().front()); }

/// Returns the ways in which headings may name the joints, each as a list with one name for each joint.
std::vector<std::vector<NameWords>> waysToCall(const std::vector<const ColumnTarget*>& joints) {
  std::vector<NameWords> own, from_one, from_zero;
  for (std::size_t k = 0; k < joints.size(); ++k) {
    own.push_back(wordsOf(joints[k]->quantity));
    from_one.push_back({std::to_string(k + 1)});
    from_zero.push_back({std::to_string(k)});
  }
  std::vector<std::vector<NameWords>> ways{from_one, from_zero};
  for (const auto& names : {own, withoutShared(own)})
    if (!std::ranges::all_of(names, isPlainNumber)) ways.push_back(names);
  return ways;
}

/// Words before and after a joint's name or number in a heading.
struct Around {
  NameWords before, behind;
  auto operator<=>(const Around&) const = default;
};

std::vector<Around> aroundName(const NameWords& heading, const NameWords& name) {
  std::vector<Around> found;
  for (std::size_t at = 0; at + name.size() <= heading.size(); ++at)
    if (const auto from = heading.begin() + static_cast<std::ptrdiff_t>(at); std::equal(name.begin(), name.end(), from))
      found.push_back({NameWords(heading.begin(), from),
                       NameWords(from + static_cast<std::ptrdiff_t>(name.size()), heading.end())});
  return found;
}

/// Returns true if the words around a joint's name or number are compatible with a joint reading.
bool speaksOfJoints(const Around& around, bool is_number) {
  NameWords all = around.before;
  all.insert(all.end(), around.behind.begin(), around.behind.end());
  const auto isAmong = [&](const auto& set) {
    return std::ranges::any_of(all, [&](const auto& word) { return set.contains(word); });
  };
  if (isAmong(kOtherQuantities)) return false;
  const bool is_lettered = !around.before.empty() && kJointLetters.contains(around.before.back());
  return !is_number || is_lettered || isAmong(kJointWordsAnywhere);
}

}  // namespace

bool isNumbered(const ColumnTarget& target) { return target.is_joint && target.aliases.size() > 1; }

std::vector<JointColumns> jointPatterns(const std::vector<ForeignTable>& tables,
                                        const std::vector<std::vector<ForeignHeading>>& headings,
                                        const std::vector<ColumnTarget>& targets) {
  std::vector<const ColumnTarget*> joints;
  for (const auto& target : targets)
    if (isNumbered(target)) joints.push_back(&target);
  std::vector<JointColumns> found;
  for (std::size_t t = 0; t < tables.size(); ++t) {
    if (!tables[t].has_heading) continue;
    for (const auto& names : waysToCall(joints)) {
      std::map<Around, std::vector<std::vector<std::size_t>>> columns;  // columns of each joint by surrounding words
      for (std::size_t c = 0; c < headings[t].size(); ++c) {
        const NameWords words = wordsOf(tables[t].columns[c], headings[t][c]);
        for (std::size_t k = 0; k < joints.size(); ++k) {
          const auto& unit = headings[t][c].unit;
          if (unit && unit->kind != joints[k]->unit) continue;
          for (auto& around : aroundName(words, names[k])) {
            auto& of_joints = columns[std::move(around)];
            of_joints.resize(joints.size());
            of_joints[k].push_back(c);
          }
        }
      }
      for (const auto& [around, of_joints] : columns) {
        const bool are_whole =
            std::ranges::all_of(of_joints, [](const auto& of_joint) { return of_joint.size() == 1; });
        if (!are_whole || !speaksOfJoints(around, std::ranges::all_of(names, isPlainNumber))) continue;
        JointColumns set{t, {}};
        for (const auto& of_joint : of_joints) set.columns.push_back(of_joint.front());
        if (std::ranges::find(found, set) == found.end()) found.push_back(std::move(set));
      }
    }
  }
  return found;
}

}  // namespace tubeplan::app
