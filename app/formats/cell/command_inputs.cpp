#include "app/formats/cell/command_inputs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include "app/formats/arm/joint_units.hpp"
#include "app/formats/other_file.hpp"
#include "app/storage/input_error.hpp"
#include "app/storage/lower_case.hpp"
#include "app/storage/suggestion.hpp"
#include "app/storage/text_file.hpp"
#include "tubesheets/csv_table.hpp"
#include "tubesheets/tube_table.hpp"

namespace tubeplan::app {

namespace {

std::vector<std::string> splitAtCommas(const std::string& text) {
  std::vector<std::string> parts;
  for (std::size_t start = 0; start <= text.size();) {
    const std::size_t comma = std::min(text.find(',', start), text.size());
    parts.emplace_back(tubesheets::trimBlanks(std::string_view(text).substr(start, comma - start)));
    start = comma + 1;
  }
  return parts;
}

double parseJoint(const std::string& text, const deflection::Joint<double>& joint, const Units& units,
                  const std::string& option) {
  const Dimension unit = jointDimension(joint);
  const auto value = tubesheets::parseNumber(text);
  if (!value)
    throw InputError(option + " (" + joint.name + ")", inQuotes(text), "a finite number in " + units.nameOf(unit));
  const double q = units.toInternal(*value, unit);
  constexpr double kSlack = 1e-12;  // tolerance for a joint reading at a limit, to allow for rounding of the conversion
  if (q < joint.lower - kSlack || q > joint.upper + kSlack)
    throw InputError(
        option + " (" + joint.name + ")", fmt::format("{} {}", text, units.nameOf(unit)),
        fmt::format("a value between the joint's limits, {} and {}", formatNumber(units.toFile(joint.lower, unit)),
                    formatNumber(units.toFile(joint.upper, unit))));
  return q;
}

bool namesCsvFile(const std::string& request) {
  return lowerCase(std::filesystem::path(request).extension().string()) == ".csv";
}

using tubesheets::ChosenTubeColumn, tubesheets::TubeQuantity;

/// Returns the quantity that a column name such as "x_mm" or "row" states, with the unit for lengths.
ChosenTubeColumn quantityOf(const std::string& name) {
  std::vector<std::string> known;
  for (const TubeQuantity& quantity : tubesheets::tubeQuantities()) {
    known.emplace_back(quantity.name);
    if (quantity.units.empty() && name == quantity.name) return {quantity.column, 0, nullptr};
    for (const std::string_view unit : quantity.units)
      if (name == fmt::format("{}_{}", quantity.name, unit))
        return {quantity.column, 0, tubesheets::findLengthUnit(unit)};
  }
  throw InputError("--column", inQuotes(name), "a column of a work list, with the unit in the name of a length (x_mm)",
                   suggestion(name, known));
}

std::size_t placeOfChosen(const std::string& theirs, const std::vector<std::string>& columns, const std::string& file) {
  std::vector<std::size_t> found;
  for (std::size_t c = 0; c < columns.size(); ++c)
    if (theirs == columns[c] || theirs == file + ":" + columns[c]) found.push_back(c);
  if (found.size() == 1) return found.front();
  if (found.empty())
    throw InputError::problem("--column", file + " has no column " + inQuotes(theirs), suggestion(theirs, columns));
  throw InputError::problem("--column", fmt::format("{} has {} columns {}", file, found.size(), inQuotes(theirs)),
                            "give each column a name of its own");
}

/// Returns the table of a work list, `text`, with only the columns that `columns` assign, such as "row=Reihe" or
/// "x_mm=list.csv:Lage"; messages name the list as `file`.
tubesheets::TubeTable tubeTableBy(const std::vector<std::string>& columns, const std::string& text,
                                  const std::string& file) {
  auto table = tubesheets::parseTubeText(text);
  if (table.problem) refuseText(file, *table.problem);
  std::vector<ChosenTubeColumn> chosen;
  for (const std::string& column : columns) {
    const std::size_t equals = column.find('=');
    if (equals == std::string::npos) throw InputError("--column", inQuotes(column), "NAME=COLUMN, such as row=Reihe");
    chosen.push_back(quantityOf(column.substr(0, equals)));
    chosen.back().place = placeOfChosen(column.substr(equals + 1), table.columns, file);
  }
  return tubesheets::tubeTableOf(std::move(table), chosen);
}

/// Returns the column assignments that apply to the work list `list`: assignments that name no list, or name `list`.
std::vector<std::string> columnsOfList(std::vector<std::string> columns, const std::string& list) {
  std::erase_if(columns, [&](const std::string& column) {
    const std::string theirs = column.substr(std::min(column.find('='), column.size() - 1) + 1);
    return lowerCase(theirs).find(".csv:") != std::string::npos && !theirs.starts_with(list + ":");
  });
  return columns;
}

tubesheets::Selection selectedOrRefused(tubesheets::Selection selection, const std::string& request,
                                        const std::string& option) {
  if (selection.status == tubesheets::SelectionStatus::kSelected) return selection;
  throw InputError::problem(option, fmt::format("{} cannot be used: {}", inQuotes(request), selection.reason),
                            "`tubeplan map CELL --csv holes.csv` lists the tubes of this sheet");
}

}  // namespace

Eigen::VectorXd parseJoints(const std::string& text, const deflection::Arm& arm, const Units& units,
                            const std::string& option) {
  std::vector<const deflection::Joint<double>*> joints;
  for (const auto& joint : arm.joints()) joints.push_back(&joint);
  return parseJointsOf(text, joints, units, option, "the arm");
}

Eigen::VectorXd parseJointsOf(const std::string& text, const std::vector<const deflection::Joint<double>*>& joints,
                              const Units& units, const std::string& option, const std::string& owner) {
  const auto parts = splitAtCommas(text);
  if (parts.size() != joints.size())
    throw InputError(option, fmt::format("{} numbers", parts.size()),
                     fmt::format("{}, one for each joint of {}", joints.size(), owner), "write " + option + "=A,B,...");
  Eigen::VectorXd q(static_cast<Eigen::Index>(joints.size()));
  for (std::size_t i = 0; i < joints.size(); ++i)
    q[static_cast<Eigen::Index>(i)] = parseJoint(parts[i], *joints[i], units, option);
  return q;
}

double parseLoad(double load, const Units& units, const std::string& option) {
  if (!std::isfinite(load) || load < 0)
    throw InputError(option, fmt::format("{}", load),
                     "a finite weight in " + std::string(units.force().name) + ", zero or more");
  return units.toInternal(load, dimension::kForce);
}

std::string tubesOrSpread(const std::string& request, const tubesheets::Sheet& sheet, std::size_t count) {
  return request.empty() ? tubesheets::spreadRequest(sheet, count) : request;
}

tubesheets::Selection readWorkList(const std::string& text, const std::string& name, const tubesheets::Sheet& sheet,
                                   const std::string& option, const std::vector<std::string>& columns) {
  requireTable(name, text);
  auto list = columns.empty() ? tubesheets::parseWorkListCsv(text)
                              : tubesheets::readWorkListTable(text, tubeTableBy(columns, text, name));
  if (list.problem) refuseText(name, *list.problem);
  return selectedOrRefused(tubesheets::selectTubes(sheet, std::move(list)), name, option);
}

tubesheets::Selection readTubes(const std::string& request, const tubesheets::Sheet& sheet,
                                const std::vector<std::string>& columns, const std::string& option) {
  if (namesCsvFile(request))
    return readWorkList(readTextFile(request), request, sheet, option, columnsOfList(columns, request));
  return selectedOrRefused(tubesheets::selectTubes(sheet, request), request, option);
}

void requireWorkList(const std::vector<std::string>& columns, const std::vector<std::string>& requests) {
  if (!columns.empty() && std::ranges::none_of(requests, namesCsvFile))
    throw InputError::problem("--column", inQuotes(columns.front()) + " is given without a work list",
                              "give the list with --tubes LIST.csv, or leave out --column");
}

std::vector<std::string> listNotes(const tubesheets::Selection& selection) {
  std::vector<std::string> notes;
  if (selection.list)
    for (const std::string& note : selection.list->notes) notes.push_back("work list: " + note);
  return notes;
}

}  // namespace tubeplan::app
