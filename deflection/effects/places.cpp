#include "deflection/effects/places.hpp"

namespace tubeplan::deflection {

namespace places {

namespace {

bool turns(const Row<double>& row) { return row.joint.type == JointType::kRevolute; }
bool hasJoint(const Row<double>& row) { return row.joint.type != JointType::kPassive; }

}  // namespace

std::vector<Place> ofRows(const Arm& arm, bool (*accepts)(const Arm&, int)) {
  std::vector<Place> out;
  for (int row = 0; row < static_cast<int>(arm.rows.size()); ++row)
    if (arm.rows[row].is_written && accepts(arm, row)) out.push_back({.row = row});
  return out;
}

std::vector<Place> ofRows(const Arm& arm) {
  return ofRows(arm, [](const Arm&, int) { return true; });
}

std::vector<Place> ofJoints(const Arm& arm) {
  return ofRows(arm, [](const Arm& a, int row) { return hasJoint(a.rows[row]); });
}

std::vector<Place> ofRevoluteJoints(const Arm& arm) {
  return ofRows(arm, [](const Arm& a, int row) { return turns(a.rows[row]); });
}

std::vector<Place> ofSlidesTurned(const Arm& arm) {
  std::vector<Place> out;
  for (const Place& to : ofJoints(arm))
    for (const Place& from : ofRevoluteJoints(arm))
      if (!turns(arm.rows[to.row])) out.push_back({.row = to.row, .other = from.row});
  return out;
}

std::vector<Place> ofJointPairs(const Arm& arm) {
  std::vector<Place> out;
  for (const Place& to : ofJoints(arm))
    for (const Place& from : ofJoints(arm))
      if (to.row != from.row && arm.rows[to.row].joint.type == arm.rows[from.row].joint.type)
        out.push_back({.row = to.row, .other = from.row});
  return out;
}

std::vector<Place> ofAxes(const Arm& arm, bool (*accepts)(const Arm&, int, int)) {
  std::vector<Place> out;
  for (const Place& place : ofRows(arm))
    for (int axis = 0; axis < 3; ++axis)
      if (accepts(arm, place.row, axis)) out.push_back({.row = place.row, .axis = axis});
  return out;
}

std::vector<Place> singlePlace(const Arm&) { return {Place{}}; }

}  // namespace places

std::string textOf(const Arm& arm, const EffectKind& kind, const Place& place) {
  switch (kind.at) {
    case PlaceRule::kJoint:
      return arm.rows.at(place.row).joint.name;
    case PlaceRule::kJointPair:
      return arm.rows.at(place.row).joint.name + "<-" + arm.rows.at(place.other).joint.name;
    case PlaceRule::kLink:
      return arm.rows.at(place.row).name;
    case PlaceRule::kRowAxis:
      return arm.rows.at(place.row).name + "." + "xyz"[place.axis];
    case PlaceRule::kSetup:
      return place.setup;
    case PlaceRule::kWord:
      return kind.word;
  }
  return "";
}

std::vector<std::string> placeTexts(const Arm& arm, const EffectKind& kind) {
  std::vector<std::string> out;
  for (const Place& place : kind.places(arm)) out.push_back(textOf(arm, kind, place));
  return out;
}

std::optional<Place> findPlace(const Arm& arm, const EffectKind& kind, std::string_view text) {
  if (kind.at == PlaceRule::kSetup)  // any name is valid: set-ups are defined by measurements, not by the arm
    return text.empty() ? std::nullopt : std::optional(Place{.setup = std::string(text)});
  for (const Place& place : kind.places(arm))
    if (textOf(arm, kind, place) == text) return place;
  return std::nullopt;
}

}  // namespace tubeplan::deflection
