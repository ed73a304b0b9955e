#include "calibration/identifiability.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <set>

namespace tubeplan::calibration {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

namespace {

constexpr double kSeen = 1.96;  // noise sigmas that 95 % of chance stays within

/// The columns kept so far, as an orthonormal basis.
class Basis {
 public:
  explicit Basis(Index rows) : Q_(rows, 0) {}

  /// What of the column is outside the basis. Twice is enough to be square to it to rounding.
  [[nodiscard]] VectorXd outside(const VectorXd& column) const {
    VectorXd v = column;
    for (int n = 0; n < 2; ++n) v -= Q_ * (Q_.transpose() * v);
    return v;
  }

  void add(const VectorXd& outside) {
    Q_.conservativeResize(Eigen::NoChange, Q_.cols() + 1);
    Q_.rightCols<1>() = outside.normalized();
  }

 private:
  MatrixXd Q_;
};

struct Selection {
  const MatrixXd& columns;  // over typical sizes
  const std::vector<Unknown>& unknowns;
  const IdentifiabilityOptions& options;
  Basis basis;
  std::vector<int> kept, held;

  [[nodiscard]] bool isTold(int k, const VectorXd& own) const {
    if (own.norm() < options.least_share * columns.col(k).norm()) return false;
    const bool is_geometry = unknowns[static_cast<std::size_t>(k)].is_geometry;
    if (own.norm() >= options.noise * (is_geometry ? 1 : options.least_told)) return true;
    if (options.offset.size() == 0) return false;
    const double way_back = std::abs(options.offset[k]) / unknowns[static_cast<std::size_t>(k)].typical;
    return own.norm() * way_back >= kSeen * options.noise;
  }

  void takeInOrder(int k) {
    const VectorXd own = basis.outside(columns.col(k));
    const bool is_apart = own.norm() > options.least_share * columns.col(k).norm();
    if (!isTold(k, options.twins_stay ? columns.col(k) : own)) return held.push_back(k);
    if (is_apart) basis.add(own);
    kept.push_back(k);
  }

  void takeByPivot(std::vector<int> candidates) {
    MatrixXd rest(columns.rows(), static_cast<Index>(candidates.size()));
    for (std::size_t k = 0; k < candidates.size(); ++k)
      rest.col(static_cast<Index>(k)) = basis.outside(columns.col(candidates[k]));
    std::vector<int> untold;
    while (!candidates.empty()) {
      Index best = 0;
      rest.colwise().norm().maxCoeff(&best);
      const int k = candidates[static_cast<std::size_t>(best)];
      const VectorXd own = basis.outside(columns.col(k));
      if (isTold(k, own)) {
        basis.add(own);
        kept.push_back(k);
        const VectorXd q = own.normalized();
        rest -= (q * (q.transpose() * rest)).eval();
      } else {
        untold.push_back(k);
      }
      rest.col(best) = rest.rightCols<1>();
      rest.conservativeResize(Eigen::NoChange, rest.cols() - 1);
      candidates[static_cast<std::size_t>(best)] = candidates.back();
      candidates.pop_back();
    }
    std::sort(untold.begin(), untold.end());
    held.insert(held.end(), untold.begin(), untold.end());
  }
};

HeldUnknown explain(const MatrixXd& columns, const MatrixXd& kept_columns, const std::vector<int>& kept, int k,
                    const IdentifiabilityOptions& options) {
  HeldUnknown result;
  result.unknown = k;
  const VectorXd column = columns.col(k);
  result.is_seen = column.norm() >= std::max(1., options.noise);
  if (!result.is_seen || kept.empty()) return result;
  const VectorXd shares = kept_columns.completeOrthogonalDecomposition().solve(column);
  std::vector<std::size_t> order(kept.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  const auto strength = [&](std::size_t i) {
    return std::abs(shares[static_cast<Index>(i)]) * kept_columns.col(static_cast<Index>(i)).norm();
  };
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return strength(a) > strength(b); });
  for (const std::size_t i : order) {
    if (strength(i) < options.named_share * strength(order.front())) break;
    result.with.push_back(kept[i]);
    result.shares.push_back(shares[static_cast<Index>(i)]);
  }
  return result;
}

}  // namespace

Identifiability findIdentifiable(const MatrixXd& jacobian, const std::vector<Unknown>& unknowns,
                                 const IdentifiabilityOptions& options) {
  MatrixXd columns = jacobian;
  for (Index k = 0; k < columns.cols(); ++k) columns.col(k) *= unknowns[static_cast<std::size_t>(k)].typical;
  Selection selection{columns, unknowns, options, Basis(columns.rows()), {}, {}};
  std::vector<int> geometry;
  const std::set<int> last(options.at_bound.begin(), options.at_bound.end());
  for (int k = 0; k < static_cast<int>(unknowns.size()); ++k) {
    if (unknowns[static_cast<std::size_t>(k)].is_geometry)
      geometry.push_back(k);
    else if (!last.contains(k))
      selection.takeInOrder(k);
  }
  for (const int k : last)
    if (!unknowns[static_cast<std::size_t>(k)].is_geometry) selection.takeInOrder(k);
  selection.takeByPivot(geometry);
  Identifiability result;
  result.kept = selection.kept;
  std::sort(result.kept.begin(), result.kept.end());
  MatrixXd kept_columns(columns.rows(), static_cast<Index>(result.kept.size()));
  for (std::size_t k = 0; k < result.kept.size(); ++k)
    kept_columns.col(static_cast<Index>(k)) = columns.col(result.kept[k]);
  for (const int k : selection.held) result.held.push_back(explain(columns, kept_columns, result.kept, k, options));
  if (!result.kept.empty()) result.singular_values = kept_columns.bdcSvd().singularValues();
  return result;
}

}  // namespace tubeplan::calibration
