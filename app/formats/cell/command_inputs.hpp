// Command-line inputs that several commands share.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "app/formats/units.hpp"
#include "deflection/arm.hpp"
#include "tubesheets/sheet.hpp"
#include "tubesheets/work_list.hpp"

namespace tubeplan::app {

/// Converts "A,B,C,D", one reading for each active joint, from the cell's units of angle (or length, for prismatic
/// joints) to internal units. Throws InputError for a wrong count, for anything but finite numbers, and for a reading
/// beyond its joint's limits; messages name the input as `option`.
[[nodiscard]] Eigen::VectorXd parseJoints(const std::string& text, const deflection::Arm& arm, const Units& units,
                                          const std::string& option);

/// Converts readings of any joints in the syntax of parseJoints(); `owner` describes the joints in messages.
[[nodiscard]] Eigen::VectorXd parseJointsOf(const std::string& text,
                                            const std::vector<const deflection::Joint<double>*>& joints,
                                            const Units& units, const std::string& option, const std::string& owner);

/// Converts the suspended load from the cell's unit of force to newtons. Throws InputError unless the load is finite
/// and not negative; messages name the input as `option`.
[[nodiscard]] double parseLoad(double load, const Units& units, const std::string& option);

/// Returns `request`, the text of --tubes. If the text is empty, returns a selection of `count` tubes spread over the
/// sheet, or of all tubes that can take a tool if there are fewer.
[[nodiscard]] std::string tubesOrSpread(const std::string& request, const tubesheets::Sheet& sheet, std::size_t count);

/// Returns the tubes of a request, which is a selection in the language of tubesheets/work_list.hpp or the name of a
/// work list, a .csv file. `columns` are as for readWorkList(); assignments for other lists ("row=zone.csv:Reihe") are
/// ignored. Throws InputError for an invalid selection or list; messages name the input as `option`.
[[nodiscard]] tubesheets::Selection readTubes(const std::string& request, const tubesheets::Sheet& sheet,
                                              const std::vector<std::string>& columns = {},
                                              const std::string& option = "--tubes");

/// Throws InputError if `columns` assigns columns but none of the requests names a work list.
void requireWorkList(const std::vector<std::string>& columns, const std::vector<std::string>& requests);

/// Returns the tubes in the text of a work list; messages name the list as `name`. `columns` assigns columns whose
/// headings are ambiguous, such as "row=Reihe" or "x_mm=list.csv:Lage". Throws InputError for text that is not a table,
/// for an unknown quantity, and for a column that is missing or occurs twice.
[[nodiscard]] tubesheets::Selection readWorkList(const std::string& text, const std::string& name,
                                                 const tubesheets::Sheet& sheet, const std::string& option = "--tubes",
                                                 const std::vector<std::string>& columns = {});

/// Returns notes, one sentence each, on rows of a work list that planning leaves out or merges; empty for other
/// selections.
[[nodiscard]] std::vector<std::string> listNotes(const tubesheets::Selection& selection);

}  // namespace tubeplan::app
