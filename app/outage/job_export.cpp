#include "app/outage/job_export.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <map>

#include "app/storage/input_error.hpp"
#include "tubesheets/csv_table.hpp"
#include "tubesheets/table_text.hpp"
#include "tubesheets/work_list.hpp"

namespace tubeplan::app {

namespace {

using tubesheets::ColumnText, tubesheets::csvField;

/// Fields that an export adds to an item, in the order of kNames.
struct ItemFields {
  static constexpr std::array<const char*, 5> kNames{"standing", "mark", "marked_by", "marked_at", "visit"};
  std::array<std::string, kNames.size()> fields;
};

ItemFields fieldsOf(JobStore& store, const JobItem& item) {
  ItemFields of;
  of.fields[0] = std::string(standingName(item.standing()));
  of.fields[1] = item.mark ? std::string(item.mark->name) : item.excluded;
  if (item.mark)
    for (const JobEvent& event : store.eventsOf(item.id))
      if (event.kind == "mark" && !event.is_undone) {
        of.fields[2] = event.person;
        of.fields[3] = event.at;
      }
  if (item.place) of.fields[4] = std::to_string(*item.place);
  return of;
}

using FieldsByTube = std::map<std::pair<int, int>, ItemFields>;

/// Returns the given list with the fields added to every row of a tube that is an item.
std::string withFields(const std::string& text, const FieldsByTube& fields) {
  const tubesheets::WorkList list = tubesheets::parseWorkListCsv(text);
  std::vector<ColumnText> columns;
  for (std::size_t k = 0; k < ItemFields::kNames.size(); ++k) {
    ColumnText column{ItemFields::kNames[k], std::nullopt, {}};
    for (std::size_t c = 0; c < list.table.text.columns.size(); ++c)
      if (list.table.text.columns[c] == column.name) column.place = c;
    for (const auto& item : list.items)
      if (const auto found = fields.find({item.row, item.column}); found != fields.end())
        column.fields.emplace(item.line, found->second.fields[k]);
    columns.push_back(std::move(column));
  }
  return tubesheets::withColumns(text, list.table.text, columns);
}

}  // namespace

std::string packageCsv(JobStore& store, const std::string& package, const std::string& generator, tubesheets::Leg leg) {
  FieldsByTube fields;
  std::string own = fmt::format("sg,leg,row,column,{}\n", fmt::join(ItemFields::kNames, ","));
  for (const JobItem& item : store.items()) {
    if (item.package != package || item.tube.generator != generator || item.tube.leg != leg) continue;
    const ItemFields of = fieldsOf(store, item);
    own += fmt::format("{},{},{},{}", csvField(generator), tubesheets::legName(leg), item.tube.row, item.tube.column);
    for (const std::string& field : of.fields) own += "," + csvField(field);
    own += "\n";
    fields.emplace(std::pair(item.tube.row, item.tube.column), of);
  }
  if (fields.empty())
    throw InputError::problem(fmt::format("package {}", package),
                              fmt::format("it has no tubes on {}/{}", generator, tubesheets::legName(leg)),
                              "`tubeplan job status` lists the legs of every package");
  const std::string list = store.listOf(package, generator, leg);
  return list.empty() ? own : withFields(list, fields);
}

std::string logCsv(JobStore& store) {
  std::string text = "event,at,who,kind,package,sg,leg,row,column,value,method,reason,undoes\n";
  for (const JobEvent& event : store.events())
    text += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{}\n", event.id, event.at, csvField(event.person),
                        event.kind, event.package, event.tube.generator, tubesheets::legName(event.tube.leg),
                        event.tube.row, event.tube.column, csvField(event.value), event.method, csvField(event.reason),
                        event.undoes ? std::to_string(*event.undoes) : "");
  return text;
}

}  // namespace tubeplan::app
