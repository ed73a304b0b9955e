// What several commands take from the command line.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "app/formats/units.hpp"
#include "deflection/arm.hpp"
#include "tubesheets/sheet.hpp"
#include "tubesheets/work_list.hpp"

namespace tubeplan::app {

/// "A,B,C,D": one reading for each active joint, in the cell's unit of angle (length for a prismatic joint), to
/// internal units. Throws InputError for another count, for anything that is no finite number and for a value past its
/// joint's limits; `option` is where they stand.
[[nodiscard]] Eigen::VectorXd parseJoints(const std::string& text, const deflection::Arm& arm, const Units& units,
                                          const std::string& option);

/// The same of any joints; `whose` they are is for the message.
[[nodiscard]] Eigen::VectorXd parseJointsOf(const std::string& text,
                                            const std::vector<const deflection::Joint<double>*>& joints,
                                            const Units& units, const std::string& option, const std::string& whose);

/// The hung load in the cell's unit of force, to N. Throws InputError unless it is finite and not negative; `option` is
/// where it stands.
[[nodiscard]] double parseLoad(double load, const Units& units, const std::string& option);

/// What --tubes asks for; where that is nothing, so many tubes spread over the sheet, or all that take a tool.
[[nodiscard]] std::string tubesOrSpread(const std::string& request, const tubesheets::Sheet& sheet, std::size_t count);

/// The tubes that --tubes asks for: the selection language of tubesheets/work_list.hpp, or the name of a work list in a
/// .csv file. `columns` as of readWorkList(); one that names another list ("row=zone.csv:Reihe") counts for that alone.
/// Throws InputError for what either refuses; `option` is where they are asked for.
[[nodiscard]] tubesheets::Selection readTubes(const std::string& request, const tubesheets::Sheet& sheet,
                                              const std::vector<std::string>& columns = {},
                                              const std::string& option = "--tubes");

/// Throws InputError for columns that are chosen where none of the requests names a work list.
void requireWorkList(const std::vector<std::string>& columns, const std::vector<std::string>& requests);

/// Returns the tubes that the text of a work list names; `name` is its file's, for messages. `columns` say what its
/// columns are where their headings do not, as "row=Reihe" or "x_mm=list.csv:Lage". Throws InputError for a list that
/// is no table, for a quantity that lists have not and for a column that is not there or there twice.
[[nodiscard]] tubesheets::Selection readWorkList(const std::string& text, const std::string& name,
                                                 const tubesheets::Sheet& sheet, const std::string& option = "--tubes",
                                                 const std::vector<std::string>& columns = {});

/// What a work list has that is left out of planning or taken once, a sentence each; empty of other selections.
[[nodiscard]] std::vector<std::string> listNotes(const tubesheets::Selection& selection);

}  // namespace tubeplan::app
