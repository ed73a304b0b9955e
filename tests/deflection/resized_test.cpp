// If there is no memory for its new size, a matrix must become empty, and its old memory must not be freed twice.
#include "deflection/resized.hpp"

#include <gtest/gtest.h>

#include <new>

#include "deflection/posture_batch.hpp"

/// Lets the sanitizers' allocators return null, as other allocators do, instead of ending the program.
extern "C" const char* __asan_default_options() { return "allocator_may_return_null=1"; }
extern "C" const char* __tsan_default_options() { return "allocator_may_return_null=1"; }

namespace tubeplan::deflection {
namespace {

constexpr Eigen::Index kTooMany = Eigen::Index{1} << 56;  // exceeds the address space

template <class Matrix>
void expectEmptyWithoutMemory() {
  Matrix matrix = Matrix::Ones(6, 9);
  EXPECT_THROW(resizeOrEmpty(matrix, 6, kTooMany), std::bad_alloc);
  EXPECT_EQ(matrix.size(), 0);
  EXPECT_EQ(matrix.data(), nullptr);
  resizeOrEmpty(matrix, 6, 2);
  EXPECT_EQ(matrix.cols(), 2);
}

TEST(ResizeOrEmpty, IsEmptyWithoutMemory) {
  expectEmptyWithoutMemory<Eigen::MatrixXd>();
  expectEmptyWithoutMemory<Side>();
  expectEmptyWithoutMemory<Eigen::Matrix<double, 6, Eigen::Dynamic>>();
}

TEST(ResizeOrEmpty, KeepsItsPlaceInMemoryForAsManyNumbers) {
  Eigen::MatrixXd matrix(4, 6);
  const double* const place = matrix.data();
  resizeOrEmpty(matrix, 6, 4);
  EXPECT_EQ(matrix.data(), place);
  Eigen::VectorXd vector(3);
  resizeOrEmpty(vector, 5, 1);
  EXPECT_EQ(vector.size(), 5);
}

TEST(TakeSized, KeepsWhatWasThereWithoutMemory) {
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Ones(6, 9);
  EXPECT_THROW(takeSized(matrix, Eigen::MatrixXd::Constant(6, kTooMany, 2)), std::bad_alloc);
  EXPECT_EQ(matrix, Eigen::MatrixXd::Ones(6, 9));
  takeSized(matrix, Eigen::MatrixXd::Constant(2, 3, 2));
  EXPECT_EQ(matrix, Eigen::MatrixXd::Constant(2, 3, 2));
}

TEST(ResizeOrEmpty, ABatchOfPosturesOutlivesASizeThatItHasNoMemoryFor) {
  PostureBatch batch;
  batch.resize(4, 9);
  EXPECT_THROW(batch.resize(4, kTooMany), std::bad_alloc);
  EXPECT_EQ(batch.size(), 0);
  batch.resize(4, 2, 20);
  EXPECT_EQ(batch.load.size(), 2);
  EXPECT_EQ(batch.gravity_B.col(1), -Eigen::Vector3d::UnitZ());
}

}  // namespace
}  // namespace tubeplan::deflection
