#include "app/formats/foreign/joined_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "app/storage/count_text.hpp"
#include "app/storage/input_error.hpp"
#include "tubesheets/csv_table.hpp"

namespace tubeplan::app {

namespace {

/// Index of the matching row in another table, for each row of the leading table; std::nullopt for a row without a
/// match.
using Partners = std::vector<std::optional<std::size_t>>;

class RowJoiner {
 public:
  RowJoiner(const std::vector<ForeignTable>& tables, std::size_t lead,
            const std::vector<std::optional<std::size_t>>& names)
      : tables_(tables), names_(names) {
    out_.lead = lead;
  }

  JoinedRows join() {
    out_.rows.resize(tables_.size());
    std::vector<Partners> partners(tables_.size());
    for (std::size_t t = 0; t < tables_.size(); ++t)
      if (t != out_.lead) partners[t] = partnersOf(t);
    for (std::size_t k = 0; k < lead().rows.size(); ++k) {
      const bool is_whole = std::all_of(partners.begin(), partners.end(),
                                        [&](const auto& partner) { return partner.empty() || partner[k]; });
      if (!is_whole) continue;
      for (std::size_t t = 0; t < tables_.size(); ++t)
        out_.rows[t].push_back(partners[t].empty() ? k : *partners[t][k]);
    }
    const std::size_t kept = out_.rows[out_.lead].size();
    if (kept == 0)
      throw InputError::problem(lead().file, "no row has a name that also occurs in the other tables",
                                "give the points the same names in all tables");
    if (const std::size_t lost = lead().rows.size() - kept; lost > 0)
      out_.left_out.push_back(
          fmt::format("{} of {} whose names another table does not have", countText(lost, "row"), lead().file));
    return std::move(out_);
  }

 private:
  [[nodiscard]] const ForeignTable& table(std::size_t t) const { return tables_[t]; }
  [[nodiscard]] const ForeignTable& lead() const { return tables_[out_.lead]; }

  [[nodiscard]] Partners partnersOf(std::size_t t) {
    const auto ours = names_[out_.lead], theirs = names_[t];
    if (ours && theirs) {
      auto partners = partnersByName(t, *ours, *theirs);
      if (std::any_of(partners.begin(), partners.end(), [](const auto& partner) { return partner.has_value(); }))
        return partners;
      refuseOtherNames(t, *ours, *theirs);
    }
    return partnersByOrder(t);
  }

  /// Throws InputError if both tables have textual row names, because such names should match. Running numbers need not
  /// match.
  void refuseOtherNames(std::size_t t, std::size_t ours, std::size_t theirs) const {
    const auto areNames = [](const ForeignTable& table, std::size_t column) {
      return std::none_of(table.rows.begin(), table.rows.end(),
                          [&](const auto& row) { return tubesheets::parseNumber(row.fields[column]).has_value(); });
    };
    if (areNames(lead(), ours) && areNames(table(t), theirs))
      throw InputError::problem(
          table(t).file, fmt::format("none of the names in this table occurs in {}", lead().file),
          "give the points the same names in both tables, or remove the names to match rows by their order");
  }

  Partners partnersByName(std::size_t t, std::size_t ours, std::size_t theirs) {
    std::map<std::string, std::size_t> index;
    for (std::size_t k = 0; k < table(t).rows.size(); ++k) {
      const auto& row = table(t).rows[k];
      if (!index.emplace(pointName(row.fields[theirs]), k).second)
        throw InputError::problem(fmt::format("{}:{}", table(t).file, row.line),
                                  fmt::format("the name {} occurs twice", inQuotes(row.fields[theirs])),
                                  "give the points different names, or remove the names to match rows by their order");
    }
    Partners partners;
    std::set<std::size_t> used;
    for (const auto& row : lead().rows) {
      const auto found = index.find(pointName(row.fields[ours]));
      partners.push_back(found == index.end() ? std::nullopt : std::optional(found->second));
      if (partners.back()) used.insert(*partners.back());
    }
    if (!used.empty()) {
      match("by name");
      if (used.size() < index.size())
        out_.left_out.push_back(fmt::format("{} of {} whose names {} does not have",
                                            countText(index.size() - used.size(), "row"), table(t).file, lead().file));
    }
    return partners;
  }

  Partners partnersByOrder(std::size_t t) {
    const std::size_t ours = lead().rows.size(), theirs = table(t).rows.size();
    if (ours != theirs)
      throw InputError::problem(
          table(t).file,
          fmt::format("none of the {} rows has a name that occurs in {}, which has {} rows", theirs, lead().file, ours),
          "give the points the same names in both tables, or give both tables the same number of rows");
    match("row by row");
    Partners partners;
    for (std::size_t k = 0; k < ours; ++k) partners.emplace_back(k);
    return partners;
  }

  /// Records how a table is matched with the leading table; different tables may be matched in different ways.
  void match(const std::string& how) {
    if (out_.how.find(how) == std::string::npos) out_.how += (out_.how.empty() ? "" : " and ") + how;
  }

  const std::vector<ForeignTable>& tables_;
  const std::vector<std::optional<std::size_t>>& names_;
  JoinedRows out_;
};

}  // namespace

std::string pointName(const std::string& field) {
  const std::size_t colons = field.rfind("::");
  return std::string(tubesheets::trimBlanks(colons == std::string::npos ? field : field.substr(colons + 2)));
}

JoinedRows joinRows(const std::vector<ForeignTable>& tables, std::size_t lead,
                    const std::vector<std::optional<std::size_t>>& names) {
  return RowJoiner(tables, lead, names).join();
}

}  // namespace tubeplan::app
