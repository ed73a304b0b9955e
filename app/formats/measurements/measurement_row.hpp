// Reader of a row of a measurement table.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/formats/measurements/measurement_columns.hpp"
#include "calibration/measurement.hpp"
#include "deflection/arm.hpp"
#include "tubesheets/sheet.hpp"

namespace tubeplan::app {

/// Row of a table. Its functions read fields, and throw errors that state the position in the file.
class RowReader {
 public:
  RowReader(const tubesheets::CsvTable& table, const tubesheets::CsvRow& row, const std::string& file)
      : table_(table), row_(row), file_(file) {}

  [[nodiscard]] const std::string& field(std::size_t index) const { return row_.fields[index]; }
  [[nodiscard]] std::string textOr(const std::optional<std::size_t>& index) const { return index ? field(*index) : ""; }
  [[nodiscard]] double number(std::size_t index) const;
  [[nodiscard]] double number(const NumberColumn& column) const;  ///< returns a field's number in internal units

  /// Returns a field's number in internal units; NaN if the column does not exist or the field is empty.
  [[nodiscard]] double numberOrNaN(const std::optional<NumberColumn>& column) const;

  [[noreturn]] void fail(std::size_t column, const std::string& found, const std::string& expected,
                         const std::string& advice = "") const;

  /// Throw InputError::problem(), located at a column of the row or, for failRow(), at the whole row.
  [[noreturn]] void failWithProblem(std::size_t column, const std::string& what, const std::string& advice = "") const;
  [[noreturn]] void failRow(const std::string& what, const std::string& advice = "") const;

  [[nodiscard]] int line() const { return row_.line; }

 private:
  const tubesheets::CsvTable& table_;
  const tubesheets::CsvRow& row_;
  const std::string& file_;
};

/// Returns the measurement in a row; a relative measurement still lacks its reference. Throws InputError with line and
/// column.
[[nodiscard]] calibration::Measurement readMeasurement(const RowReader& row, const MeasurementColumns& columns,
                                                       const deflection::Arm& arm, const tubesheets::Sheet* sheet);

/// Returns the reference of the relative measurement `m`, which the row identifies by id. `known` has all measurements,
/// keyed by id. Throws InputError if the id is missing or unknown, if it is the id of `m` itself, or if the two
/// measurements have different set-ups.
[[nodiscard]] std::shared_ptr<const calibration::Measurement> readReference(
    const RowReader& row, const MeasurementColumns& columns,
    const std::map<std::string, const calibration::Measurement*>& known, const calibration::Measurement& m);

}  // namespace tubeplan::app
