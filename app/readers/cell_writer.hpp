// The text of a cell with what a calibration or identification changed, and everything else as the user wrote it.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "app/readers/cell_reader.hpp"

namespace tubeplan::app {

struct BaseChange {
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
  std::optional<Matrix6d> covariance;  ///< as Cell::base_covariance; none removes nothing that the file has
  bool known = true;
};

/// The cell's text with another base, to be written at `out`: the files it names are named relative to there.
[[nodiscard]] std::string cellTextWithBase(const Cell& cell, const BaseChange& base, const std::filesystem::path& out);

/// The cell's text unchanged but for the names of its files, relative to `out`.
[[nodiscard]] std::string cellTextAt(const Cell& cell, const std::filesystem::path& out);

}  // namespace tubeplan::app
