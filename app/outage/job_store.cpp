#include "app/outage/job_store.hpp"

#include <fmt/format.h>

#include <cassert>
#include <filesystem>

#include "app/outage/job_schema.hpp"
#include "app/storage/input_error.hpp"

namespace tubeplan::app {

namespace {

constexpr std::string_view kItemColumns =
    "SELECT id, package_name, generator, leg, tube_row, tube_column, excluded, place, mark, last_event, "
    "unreachable FROM standing ";
constexpr std::string_view kEventColumns =
    "SELECT event.id, at, who, kind, item.id, package.name, generator, leg, tube_row, tube_column, value, method, "
    "reason, "
    "undoes, EXISTS (SELECT 1 FROM event AS undo WHERE undo.undoes = event.id) "
    "FROM event JOIN item ON item.id = event.item JOIN package ON package.id = item.package ";

constexpr std::string_view kEndColumns =
    "SELECT generator, leg, tube_row, tube_column, x_m, y_m, state FROM tube WHERE generator = ?1 AND leg = ?2";

std::string legText(tubesheets::Leg leg) { return std::string(tubesheets::legName(leg)); }

TubeAddress addressAt(const DatabaseRow& row, std::size_t column) {
  const auto leg = tubesheets::findLeg(row.text(column + 1));
  assert(leg);
  return {row.text(column), *leg, static_cast<int>(row.integer(column + 2)), static_cast<int>(row.integer(column + 3))};
}

std::optional<std::int64_t> keyAt(const DatabaseRow& row, std::size_t column) {
  return row.isNull(column) ? std::nullopt : std::optional(row.integer(column));
}

std::vector<JobItem> itemsIn(const std::vector<DatabaseRow>& rows) {
  std::vector<JobItem> items;
  for (const DatabaseRow& row : rows)
    items.push_back({row.integer(0), row.text(1), addressAt(row, 2), row.text(6), keyAt(row, 7), findMark(row.text(8)),
                     keyAt(row, 9).value_or(0), row.text(10)});
  return items;
}

std::vector<JobEvent> eventsIn(const std::vector<DatabaseRow>& rows) {
  std::vector<JobEvent> events;
  for (const DatabaseRow& row : rows)
    events.push_back({row.integer(0), row.text(1), row.text(2), row.text(3), row.integer(4), row.text(5),
                      addressAt(row, 6), row.text(10), row.text(11), row.text(12), keyAt(row, 13),
                      row.integer(14) != 0});
  return events;
}

std::vector<TubeEnd> endsIn(const std::vector<DatabaseRow>& rows) {
  std::vector<TubeEnd> ends;
  for (const DatabaseRow& row : rows) ends.push_back({addressAt(row, 0), row.real(4), row.real(5), row.text(6)});
  return ends;
}

/// Returns the value of a key of the table `job`. Throws InputError if the file is not the record of a job.
std::string valueOf(Database& database, const std::string& key) {
  const auto tables = database.query("SELECT 1 FROM sqlite_master WHERE type = 'table' AND name = 'job'");
  const auto rows = tables.empty() ? tables : database.query("SELECT value FROM job WHERE key = ?1", {key});
  if (rows.empty())
    throw InputError::problem(database.path(), "this file is not the record of a job",
                              "name a file that `tubeplan job create` made");
  return rows.front().text(0);
}

}  // namespace

ItemStanding JobItem::standing() const {
  if (mark) return mark->standing;
  if (!excluded.empty()) return ItemStanding::kExcluded;
  return unreachable.empty() ? ItemStanding::kOpen : ItemStanding::kHeld;
}

bool JobItem::isDue() const { return standing() == ItemStanding::kOpen || standing() == ItemStanding::kQueued; }

bool JobItem::isPlugged() const { return mark && mark->state == tubesheets::TubeState::kPlugged; }

std::set<TubeAddress> pluggedEnds(const std::vector<JobItem>& items) {
  std::set<TubeAddress> plugged;
  for (const JobItem& item : items)
    if (item.isPlugged()) plugged.insert(item.tube);
  return plugged;
}

JobStore::JobStore(const std::string& path, Database::Mode mode) : database_(path, mode) {
  if (const std::string format = valueOf(database_, "format"); format != std::to_string(kJobFormat))
    throw InputError(path, "a record of format " + format, fmt::format("format {}", kJobFormat),
                     "open it with the version of the program that made it");
  job_ = parseJobFile(valueOf(database_, "file"), valueOf(database_, "path"));
}

std::vector<JobItem> JobStore::items() {
  return itemsIn(database_.query(fmt::format(
      "{} ORDER BY package, generator, leg DESC, place IS NULL, place, tube_row, tube_column", kItemColumns)));
}

std::vector<JobItem> JobStore::itemsOf(const TubeAddress& tube) {
  return itemsIn(database_.query(
      fmt::format("{} WHERE generator = ?1 AND leg = ?2 AND tube_row = ?3 AND tube_column = ?4 ORDER BY package",
                  kItemColumns),
      {tube.generator, legText(tube.leg), std::int64_t{tube.row}, std::int64_t{tube.column}}));
}

std::vector<JobEvent> JobStore::events(std::int64_t after) {
  return eventsIn(database_.query(fmt::format("{} WHERE event.id > ?1 ORDER BY event.id", kEventColumns), {after}));
}

std::int64_t JobStore::lastEvent() {
  return database_.query("SELECT coalesce(max(id), 0) FROM event").front().integer(0);
}

std::vector<JobEvent> JobStore::eventsOf(std::int64_t item) {
  return eventsIn(database_.query(fmt::format("{} WHERE event.item = ?1 ORDER BY event.id", kEventColumns), {item}));
}

std::vector<JobSheet> JobStore::sheets() {
  std::vector<JobSheet> sheets;
  for (const auto& row : database_.query("SELECT generator, leg, cell, mirrored, fingerprint, pitch_m FROM sheet "
                                         "ORDER BY generator, leg DESC"))
    sheets.push_back(
        {row.text(0), {*tubesheets::findLeg(row.text(1)), row.text(2), row.integer(3) != 0}, row.text(4), row.real(5)});
  return sheets;
}

TubeEnd JobStore::endOf(const TubeAddress& tube) {
  const auto rows =
      database_.query(fmt::format("{} AND tube_row = ?3 AND tube_column = ?4", kEndColumns),
                      {tube.generator, legText(tube.leg), std::int64_t{tube.row}, std::int64_t{tube.column}});
  return endsIn(rows).at(0);
}

std::vector<TubeEnd> JobStore::endsOf(const std::string& generator, tubesheets::Leg leg) {
  return endsIn(
      database_.query(fmt::format("{} ORDER BY tube_row, tube_column", kEndColumns), {generator, legText(leg)}));
}

std::string JobStore::listOf(const std::string& package, const std::string& generator, tubesheets::Leg leg) {
  const auto rows = database_.query(
      "SELECT content FROM list JOIN package ON package.id = list.package "
      "WHERE package.name = ?1 AND generator = ?2 AND leg = ?3",
      {package, generator, legText(leg)});
  return rows.empty() ? "" : rows.front().text(0);
}

std::string JobStore::noteOf(const std::string& key) {
  const auto rows = database_.query("SELECT value FROM job WHERE key = ?1", {key});
  return rows.empty() ? "" : rows.front().text(0);
}

std::string JobStore::drawingOf(const LegName& leg) {
  const std::string look = noteOf("look " + addressText(leg));
  return look.empty() ? "{}" : look;
}

void JobStore::setPlan(const std::string& plan) {
  database_.transact([&] {
    for (const auto& [key, value] : {std::pair<std::string, std::string>{"plan", plan}, {"planned_at", presentTime()}})
      database_.query("INSERT OR REPLACE INTO job VALUES (?1, ?2)", {key, value});
  });
}

std::int64_t JobStore::addEvent(const std::string& kind, std::int64_t item, const std::string& value,
                                const std::string& method, const EventEntry& given,
                                std::optional<std::int64_t> undoes) {
  const EventEntry entry = checkedEntry(given);
  database_.query(
      "INSERT INTO event (at, who, kind, item, value, method, reason, undoes) "
      "VALUES (?1, ?2, ?3, ?4, ?5, ?6, ?7, ?8)",
      {entry.at.empty() ? presentTime() : entry.at, entry.person, kind, item, value, method, entry.reason,
       undoes ? DatabaseValue(*undoes) : DatabaseValue()});
  return database_.lastKey();
}

std::int64_t JobStore::addMark(const JobItem& item, const Mark& mark, const EventEntry& entry) {
  return addEvent("mark", item.id, std::string(mark.name), "", entry, std::nullopt);
}

std::int64_t JobStore::addConfirmation(const JobItem& item, ConfirmationMethod method, const std::string& value,
                                       const EventEntry& entry) {
  return addEvent("confirm", item.id, value, std::string(confirmationName(method)), entry, std::nullopt);
}

std::int64_t JobStore::addUndo(const JobEvent& event, const EventEntry& entry) {
  return addEvent("undo", event.item, event.value, "", entry, event.id);
}

void JobStore::setPlaces(const std::vector<std::int64_t>& items_in_order) {
  for (std::size_t k = 0; k < items_in_order.size(); ++k)
    database_.query("UPDATE item SET place = ?1 WHERE id = ?2", {static_cast<std::int64_t>(k) + 1, items_in_order[k]});
}

void JobStore::setUnreachable(std::int64_t item, const std::string& reason) {
  database_.query("UPDATE item SET unreachable = ?1 WHERE id = ?2", {reason, item});
}

}  // namespace tubeplan::app
