// Resizing of matrices that leaves them valid if memory runs out.
#pragma once

#include <Eigen/Core>

namespace tubeplan::deflection {

/// Replaces a matrix by a value of another size, which is first computed completely. A plain assignment would fail like
/// resize() below.
template <class Matrix, class Value>
void takeSized(Matrix& matrix, const Value& value) {
  matrix = Matrix(value);
}

/// Gives `matrix` that size; its numbers remain to be filled in. If memory runs out, it becomes empty and
/// std::bad_alloc propagates. Eigen's own resize() (3.4, DenseStorage.h) frees the old numbers first and keeps their
/// address when it throws, so that they are freed twice.
template <class Matrix>
void resizeOrEmpty(Matrix& matrix, Eigen::Index rows, Eigen::Index columns) {
  if (matrix.size() != rows * columns) matrix = Matrix();
  matrix.resize(rows, columns);
}

}  // namespace tubeplan::deflection
