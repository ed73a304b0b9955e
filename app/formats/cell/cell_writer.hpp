// Writer of cells with results of a calibration or identification; everything else in the file is unchanged.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/formats/cell/cell_reader.hpp"
#include "app/storage/atomic_file.hpp"
#include "calibration/estimation/identification.hpp"

namespace tubeplan::app {

/// New base pose of a cell, with the touches that determined it. Touches for an earlier base pose are removed.
struct BaseChange {
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
  std::optional<Matrix6d> covariance;  ///< as Cell::base_covariance; std::nullopt leaves the file unchanged
  bool known = true;
  /// Std::nullopt keeps the error in the file, unless it came from earlier touches.
  std::optional<ModelError> model_error = {};
  std::vector<calibration::Measurement> touches = {};
  const deflection::Arm* arm = nullptr;  ///< arm with the parameters fitted to the touches; null without touches
};

/// Returns the cell's text with a new base pose, for writing to `out`; names of files in the text become relative to
/// the folder of `out`.
[[nodiscard]] std::string cellTextWithBase(const Cell& cell, const BaseChange& base, const std::filesystem::path& out);

/// Files of a cell that are to be written.
struct CellFiles {
  std::optional<TextFile> arm;      ///< arm's file; std::nullopt for an inline arm
  std::vector<TextFile> of_setups;  ///< one cell for each set-up with an identified base; empty for a single set-up
  TextFile cell;

  /// Returns the files in the order of writing, with the arm last. If a power failure interrupts the writing, cell and
  /// arm have different pair identifiers, which the reader reports.
  [[nodiscard]] std::vector<TextFile> inOrder() const;

  /// Returns the cell as readCell() would read it after these files are written.
  [[nodiscard]] Cell reread() const { return reread(cell); }
  [[nodiscard]] Cell reread(const TextFile& of) const;
};

/// Returns the cell with the identified parameters and their uncertainty, for writing to `out`. An arm with its own
/// file is written to the folder of `out`, with the name of `out` and "-arm". With one set-up, an unknown base pose is
/// replaced. With several set-ups, each has its own cell, with the name of `out`, "-setup-" and the set-up's name, and
/// the cell at `out` keeps its base pose. Throws InputError unless the files, when read back, reproduce the error of
/// `measurements` that the identification reports.
[[nodiscard]] CellFiles identifiedCell(const Cell& cell, const calibration::Identification& result,
                                       const std::vector<calibration::Measurement>& measurements,
                                       const std::filesystem::path& out);

/// Writes the name of the arm's file into the cell's text, and the same pair identifier into both texts.
void makePair(std::string& cell, TextFile& arm);

/// Returns the names of the parameters of an effect that a fit may estimate: all except times of steps, because the
/// model has no derivative with respect to these.
[[nodiscard]] std::vector<std::string> freedNames(const deflection::Arm& arm, const deflection::Effect& effect);

/// Returns the cell's text with the effects of `arm`, and with the names in `freed` appended to `identify`.
[[nodiscard]] std::string cellTextWithEffects(const Cell& cell, const deflection::Arm& arm,
                                              const std::vector<std::string>& freed, const std::filesystem::path& out);

/// Returns the files of an improved cell: the original with the added effects, their names under `identify`, and the
/// fitted parameters.
[[nodiscard]] CellFiles improvedCell(const Cell& original, const CellModel& improved,
                                     const calibration::Identification& result,
                                     const std::vector<calibration::Measurement>& measurements,
                                     const std::filesystem::path& out);

/// Returns the cell's text with names of files relative to the folder of `out`, and everything else unchanged.
[[nodiscard]] std::string cellTextAt(const Cell& cell, const std::filesystem::path& out);

/// Returns the files of a cell for writing to `out`: the cell and, if the arm has its own file, the arm.
[[nodiscard]] std::vector<TextFile> cellFiles(const Cell& cell, const std::filesystem::path& out);

}  // namespace tubeplan::app
