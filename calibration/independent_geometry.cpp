#include "calibration/independent_geometry.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "calibration/random_stream.hpp"
#include "deflection/tip_derivatives.hpp"

namespace tubeplan::calibration {

using deflection::Arm, deflection::JointType, deflection::Parameter;
using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

namespace {

constexpr int kPostures = 12;
// Largest "newness" (fraction of a column's norm outside the span) that is treated as zero.
constexpr double kNothingNew = 1e-6;
// Newness below which a parameter is deferred until all ranks have been tried.
constexpr double kHardlyNew = 0.01;
// The first column in file order with at least this fraction of the largest newness is chosen.
constexpr double kNearlyAsNew = 0.3;
constexpr std::uint64_t kPosturesSeed = 7;
constexpr int kRanks = 5;

bool isToolTurn(const std::string& name) { return name.starts_with("tool.turn."); }

/// Returns the arm as a rigid mechanism without effects and side chains; side chains only add weight.
Arm mechanismOf(const Arm& arm) {
  Arm mechanism = deflection::rigidCopy(arm);
  mechanism.effects.clear();
  mechanism.side_chains.clear();
  return mechanism;
}

/// Returns random postures, with revolute joints anywhere within a full turn and prismatic joints within a metre of
/// zero. Joint limits are ignored, because they do not change which parameters are independent.
std::vector<deflection::Posture> posturesAllOver(const Arm& mechanism) {
  RandomStream random(kPosturesSeed);
  std::vector<deflection::Posture> postures(kPostures);
  for (auto& posture : postures) {
    posture.q.resize(mechanism.jointCount());
    for (Index j = 0; j < posture.q.size(); ++j) {
      const double end = mechanism.joint(j).type == JointType::kPrismatic ? 1 : std::numbers::pi;
      posture.q[j] = random.uniform(-end, end);
    }
  }
  return postures;
}

/// Returns the derivatives of the tool pose at random postures: 6 rows per posture, with lengths divided by the arm's
/// reach. The columns are the parameters, then the six components of a base step.
MatrixXd motionsBy(const Arm& mechanism, const std::vector<Parameter>& numbers) {
  std::vector<deflection::Variable> variables;
  for (const Parameter& number : numbers) variables.push_back(deflection::Variable::number(number.path));
  const auto postures = posturesAllOver(mechanism);
  const double size = deflection::reachOf(mechanism);
  const auto count = static_cast<Index>(numbers.size());
  MatrixXd motions = MatrixXd::Zero(6 * kPostures, count + 6);
  for (int k = 0; k < kPostures; ++k) {
    const auto tip = deflection::differentiateTip(mechanism, postures[static_cast<std::size_t>(k)], variables);
    auto place = motions.middleRows<3>(6 * k), turn = motions.middleRows<3>(6 * k + 3);
    place.leftCols(count) = tip.position_B / size;
    turn.leftCols(count) = tip.rotation_B;
    place.middleCols<3>(count) = Eigen::Matrix3d::Identity();
    place.rightCols<3>() = -deflection::crossMatrix<double>(tip.kinematics.X_BD.p) / size;
    turn.rightCols<3>() = Eigen::Matrix3d::Identity();
  }
  return motions;
}

/// Tracks the components of all columns that lie outside the span of the columns taken so far.
class Span {
 public:
  explicit Span(const MatrixXd& motions) : outside_(motions), lengths_(motions.colwise().norm()) {}

  /// Returns the fraction of a column's norm that lies outside the span: 1 at first, 0 for a column of zeros.
  [[nodiscard]] double newnessOf(Index column) const {
    return lengths_[column] > 0 ? outside_.col(column).norm() / lengths_[column] : 0;
  }
  void take(Index column) {
    if (newnessOf(column) < kNothingNew) return;
    const VectorXd direction = outside_.col(column).normalized();
    for (int pass = 0; pass < 2; ++pass) outside_ -= direction * (direction.transpose() * outside_);
  }

