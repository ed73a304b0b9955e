// What is known of the arm's numbers beforehand: a cell's `prior`, and --prior on the command line.
#pragma once

#include <string>
#include <vector>

#include "app/formats/cell/cell_reader.hpp"

namespace tubeplan::app {

/// `prior: {length: 0.2, angle: 1.1, tip: 2, forearm.dh.a: 0.05}`: standard deviations in the cell's units about the
/// values of the arm's file, of lengths and angles of the geometry, of the tip, and of single numbers by their dotted
/// names. Throws InputError for other names and for what is not above zero.
void readPriors(const YamlNode& node, Cell& cell);

/// The same from "NAME=SIGMA" each; "none" takes every prior away.
void takePriors(const std::vector<std::string>& texts, Cell& cell);

}  // namespace tubeplan::app
