#include "app/outage/leg_maps_json.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/outage/job_desk.hpp"
#include "app/outage/job_json.hpp"

namespace tubeplan::app {

namespace {

using nlohmann::json;

/// Letter of a standing in the map of a sheet, the most urgent standing first.
struct StandingLetter {
  ItemStanding standing;
  char letter;
};
constexpr StandingLetter kLetters[] = {{ItemStanding::kHeld, 'h'},
                                       {ItemStanding::kQueued, 'q'},
                                       {ItemStanding::kOpen, 'o'},
                                       {ItemStanding::kDone, 'd'},
                                       {ItemStanding::kExcluded, 'x'}};
constexpr char kNoItem = '.';

/// Returns the sheet of a leg as reports draw it, as sheetPageJson() does; without a cell, so that a record can be read
/// where its cells are not.
json sheetJson(JobStore& store, const JobSheet& sheet, const std::vector<TubeEnd>& ends) {
  const Units& units = store.job().units;
  const json drawing = json::parse(store.drawingOf({sheet.generator, sheet.leg.leg}));
  const auto side =
      tubesheets::findViewedFrom(drawing.value("viewed_from", "")).value_or(tubesheets::ViewedFrom::kBelow);
  json holes = json::array(), state_words;
  for (const TubeEnd& end : ends)
    holes.push_back({end.tube.row, end.tube.column, lengthOf(end.x, units), lengthOf(end.y, units), "open"});
  return {{"leg", tubesheets::legName(sheet.leg.leg)},
          {"leg_words", tubesheets::legWords(sheet.leg.leg)},
          {"viewed_from", tubesheets::viewedFromName(side)},
          {"view_words", tubesheets::viewedFromWords(side)},
          {"hole_diameter", lengthOf(drawing.value("hole_diameter_m", 0.), units)},
          {"pitch", lengthOf(sheet.pitch, units)},
          {"manway", drawing.value("manway", json())},
          {"holes", holes}};
}

/// Returns the letter of the most urgent standing among the items of one hole.
char letterOf(const std::vector<ItemStanding>& standings) {
  for (const StandingLetter& row : kLetters)
    if (std::ranges::find(standings, row.standing) != standings.end()) return row.letter;
  return kNoItem;
}

/// Returns the letters of all holes of a leg: of every package together, and of each package that the leg has.
json standingsJson(const std::vector<const JobItem*>& items, const std::vector<TubeEnd>& ends, const JobFile& job) {
  json list = json::array();
  std::vector<std::string> packages{""};
  for (const WorkPackage& package : job.packages) packages.push_back(package.name);
  for (const std::string& package : packages) {
    std::map<TubeAddress, std::vector<ItemStanding>> standings;
    for (const JobItem* item : items)
      if (package.empty() || item->package == package) standings[item->tube].push_back(item->standing());
    if (standings.empty()) continue;
    std::string letters;
    for (const TubeEnd& end : ends) letters += letterOf(standings[end.tube]);
    list.push_back({{"package", package}, {"of", letters}});
  }
  return list;
}

/// Estimates the time of a leg's remaining visits from the mean time of planned visits [s]; null if a package
/// with remaining visits has no plan.
json timeLeft(const json& plan, const LegName& leg, const std::vector<const JobItem*>& to_visit) {
  std::map<std::string, double> mean;
  if (plan.is_object())
    for (const json& planned : plan["legs"])
      for (const json& package : planned["packages"])
        if (planned["steam_generator"] == leg.generator && planned["leg"] == tubesheets::legName(leg.leg) &&
            package["visits"] > 0)
          mean[package["package"]] =
              (package["total_s"].get<double>() - package["change_s"].get<double>()) / package["visits"].get<double>();
  double sum = 0;
  for (const JobItem* item : to_visit) {
    const auto found = mean.find(item->package);
    if (found == mean.end()) return nullptr;
    sum += found->second;
  }
  return sum;
}

}  // namespace

json legMapsJson(JobStore& store, const json& plan) {
  json list = json::array();
  const std::vector<JobItem> items = store.items();
  for (const JobSheet& sheet : store.sheets()) {
    const LegName leg{sheet.generator, sheet.leg.leg};
    const JobPart part{"", sheet.generator, sheet.leg.leg};
    ItemCounts counts;
    std::vector<const JobItem*> of_leg;
    for (const JobItem& item : items)
      if (part.has(item)) {
        of_leg.push_back(&item);
        counts.add(item.standing());
      }
    if (of_leg.empty()) continue;
    const auto to_visit = itemsToVisit(items, part);
    const auto ends = store.endsOf(sheet.generator, sheet.leg.leg);
    json row = countsJson(counts);
    row["leg"] = addressText(leg);
    row["to_visit"] = to_visit.size();
    row["time_left_s"] = timeLeft(plan, leg, to_visit);
    row["sheet"] = sheetJson(store, sheet, ends);
    row["standings"] = standingsJson(of_leg, ends, store.job());
    list.push_back(std::move(row));
  }
  return list;
}

json standingLettersJson() {
  json letters = json::array();
  for (const StandingLetter& row : kLetters)
    letters.push_back({{"letter", std::string(1, row.letter)}, {"name", standingName(row.standing)}});
  return letters;
}

}  // namespace tubeplan::app
