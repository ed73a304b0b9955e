// Command-line inputs shared by several commands.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "app/formats/units.hpp"
#include "deflection/arm.hpp"
#include "tubesheets/sheet.hpp"
#include "tubesheets/work_list.hpp"

namespace tubeplan::app {

/// Converts "A,B,C,D", one reading for each active joint in the cell's unit of angle (length for a prismatic joint), to
/// internal units. Throws InputError for another count, for anything but finite numbers and for a value past its
/// joint's limits; `option` names the input in messages.
[[nodiscard]] Eigen::VectorXd parseJoints(const std::string& text, const deflection::Arm& arm, const Units& units,
                                          const std::string& option);

/// Converts readings of any joints as parseJoints() does; `whose` describes the joints in messages.
[[nodiscard]] Eigen::VectorXd parseJointsOf(const std::string& text,
                                            const std::vector<const deflection::Joint<double>*>& joints,
                                            const Units& units, const std::string& option, const std::string& whose);

/// Converts the hung load from the cell's unit of force to N. Throws InputError unless it is finite and not negative;
/// `option` names the input in messages.
[[nodiscard]] double parseLoad(double load, const Units& units, const std::string& option);

/// Returns the text of --tubes, or, if that is empty, a selection of `count` tubes spread over the sheet (all tubes
/// that take a tool, if fewer).
[[nodiscard]] std::string tubesOrSpread(const std::string& request, const tubesheets::Sheet& sheet, std::size_t count);

/// Returns the tubes of a request: in the selection language of tubesheets/work_list.hpp, or the name of a work list in
/// a .csv file. `columns` are those of readWorkList(); one that names another list ("row=zone.csv:Reihe") is ignored
/// here. Throws InputError as these two do; `option` names the input in messages.
[[nodiscard]] tubesheets::Selection readTubes(const std::string& request, const tubesheets::Sheet& sheet,
                                              const std::vector<std::string>& columns = {},
                                              const std::string& option = "--tubes");

/// Throws InputError for chosen columns if none of the requests names a work list.
void requireWorkList(const std::vector<std::string>& columns, const std::vector<std::string>& requests);

/// Returns the tubes of a work list's text; `name` is its file's name in messages. `columns` assign columns that their
/// headings leave open, as "row=Reihe" or "x_mm=list.csv:Lage". Throws InputError for text that is no table, for an
/// unknown quantity and for a column that is missing or occurs twice.
[[nodiscard]] tubesheets::Selection readWorkList(const std::string& text, const std::string& name,
                                                 const tubesheets::Sheet& sheet, const std::string& option = "--tubes",
                                                 const std::vector<std::string>& columns = {});

/// Returns notes on rows of a work list that planning leaves out or merges, a sentence each; empty for other
/// selections.
[[nodiscard]] std::vector<std::string> listNotes(const tubesheets::Selection& selection);

}  // namespace tubeplan::app
