#include "planner/visit_conditions.hpp"

#include <algorithm>
#include <set>

namespace tubeplan::planner {

double VisitConditions::dwellAt(int tube) const {
  const auto known = dwell_at.find(tube);
  return known == dwell_at.end() ? dwell : known->second;
}

std::vector<int> zonesOf(const std::vector<int>& tubes, const VisitConditions& conditions) {
  std::map<int, int> listed;
  for (std::size_t zone = 0; zone < conditions.zones.size(); ++zone)
    for (const int tube : conditions.zones[zone]) listed.emplace(tube, static_cast<int>(zone));
  std::vector<int> zones;
  for (const int tube : tubes) {
    const auto found = listed.find(tube);
    zones.push_back(found == listed.end() ? static_cast<int>(conditions.zones.size()) : found->second);
  }
  const std::set<int> present(zones.begin(), zones.end());
  for (int& zone : zones) zone = static_cast<int>(std::distance(present.begin(), present.find(zone)));
  return zones;
}

}  // namespace tubeplan::planner
