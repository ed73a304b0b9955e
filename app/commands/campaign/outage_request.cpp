#include "app/commands/campaign/outage_request.hpp"

#include <fmt/format.h>

#include "app/commands/campaign/campaign_options.hpp"
#include "app/storage/input_error.hpp"
#include "app/storage/named_entry.hpp"

namespace tubeplan::app {

namespace {

/// Number of tubes spread over the sheet if the request names none, and limits of the visits of an outage.
constexpr VisitedHoles kOutageVisits{300, "--visits", 20, 2000};

void requireOneSetting(const CampaignRequest& request) {
  if (request.touches.size() != 1 || request.choices.size() != 1 || request.touch_sigmas.size() > 1)
    throw InputError::problem("--touches, --choice, --touch-sigma", "a campaign of outages has one setting",
                              "give one value for each, and start a campaign for every setting");
}

/// Returns the rows of the table of changes that may be hidden in this arm. Throws InputError for an unknown change.
std::vector<int> hideableChanges(const std::string& hide, const deflection::Arm& arm) {
  std::vector<int> changes;
  std::vector<std::string> names{"any"};
  const auto table = calibration::hiddenChanges();
  for (std::size_t k = 1; k < table.size(); ++k) {
    if (table[k].at(arm).empty()) continue;
    names.emplace_back(table[k].name);
    if (hide == "any" || hide == table[k].name) changes.push_back(static_cast<int>(k));
  }
  if (changes.empty()) throw unknownName("--hide", hide, names);
  return changes;
}

}  // namespace

OutageTask outageTask(const CampaignRequest& request) {
  requireOneSetting(request);
  requireFractionOfNothing(request);
  if (request.touch_every < 0 || request.touch_every == 1)
    throw InputError("--touch-every", std::to_string(request.touch_every), "2 or more visits, or 0 for no touch");
  CampaignRequest visits = request;
  visits.holes = request.visits;
  OutageTask task;
  task.centring = centringTask(visits, kOutageVisits);
  // Calibration and watch know the size of the unmodelled error, which is that of the cell by default.
  auto& centring = task.centring.options;
  if (!request.unmodelled) centring.spread.unmodelled_sigma = centring.additional.model_error;
  centring.additional.model_error = centring.spread.unmodelled_sigma;
  task.options.centring = centring;
  task.options.touch_every = request.touch_every;
  task.options.nothing = request.nothing;
  task.options.changes = hideableChanges(request.hide, task.centring.truth.arm);
  return task;
}

PlanKey outageKey(const OutageTask& task, const CampaignRequest& request) {
  PlanKey key = centringKey(task.centring, request);
  for (auto& [name, value] : key)
    if (name == "kind of campaign") value = "outage";
  std::string changes;
  for (const int change : task.options.changes)
    changes += fmt::format("{} ", calibration::hiddenChanges()[static_cast<std::size_t>(change)].name);
  key.emplace_back("visits between touches", std::to_string(task.options.touch_every));
  key.emplace_back("fraction without a change", fmt::format("{}", task.options.nothing));
  key.emplace_back("list of changes", changes);
  return key;
}

}  // namespace tubeplan::app
