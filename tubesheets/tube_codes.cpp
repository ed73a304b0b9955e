#include "tubesheets/tube_codes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>

#include "tubesheets/text_table.hpp"

namespace tubeplan::tubesheets {
namespace {

// Common codes in eddy-current reports. They are not taken from a guideline, and a plant's own codes may differ. To
// support another code, add a row.
constexpr TubeCode kFieldCodes[] = {
    {"PLG", "plugged", CodeUse::kState, TubeState::kPlugged},
    {"STB", "stabilised", CodeUse::kState, TubeState::kStabilised},
    {"stabilized", "stabilised", CodeUse::kState, TubeState::kStabilised},
    {"SLV", "sleeved", CodeUse::kState, TubeState::kSleeved},
    {"TBP", "to be plugged", CodeUse::kState, TubeState::kToPlug},
    {"to be plugged", "to be plugged", CodeUse::kState, TubeState::kToPlug},
    {"OBS", "obstructed", CodeUse::kState, TubeState::kInaccessible},
    {"obstructed", "obstructed", CodeUse::kState, TubeState::kInaccessible},
    {"done", "done", CodeUse::kDone},
    {"complete", "done", CodeUse::kDone},
    {"completed", "done", CodeUse::kDone},
    {"planned", "planned"},
    {"to do", "to do"},
    {"RRT", "to be tested again"},
    {"retest", "to be tested again"},
    {"RST", "restricted: a smaller probe goes in"},
    {"RES", "restricted: a smaller probe goes in"},
    {"restricted", "restricted: a smaller probe goes in"},
    {"NDD", "no detectable degradation"},
    {"NDF", "no degradation found"},
    {"INF", "indication not found"},
    {"INR", "indication not reportable"},
    {"NTE", "no tube expansion"},
    {"NQI", "indication that cannot be sized"},
    {"DSI", "distorted indication at a support"},
    {"DTI", "distorted indication at the tube sheet"},
    {"SAI", "single axial indication"},
    {"MAI", "multiple axial indications"},
    {"SCI", "single circumferential indication"},
    {"MCI", "multiple circumferential indications"},
    {"SVI", "single volumetric indication"},
    {"WAR", "wear"},
    {"DNT", "dent"},
    {"DNG", "ding"},
    {"MBM", "manufacturing burnish mark"},
    {"PVN", "permeability variation"},
    {"PLP", "possible loose part"},
};

}  // namespace

const std::vector<TubeCode>& tubeCodes() {
  static const std::vector<TubeCode> codes = [] {
    std::vector<TubeCode> all;
    for (const TubeState state : tubeStates())
      all.push_back({tubeStateName(state), tubeStateWords(state), CodeUse::kState, state});
    all.insert(all.end(), std::begin(kFieldCodes), std::end(kFieldCodes));
    return all;
  }();
  return codes;
}

const TubeCode* findTubeCode(std::string_view name) {
  static const std::map<std::string, const TubeCode*> by_name = [] {
    std::map<std::string, const TubeCode*> all;
    for (const TubeCode& code : tubeCodes()) all.emplace(plainName(code.name), &code);
    return all;
  }();
  const auto found = by_name.find(plainName(name));
  return found == by_name.end() ? nullptr : found->second;
}

std::string tubeCodeNames() {
  std::vector<std::string_view> names;
  for (const TubeCode& code : tubeCodes())
    if (code.use == CodeUse::kState) names.push_back(code.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace tubeplan::tubesheets
