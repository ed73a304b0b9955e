// Simulated outages with a hidden change at a random visit: how soon `watch` raises an alarm, what it names, and how
// often it is wrong where nothing changes. One table for each kind of visit, one line for each change.
#include <fmt/format.h>
#include <oneapi/tbb/parallel_for.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "tests/calibration/watch/simulated_outage.hpp"

namespace {

using namespace tubeplan::calibration;

struct Trial {
  bool is_alarm = false, is_early = false;
  int delay = 0;
  bool is_named = false;        ///< the answers contain the true change
  bool has_course = false;      ///< with the true course
  bool is_only_answer = false;  ///< the true change is the only answer
  bool is_first = false;        ///< the true change is the most probable answer
  bool is_miscalled = false;    ///< the true change has another course in the answers
  int answers = 0;
  std::string first;
};

Trial trialOf(const HiddenChange& change, const VisitKind& kind, int visits, int judged_after, std::uint64_t seed) {
  SimulatedOutage outage(seed);
  const int since = visits / 5 + outage.random().index(visits / 2);
  WatchOptions options;
  options.judged_after = judged_after;
  options.finds_means = false;
  const Watch watch = outage.watch(outage.visits(kind, visits, since, outage.changed(change)), options);
  Trial trial;
  trial.is_alarm = watch.alarm.has_value();
  if (!trial.is_alarm) return trial;
  trial.is_early = watch.alarm->measurement < since;
  trial.delay = watch.alarm->measurement - since + 1;
  const auto& answers = watch.alarm->judgement.answers;
  trial.answers = static_cast<int>(answers.size());
  if (answers.empty()) return trial;
  const std::string at = change.at(outage.truth());
  const auto isTrue = [&](const ChangeAnswer& a) { return a.effect == change.effect && a.at == at; };
  const auto truth = std::ranges::find_if(answers, isTrue);
  trial.first = answers.front().effect + "@" + answers.front().at;
  trial.is_named = truth != answers.end();
  trial.has_course = trial.is_named && (change.is_ramp ? truth->may_be_ramp : truth->may_be_step);
  trial.is_miscalled = trial.is_named && !trial.has_course;
  trial.is_only_answer = trial.is_named && answers.size() == 1;
  trial.is_first = isTrue(answers.front());
  return trial;
}

/// Returns the value that a share of the values does not exceed; 0 if there are none.
int quantile(std::vector<int> values, double share) {
  if (values.empty()) return 0;
  std::ranges::sort(values);
  return values[static_cast<std::size_t>(share * (static_cast<double>(values.size()) - 1))];
}

void print(const HiddenChange& change, const std::vector<Trial>& trials, bool shows_first) {
  std::vector<int> delays, sizes;
  int alarms = 0, early = 0, named = 0, with_course = 0, alone = 0, first = 0, none = 0;
  std::map<std::string, int> firsts;
  for (const Trial& trial : trials) {
    alarms += trial.is_alarm;
    early += trial.is_early;
    if (!trial.is_alarm || trial.is_early) continue;
    delays.push_back(trial.delay);
    named += trial.is_named;
    with_course += trial.has_course;
    alone += trial.is_only_answer;
    first += trial.is_first;
    none += trial.answers == 0;
    if (trial.answers > 0) sizes.push_back(trial.answers);
    ++firsts[trial.first];
  }
  fmt::print("{:<40} {:>6} {:>5} {:>5} {:>5} {:>6} {:>6} {:>6} {:>6} {:>5} {:>5} {:>5}\n", change.words, alarms, early,
             quantile(delays, 0.5), quantile(delays, 0.9), named, with_course, alone, first, quantile(sizes, 0.5),
             quantile(sizes, 0.9), none);
  if (!shows_first) return;
  for (const auto& [name, count] : firsts) fmt::print("    {:>4} {}\n", count, name);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App cli("Alarms of watched outages with a hidden change");
  int outages = 200, visits = 200, judged_after = 30;
  std::uint64_t seed = 1;
  std::vector<std::string> kinds, changes;
  bool shows_first = false;
  cli.add_option("--outages", outages, "outages for each change");
  cli.add_option("--visits", visits, "visits in an outage");
  cli.add_option("--seed", seed, "seed of the first outage");
  cli.add_option("--judged-after", judged_after, "visits after an alarm that help to judge");
  cli.add_option("--kinds", kinds, "kinds of visits (all)");
  cli.add_option("--changes", changes, "beginnings of the changes' names (all)");
  cli.add_flag("--show-first", shows_first, "list the most probable answers");
  CLI11_PARSE(cli, argc, argv);
  const auto isSelected = [](const std::vector<std::string>& selected, std::string_view name) {
    return selected.empty() || std::ranges::any_of(selected, [&](const auto& a) { return name.starts_with(a); });
  };
  for (const VisitKind& kind : kVisitKinds) {
    if (std::ranges::find(kinds, kind.name) == kinds.end() && !kinds.empty()) continue;
    fmt::print(
        "{} outages of {} visits each: {}\n{:<40} {:>6} {:>5} {:>5} {:>5} {:>6} {:>6} {:>6} {:>6} {:>5} {:>5} {:>5}\n",
        outages, visits, kind.name, "change", "alarms", "early", "50%", "90%", "in set", "course", "alone", "first",
        "size", "90%", "none");
    for (const HiddenChange& change : hiddenChanges()) {
      if (!isSelected(changes, change.name)) continue;
      std::vector<Trial> trials(static_cast<std::size_t>(outages));
      oneapi::tbb::parallel_for(std::size_t{0}, trials.size(), [&](std::size_t k) {
        trials[k] = trialOf(change, kind, visits, judged_after, seed + k);
      });
      print(change, trials, shows_first);
    }
  }
}
