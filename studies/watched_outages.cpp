// Simulated outages with a hidden change at a random visit: how soon `watch` raises an alarm, whether it tells a step
// of the base from another change, and how often it is wrong where nothing changes.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <functional>

#include "tests/calibration/watch/simulated_outage.hpp"

namespace {

using namespace tubeplan;
using namespace tubeplan::calibration;

/// Arm and base after a change.
struct Changed {
  deflection::Arm arm;
  Eigen::Isometry3d X_WB;
};

struct Change {
  const char* name;
  bool is_base;  ///< true if a step of the base explains it
  std::function<Changed(SimulatedOutage&)> make;
};

Changed withOffset(SimulatedOutage& outage, const char* row_name, double degrees) {
  Changed changed{outage.truth(), outage.base()};
  for (auto& row : changed.arm.rows)
    if (row.name == row_name) row.joint.offset += degrees * kDegree;
  return changed;
}

const std::vector<Change>& changes() {
  static const std::vector<Change> kChanges{
      {"none", false,
       [](SimulatedOutage& outage) {
         return Changed{outage.truth(), outage.base()};
       }},
      {"base shifted by 0.02 in", true,
       [](SimulatedOutage& outage) {
         Changed changed{outage.truth(), outage.base()};
         changed.X_WB.translation() += 0.02 * kInch * outage.random().vector(1).normalized();
         return changed;
       }},
      {"base turned by 0.03 deg about z", true,
       [](SimulatedOutage& outage) {
         Changed changed{outage.truth(), outage.base()};
         changed.X_WB.linear() = Eigen::AngleAxisd(0.03 * kDegree, Eigen::Vector3d::UnitZ()) * changed.X_WB.linear();
         return changed;
       }},
      {"forearm's joint slipped by 0.1 deg", false,
       [](SimulatedOutage& outage) { return withOffset(outage, "forearm", 0.1); }},
      {"tool's joint softer by 30 %", false,
       [](SimulatedOutage& outage) {
         Changed changed{outage.truth(), outage.base()};
         changed.arm.rows.back().joint_stiffness.z() *= 0.7;
         return changed;
       }},
  };
  return kChanges;
}

struct Tally {
  int outages = 0, alarms = 0, early = 0, as_base = 0, undecided = 0;
  std::vector<int> delays;
};

Tally tallyOf(const Change& change, int outages, int visits, std::uint64_t seed) {
  Tally tally;
  for (int k = 0; k < outages; ++k) {
    SimulatedOutage outage(seed + static_cast<std::uint64_t>(k));
    const int since = visits / 5 + outage.random().index(visits / 2);
    const Changed changed = change.make(outage);
    const Watch watch = outage.watch(outage.visits(visits, since, changed.arm, changed.X_WB));
    ++tally.outages;
    if (!watch.alarm) continue;
    ++tally.alarms;
    if (watch.alarm->measurement < since) {
      ++tally.early;
      continue;
    }
    tally.delays.push_back(watch.alarm->measurement - since + 1);
    tally.as_base += watch.alarm->kind == ChangeKind::kBaseStep;
    tally.undecided += watch.alarm->kind == ChangeKind::kUndecided;
  }
  return tally;
}

void print(const Change& change, Tally tally) {
  std::ranges::sort(tally.delays);
  const auto delay = [&](double share) {
    return tally.delays.empty()
               ? 0
               : tally.delays[static_cast<std::size_t>(share * (static_cast<double>(tally.delays.size()) - 1))];
  };
  fmt::print("{:<36} {:>7} {:>6} {:>9} {:>9} {:>7} {:>9}\n", change.name, tally.alarms, tally.early, delay(0.5),
             delay(0.9), tally.as_base, tally.undecided);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App cli("Alarms of watched outages with a hidden change");
  int outages = 200, visits = 200;
  std::uint64_t seed = 1;
  cli.add_option("--outages", outages, "outages for each change");
  cli.add_option("--visits", visits, "touches in an outage");
  cli.add_option("--seed", seed, "seed of the first outage");
  CLI11_PARSE(cli, argc, argv);
  fmt::print("{} outages of {} touches each\n{:<36} {:>7} {:>6} {:>9} {:>9} {:>7} {:>9}\n", outages, visits, "change",
             "alarms", "early", "delay 50%", "delay 90%", "as base", "undecided");
  for (const Change& change : changes()) print(change, tallyOf(change, outages, visits, seed));
}
