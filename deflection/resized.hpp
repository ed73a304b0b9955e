// Matrices that are given another size and stay whole where there is no memory for it.
#pragma once

#include <Eigen/Core>

namespace tubeplan::deflection {

/// A value of another size takes a matrix's place: it is made whole first. An assignment would do as resize() does
/// below.
template <class Matrix, class Value>
void takeSized(Matrix& matrix, const Value& value) {
  matrix = Matrix(value);
}

/// Gives `matrix` that size; its numbers are to be filled in. Where memory runs out it is empty, and std::bad_alloc
/// goes on. Eigen's own resize() (3.4, DenseStorage.h) frees the old numbers first and leaves their address behind when
/// it throws, so that they are freed again at the matrix's end.
template <class Matrix>
void resizeOrEmpty(Matrix& matrix, Eigen::Index rows, Eigen::Index columns) {
  if (matrix.size() != rows * columns) matrix = Matrix();
  matrix.resize(rows, columns);
}

}  // namespace tubeplan::deflection
