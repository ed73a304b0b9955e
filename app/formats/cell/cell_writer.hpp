// The text of a cell with what a calibration or identification changed, and everything else as the user wrote it.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/formats/cell/cell_reader.hpp"
#include "app/storage/atomic_file.hpp"
#include "calibration/estimation/identification.hpp"

namespace tubeplan::app {

/// A base to be written. Touches that placed it go with it, those of an earlier base do not.
struct BaseChange {
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
  std::optional<Matrix6d> covariance;  ///< as Cell::base_covariance; none removes nothing that the file has
  bool known = true;
  std::optional<ModelError> model_error = {};  ///< none leaves what the file has, but for that of earlier touches
  std::vector<calibration::Measurement> touches = {};
  const deflection::Arm* arm = nullptr;  ///< as the touches have it; null without touches
};

/// The cell's text with another base, to be written at `out`: the files it names are named relative to there.
[[nodiscard]] std::string cellTextWithBase(const Cell& cell, const BaseChange& base, const std::filesystem::path& out);

/// A cell to be written, with all that goes with it.
struct CellFiles {
  std::optional<TextFile> arm;      ///< where the arm stands in a file of its own
  std::vector<TextFile> of_setups;  ///< a cell for each set-up whose base was found, where there are several
  TextFile cell;

  /// The cell first, the arm last: should the writing end in between, as at a power cut, the cell names a pair that
  /// the arm is not of, and the reader says so.
  [[nodiscard]] std::vector<TextFile> inOrder() const;

  /// As it will be read again.
  [[nodiscard]] Cell reread() const { return reread(cell); }
  [[nodiscard]] Cell reread(const TextFile& of) const;
};

/// The cell with the numbers that were found, to be written at `out`. Where its arm stands in a file of its own that
/// file is written too, beside the cell under the cell's name and "-arm". A base that was not known is written where
/// there is one set-up; of several, each has a cell of its own beside it, under the name and "-setup-" and the
/// set-up's, and the cell itself keeps the base it has. How well the readings determined the arm's numbers goes with
/// them. What is written is read back: throws InputError, and nothing is to be written, where it does not give the
/// error of `readings` that the identification reports.
[[nodiscard]] CellFiles identifiedCell(const Cell& cell, const calibration::Identification& result,
                                       const std::vector<calibration::Measurement>& readings,
                                       const std::filesystem::path& out);

/// Gives the cell's text the name of its arm's file, and both the same word by which they are known as a pair.
void makePair(std::string& cell, TextFile& arm);

/// Names of an effect's numbers that a fit may free: all but a step's time, which has no derivative.
[[nodiscard]] std::vector<std::string> freedNames(const deflection::Arm& arm, const deflection::Effect& effect);

/// The cell with the arm's effects, and these names added to `identify`.
[[nodiscard]] std::string cellTextWithEffects(const Cell& cell, const deflection::Arm& arm,
                                              const std::vector<std::string>& freed, const std::filesystem::path& out);

/// An improved cell: what it was read from, with the effects and freed names it has gained and the numbers of a fit.
[[nodiscard]] CellFiles improvedCell(const Cell& original, const CellModel& improved,
                                     const calibration::Identification& result,
                                     const std::vector<calibration::Measurement>& readings,
                                     const std::filesystem::path& out);

/// The cell's text unchanged but for the names of its files, relative to `out`.
[[nodiscard]] std::string cellTextAt(const Cell& cell, const std::filesystem::path& out);

/// The cell at that place, its arm beside it where that stands in a file of its own; the cell is the first.
[[nodiscard]] std::vector<TextFile> cellFiles(const Cell& cell, const std::filesystem::path& out);

}  // namespace tubeplan::app
