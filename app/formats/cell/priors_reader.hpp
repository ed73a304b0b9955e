// Prior knowledge of the arm's numbers: a cell's `prior`, and --prior on the command line.
#pragma once

#include <string>
#include <vector>

#include "app/formats/cell/cell_reader.hpp"

namespace tubeplan::app {

/// Reads `prior: {length: 0.2, angle: 1.1, tip: 2, forearm.dh.a: 0.05}`: standard deviations, in the cell's units,
/// about the values of the arm's file. They apply to lengths and angles of the geometry, to the tip, and to single
/// numbers by their dotted names. Throws InputError for other names and for values that are not above zero.
void readPriors(const YamlNode& node, Cell& cell);

/// Sets priors from "NAME=SIGMA" each; "none" removes all priors. Throws InputError as readPriors() does.
void takePriors(const std::vector<std::string>& texts, Cell& cell);

}  // namespace tubeplan::app
