#include "app/formats/checkpoint/plan_cache_text.hpp"

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>
#include <utility>

#include "app/formats/checkpoint/plan_cache_json.hpp"

namespace tubeplan::app {

namespace {

using nlohmann::json;
using planner::MotionEnds, planner::TubePosture;

[[noreturn]] void refuse(const char* what) { throw json::other_error::create(501, what, nullptr); }

/// Returns the index after the string that begins at `at`.
std::size_t endOfString(std::string_view text, std::size_t at) {
  for (++at; at < text.size(); ++at) {
    if (text[at] == '\\')
      ++at;
    else if (text[at] == '"')
      return at + 1;
  }
  refuse("a string without an end");
}

/// Returns the index after the value that begins at `at`.
std::size_t endOfValue(std::string_view text, std::size_t at) {
  int depth = 0;
  while (at < text.size()) {
    switch (text[at]) {
      case '"':
        at = endOfString(text, at);
        break;
      case '[':
      case '{':
        ++depth, ++at;
        break;
      case ']':
      case '}':
        if (depth == 0) return at;
        --depth, ++at;
        break;
      case ',':
        if (depth == 0) return at;
        [[fallthrough]];
      default:
        ++at;
        continue;
    }
    if (depth == 0) return at;
  }
  return at;
}

/// Calls `take` with each member of the list or object, which is written without spaces.
template <class Take>
void forEachMember(std::string_view text, char open, char close, const Take& take) {
  if (text.size() < 2 || text.front() != open || text.back() != close) refuse("no list or object of the kind written");
  for (std::size_t at = 1; at + 1 < text.size();) {
    const std::size_t begin = at;
    if (open == '{') {
      if (text[at] != '"') refuse("an object without keys");
      at = endOfString(text, at);
      if (at >= text.size() || text[at] != ':') refuse("a key without a value");
      ++at;
    }
    const std::size_t end = endOfValue(text, at);
    if (end == at || end >= text.size()) refuse("a value without an end");
    take(text.substr(begin, end - begin));
    at = end;
    if (text[at] == ',')
      ++at;
    else if (at + 1 != text.size())
      refuse("members without a comma between them");
  }
}

/// Reads a whole number at `at` and returns the index after it.
std::size_t readNumber(std::string_view text, std::size_t at, int& number) {
  const auto [end, error] = std::from_chars(text.data() + std::min(at, text.size()), text.data() + text.size(), number);
  if (error != std::errc{}) refuse("no whole number");
  return static_cast<std::size_t>(end - text.data());
}

int tubeInEntry(std::string_view entry) {
  constexpr std::string_view kKey = "\"tube\":";
  const std::size_t at = entry.rfind(kKey);
  int tube = 0;
  if (at == std::string_view::npos) refuse("reach without a tube");
  (void)readNumber(entry, at + kKey.size(), tube);
  return tube;
}

MotionEnds endsOf(std::string_view entry) {
  constexpr std::string_view kKey = "\"ends\":[";
  std::size_t at = entry.find(kKey);
  if (at == std::string_view::npos) refuse("a motion without ends");
  at += kKey.size();
  std::array<int, 4> numbers{};
  for (int& number : numbers) at = readNumber(entry, at, number) + 1;
  return {{numbers[0], numbers[1]}, {numbers[2], numbers[3]}};
}

template <class Key, class KeyOf>
std::map<Key, std::string> entriesOf(std::string_view list, const KeyOf& key_of) {
  std::map<Key, std::string> entries;
  forEachMember(list, '[', ']',
                [&](std::string_view entry) { entries.emplace_hint(entries.end(), key_of(entry), entry); });
  return entries;
}

bool meetsAnEnd(const MotionEnds& ends) { return ends.first.tube < 0 || ends.second.tube < 0; }

/// Appends `"key":[...]` with the entries of both maps, those of `known` by `text_of`, in the order of their keys.
template <class Key, class Value, class TextOf>
void appendList(const char* key, const std::map<Key, std::string>& texts, const std::map<Key, Value>& known,
                const TextOf& text_of, std::string& out) {
  out += std::string("\"") + key + "\":[";
  const std::size_t begin = out.size();
  const auto append = [&](std::string_view entry) {
    if (out.size() > begin) out += ',';
    out += entry;
  };
  auto text = texts.begin();
  for (const auto& [at, value] : known) {
    for (; text != texts.end() && text->first < at; ++text) append(text->second);
    if (text == texts.end() || at < text->first)
      append(text_of(at, value));
    else
      append((text++)->second);
  }
  for (; text != texts.end(); ++text) append(text->second);
  out += ']';
}

}  // namespace

PlanCacheText::PlanCacheText(const std::string& text) {
  json other_members = json::object();
  forEachMember(text, '{', '}', [&](std::string_view member) {
    const std::size_t colon = endOfString(member, 0);
    const std::string_view key = member.substr(1, colon - 2), value = member.substr(colon + 1);
    if (key == "reach")
      reach_ = entriesOf<int>(value, tubeInEntry);
    else if (key == "travels")
      travels_ = entriesOf<MotionEnds>(value, endsOf);
    else if (key == "proofs")
      proofs_ = entriesOf<MotionEnds>(value, endsOf);
    else
      other_members[std::string(key)] = json::parse(value);
  });
  other_members_ = other_members.dump();
}

planner::PlanCache PlanCacheText::read(const std::set<int>& tubes) const {
  const auto isSelected = [&](const MotionEnds& ends) {
    return (ends.first.tube < 0 || tubes.contains(ends.first.tube)) &&
           (ends.second.tube < 0 || tubes.contains(ends.second.tube));
  };
  planner::PlanCache cache = wholePlanFrom(json::parse(other_members_));
  for (const auto& [tube, text] : reach_)
    if (tubes.contains(tube)) cache.reach[tube] = reachFrom(json::parse(text));
  for (const auto& [ends, text] : travels_)
    if (isSelected(ends)) cache.travels[ends] = travelFrom(json::parse(text));
  for (const auto& [ends, text] : proofs_)
    if (isSelected(ends)) cache.proofs[ends] = proofFrom(json::parse(text));
  return cache;
}

planner::PlanCache PlanCacheText::readAll() const {
  std::set<int> tubes;
  for (const auto& [tube, text] : reach_) tubes.insert(tube);
  return read(tubes);
}

std::vector<int> PlanCacheText::visitingOrder() const {
  return wholePlanFrom(json::parse(other_members_)).visiting_order;
}

void PlanCacheText::dropEnds() {
  std::erase_if(travels_, [](const auto& entry) { return meetsAnEnd(entry.first); });
  std::erase_if(proofs_, [](const auto& entry) { return meetsAnEnd(entry.first); });
}

std::string PlanCacheText::with(const planner::PlanCache& cache) const {
  const json plan_json = wholePlanJson(cache);
  std::string out = "{\"bound\":" + plan_json["bound"].dump() + ",\"orders\":" + plan_json["orders"].dump() + ",";
  appendList(
      "proofs", proofs_, cache.proofs,
      [](const MotionEnds& ends, const planner::SegmentProof& proof) { return proofJson(ends, proof).dump(); }, out);
  out += ',';
  appendList(
      "reach", reach_, cache.reach, [](int, const planner::TubeReach& reach) { return reachJson(reach).dump(); }, out);
  out += ',';
  appendList(
      "travels", travels_, cache.travels,
      [](const MotionEnds& ends, const planner::MotionPlan& plan) { return travelJson(ends, plan).dump(); }, out);
  return out + ",\"visiting_branches\":" + plan_json["visiting_branches"].dump() +
         ",\"visiting_order\":" + plan_json["visiting_order"].dump() + "}";
}

}  // namespace tubeplan::app
