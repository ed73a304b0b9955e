// Reader of priors of the arm's parameters: a cell's `prior`, and --prior on the command line.
#pragma once

#include <string>
#include <vector>

#include "app/formats/cell/cell_reader.hpp"

namespace tubeplan::app {

/// Reads `prior: {length: 0.2, angle: 1.1, tip: 2, forearm.dh.a: 0.05}`: standard deviations about the values in the
/// arm's file, in the cell's units. Priors apply to all lengths or angles of the geometry, to the tip, or to a single
/// parameter by its dotted name. Throws InputError for other names and for standard deviations that are not positive.
void readPriors(const YamlNode& node, Cell& cell);

/// Sets priors from strings "NAME=SIGMA"; the string "none" removes all priors. Throws InputError in the cases of
/// readPriors().
void takePriors(const std::vector<std::string>& texts, Cell& cell);

}  // namespace tubeplan::app