 private:
  MatrixXd outside_;
  VectorXd lengths_;
};

/// Returns the rank of a parameter (rank 0 is tried first), or std::nullopt if it is not a geometric parameter of the
/// main chain.
std::optional<int> rankOf(const Parameter& number, const PlacedArm& placed) {
  if (number.path.side_chain >= 0 || number.path.effect >= 0 || !isGeometry(number.name)) return std::nullopt;
  if (number.path.row < 0) return 1;
  if (number.name.ends_with(".joint.offset")) return 0;
  if (isShiftOfFirstAxis(number.name)) return kRanks - 1;
  return moves(placed.arm.rows[static_cast<std::size_t>(number.path.row)].joint) ? 2 : 3;
}

/// Takes the parameters of one rank, one after another, until newnessOf() is below `least` for all others.
void takeAll(std::vector<Index> columns, double least, Span& span, std::vector<Index>& taken) {
  while (!columns.empty()) {
    double newest = 0;
    for (const Index column : columns) newest = std::max(newest, span.newnessOf(column));
    if (newest < least) return;
    const auto first =
        std::ranges::find_if(columns, [&](Index column) { return span.newnessOf(column) >= kNearlyAsNew * newest; });
    span.take(*first);
    taken.push_back(*first);
    columns.erase(first);
  }
}

double priorOf(const Parameter& number, const Priors& priors) {
  if (isToolTurn(number.name)) return priors.turn;
  if (number.path.row < 0) return priors.tip;
  return number.quantity == deflection::Quantity::kAngle ? priors.angle : priors.length;
}

/// Returns the variance that each taken parameter absorbs from errors of the parameters held fixed: each column in
/// `held` (with its standard deviation) is a combination of the columns `taken` and `absorbing`.
VectorXd leftByOthers(const MatrixXd& motions, const std::vector<Index>& taken, std::vector<Index> absorbing,
                      const std::vector<std::pair<Index, double>>& held) {
  absorbing.insert(absorbing.begin(), taken.begin(), taken.end());
  const VectorXd lengths = motions.colwise().norm();
  MatrixXd basis(motions.rows(), static_cast<Index>(absorbing.size()));
  for (Index k = 0; k < basis.cols(); ++k) {
    const Index column = absorbing[static_cast<std::size_t>(k)];
    basis.col(k) = motions.col(column) / lengths[column];
  }
  const Eigen::ColPivHouseholderQR<MatrixXd> solver(basis);
  VectorXd variances = VectorXd::Zero(static_cast<Index>(taken.size()));
  for (const auto& [column, sigma] : held) {
    if (lengths[column] == 0) continue;
    const VectorXd shares = solver.solve(motions.col(column));
    for (Index k = 0; k < variances.size(); ++k)
      variances[k] += std::pow(shares[k] / lengths[taken[static_cast<std::size_t>(k)]] * sigma, 2);
  }
  return variances;
}

/// Returns true if the fit determines every base pose. Otherwise a base is known, and the parameters up to the first
/// joint must be fitted instead.
bool placesEveryBase(const PlacedArm& placed, const std::vector<Unknown>& free) {
  return std::ranges::none_of(placed.base_poses, &BasePose::is_known) &&
         std::ranges::any_of(free, [](const Unknown& unknown) { return unknown.owner == Unknown::Owner::kBase; });
}

}  // namespace

bool isGeometry(const std::string& name) {
  const auto has = [&](std::string_view map) { return name.find(map) != std::string::npos; };
  return has(".dh.") || has(".axis.") || has(".origin.") || name.ends_with(".joint.offset") ||
         name.starts_with("tool.tip.") || isToolTurn(name);
}

bool isShiftOfFirstAxis(const std::string& name) { return name.ends_with(".dh.b") || name.ends_with(".axis.b"); }

std::vector<IndependentNumber> independentGeometry(const PlacedArm& placed, const std::vector<Unknown>& free) {
  const Arm mechanism = mechanismOf(placed.arm);
  std::vector<Parameter> numbers = deflection::parametersOf(mechanism);
  std::erase_if(numbers, [&](const Parameter& number) { return !rankOf(number, placed); });
  const MatrixXd motions = motionsBy(mechanism, numbers);
  Span span(motions);
  std::vector<Index> taken, absorbing;
  const auto takeFree = [&](Index column) {
    if (span.newnessOf(column) >= kNothingNew) absorbing.push_back(column);
    span.take(column);
  };
  if (placesEveryBase(placed, free))
    for (Index step = 0; step < 6; ++step) takeFree(static_cast<Index>(numbers.size()) + step);
  std::vector<std::vector<Index>> ranks(kRanks);
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    const auto isIt = [&](const Unknown& unknown) { return unknown.name == numbers[k].name; };
    const bool is_unseen = isToolTurn(numbers[k].name) && !placed.shows_tool_turn;
    if (is_unseen || std::ranges::any_of(free, isIt))
      takeFree(static_cast<Index>(k));
    else
      ranks[static_cast<std::size_t>(*rankOf(numbers[k], placed))].push_back(static_cast<Index>(k));
  }
  for (const double least : {kHardlyNew, kNothingNew})
    for (const auto& columns : ranks) takeAll(columns, least, span, taken);
  std::ranges::sort(taken);
  std::vector<std::pair<Index, double>> held;
  for (const auto& columns : ranks)
    for (const Index column : columns)
      if (!std::ranges::binary_search(taken, column))
        held.emplace_back(column, priorOf(numbers[static_cast<std::size_t>(column)], placed.priors));
  const VectorXd variances = leftByOthers(motions, taken, absorbing, held);
  std::vector<IndependentNumber> chosen;
  for (std::size_t k = 0; k < taken.size(); ++k)
    chosen.push_back({numbers[static_cast<std::size_t>(taken[k])].name, std::sqrt(variances[static_cast<Index>(k)])});
  return chosen;
}

}  // namespace tubeplan::calibration
