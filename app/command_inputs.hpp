// What several commands take from the command line.
#pragma once

#include <Eigen/Core>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/readers/units.hpp"
#include "deflection/arm.hpp"
#include "tubesheets/sheet.hpp"
#include "tubesheets/work_list.hpp"

namespace tubeplan::app {

/// What a joint's reading is measured in: an angle, or a length for a prismatic one.
[[nodiscard]] Dimension jointDimension(const deflection::Joint<double>& joint);

/// Its column in a file: theta1_deg, lift_in.
[[nodiscard]] std::string jointColumn(const deflection::Joint<double>& joint, const Units& units);

/// Factors from file to internal units, one per active joint.
[[nodiscard]] Eigen::VectorXd jointFactors(const deflection::Arm& arm, const Units& units);

/// "A,B,C,D": one reading for each active joint, in the cell's unit of angle (length for a prismatic joint), to
/// internal units. Throws InputError for another count, for anything that is no finite number and for a value past its
/// joint's limits; `option` is where they stand.
[[nodiscard]] Eigen::VectorXd parseJoints(const std::string& text, const deflection::Arm& arm, const Units& units,
                                          const std::string& option = "--joints");

/// The hung load in the cell's unit of force, to N. Throws InputError unless it is finite and not negative.
[[nodiscard]] double parseLoad(double load, const Units& units);

/// The tubes that --tubes asks for: the selection language of tubesheets/work_list.hpp, or the name of a work list in a
/// .csv file. Throws InputError for what either refuses; `option` is where they are asked for.
[[nodiscard]] tubesheets::Selection readTubes(const std::string& request, const tubesheets::Sheet& sheet,
                                              const std::string& option = "--tubes");

/// {"length": "in", "angle": "deg", ...}.
[[nodiscard]] nlohmann::json unitsJson(const Units& units);

/// A vector in file units, each number rounded to 12 digits.
[[nodiscard]] nlohmann::json vectorJson(const Eigen::VectorXd& values, const Units& units, Dimension dimension);

/// Checks, before the work, that --json FILE can be written; "" (not asked for) and "-" always can.
void checkJsonTarget(const std::string& target);

/// Writes to standard output for "-", else to a file; nothing for "". NaN and infinity come out as null.
void writeJson(const std::string& target, const nlohmann::json& json);

/// Whether standard output is free for a text for people: it is not where the JSON goes there.
[[nodiscard]] inline bool printsText(const std::string& json_target) { return json_target != "-"; }

}  // namespace tubeplan::app
