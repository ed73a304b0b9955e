// Resizing of matrices that keeps them valid if memory runs out.
#pragma once

#include <Eigen/Core>

namespace tubeplan::deflection {

/// Replaces a matrix with a value of another size. The value is computed completely before the matrix changes. A plain
/// assignment would leave the matrix invalid if memory ran out; see resizeOrEmpty().
template <class Matrix, class Value>
void takeSized(Matrix& matrix, const Value& value) {
  matrix = Matrix(value);
}

/// Resizes `matrix`; its entries are not initialised. If memory runs out, the matrix becomes empty and std::bad_alloc
/// propagates. Eigen's own resize() (3.4, DenseStorage.h) frees the old entries first and keeps their address when it
/// throws, so that they are freed twice.
template <class Matrix>
void resizeOrEmpty(Matrix& matrix, Eigen::Index rows, Eigen::Index columns) {
  if (matrix.size() != rows * columns) matrix = Matrix();
  matrix.resize(rows, columns);
}

}  // namespace tubeplan::deflection
