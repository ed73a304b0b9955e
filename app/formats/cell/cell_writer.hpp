// Writer of cells with the results of a calibration or identification and everything else as the user wrote it.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/formats/cell/cell_reader.hpp"
#include "app/storage/atomic_file.hpp"
#include "calibration/estimation/identification.hpp"

namespace tubeplan::app {

/// New base of a cell. Touches from which it was found are written with it; those of an earlier base are removed.
struct BaseChange {
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
  std::optional<Matrix6d> covariance;  ///< as Cell::base_covariance; nothing: that of the file is kept
  bool known = true;
  std::optional<ModelError> model_error = {};  ///< nothing: that of the file is kept, unless it is from earlier touches
  std::vector<calibration::Measurement> touches = {};
  const deflection::Arm* arm = nullptr;  ///< arm with the numbers fitted to the touches; null without touches
};

/// Returns the cell's text with another base, to be written at `out`: names of files in it become relative to there.
[[nodiscard]] std::string cellTextWithBase(const Cell& cell, const BaseChange& base, const std::filesystem::path& out);

/// Files of a cell to be written.
struct CellFiles {
  std::optional<TextFile> arm;      ///< the arm's file, unless the arm is inline
  std::vector<TextFile> of_setups;  ///< a cell for each set-up with an identified base, if there are several
  TextFile cell;

  /// Returns the files in the order of writing, with the arm last. If a power failure stops the writing in between, the
  /// cell and the arm have different identifiers of their pair, and the reader reports it.
  [[nodiscard]] std::vector<TextFile> inOrder() const;

  /// Returns the cell as readCell() would read it from these files.
  [[nodiscard]] Cell reread() const { return reread(cell); }
  [[nodiscard]] Cell reread(const TextFile& of) const;
};

/// Returns the cell with the identified numbers, to be written at `out`. An arm with a file of its own is written too,
/// beside the cell under the cell's name and "-arm". An unknown base is replaced if there is one set-up. Of several
/// set-ups each gets a cell of its own beside it, under the name, "-setup-" and the set-up's name; the cell itself
/// keeps its base. The uncertainty of the arm's numbers is written too. The result is read back: throws InputError
/// unless it reproduces the error of `readings` that the identification reports.
[[nodiscard]] CellFiles identifiedCell(const Cell& cell, const calibration::Identification& result,
                                       const std::vector<calibration::Measurement>& readings,
                                       const std::filesystem::path& out);

/// Puts the name of the arm's file into the cell's text, and the same identifier of the pair into both.
void makePair(std::string& cell, TextFile& arm);

/// Returns the names of an effect's numbers that a fit may free: all except a step's time, which has no derivative.
[[nodiscard]] std::vector<std::string> freedNames(const deflection::Arm& arm, const deflection::Effect& effect);

/// Returns the cell's text with the arm's effects, and with these names added to `identify`.
[[nodiscard]] std::string cellTextWithEffects(const Cell& cell, const deflection::Arm& arm,
                                              const std::vector<std::string>& freed, const std::filesystem::path& out);

/// Returns an improved cell: the original with the effects and freed names that it gained, and the numbers of a fit.
[[nodiscard]] CellFiles improvedCell(const Cell& original, const CellModel& improved,
                                     const calibration::Identification& result,
                                     const std::vector<calibration::Measurement>& readings,
                                     const std::filesystem::path& out);

/// Returns the cell's text with the names of its files relative to `out` and everything else unchanged.
[[nodiscard]] std::string cellTextAt(const Cell& cell, const std::filesystem::path& out);

/// Returns the files of a cell at that path: the cell first, then its arm, if that has a file of its own.
[[nodiscard]] std::vector<TextFile> cellFiles(const Cell& cell, const std::filesystem::path& out);

}  // namespace tubeplan::app
