#include "calibration/diagnosis/causes/formula_overlap.hpp"

#include <algorithm>

#include "calibration/diagnosis/causes/signatures.hpp"
#include "calibration/estimation/span.hpp"
#include "deflection/effects/formula.hpp"

namespace tubeplan::calibration {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

namespace {

constexpr double kLeastOverlap = 0.05;
// If the fit leaves less than this fraction of a signature's length, the rest is treated as zero.
constexpr double kLeastKept = 1e-4;

std::vector<Unknown> numbersOf(const PlacedArm& placed, int effect) {
  std::vector<Unknown> unknowns;
  for (const auto& parameter : deflection::parametersOf(placed.arm)) {
    if (parameter.path.effect != effect) continue;
    Unknown unknown;
    unknown.name = parameter.name;
    unknown.quantity = parameter.quantity;
    unknown.path = parameter.path;
    unknown.start = parameter.value;
    unknowns.push_back(unknown);
  }
  return unknowns;
}

/// Returns the signature of a formula in the measurements: one column for the current values of its parameters, or one
/// column per parameter if all values are zero.
MatrixXd signatureOf(const deflection::Effect& effect, const MatrixXd& columns) {
  const auto& parameters = deflection::numbersOf(effect);
  VectorXd sizes = VectorXd::Zero(columns.cols());
  MatrixXd each(columns.rows(), 0);
  for (Index k = 0; k < columns.cols(); ++k) {
    if (parameters[static_cast<std::size_t>(k)].is_shape) continue;
    sizes[k] = effect.values[static_cast<std::size_t>(k)];
    each.conservativeResize(Eigen::NoChange, each.cols() + 1);
    each.rightCols<1>() = columns.col(k).stableNormalized();
  }
  return sizes.isZero(0) ? each : MatrixXd((columns * sizes).stableNormalized());
}

/// Fitted model with its measurements and their weights, and the catalogue's causes linearised about this model.
struct Setting {
  const PlacedArm& placed;
  const std::vector<Measurement>& measurements;
  const MeasurementWeights& weights;
  const std::vector<Unknown>& fitted;
  const SingleCauses& catalogue;

  [[nodiscard]] MatrixXd jacobianBy(const std::vector<Unknown>& unknowns) const {
    return whitenedResidual(placed, unknowns, measurements, weights, zerosOf(unknowns), true).jacobian;
  }
};

std::vector<EffectShare> sharesOf(const Setting& at, const MatrixXd& others, const MatrixXd& unabsorbed) {
  std::vector<EffectShare> shares;
  for (std::size_t c = 0; c < at.catalogue.causes.size(); ++c) {
    const Cause& cause = at.catalogue.causes[c];
    for (int level = 0; level < static_cast<int>(cause.levels.size()); ++level) {
      const MatrixXd own = at.catalogue.columnsOf(c, level);
      const MatrixXd columns = without(others, own);
      if (!(columns.norm() > kLeastKept * own.norm())) continue;
      const double share = (spanOf(columns).transpose() * unabsorbed).squaredNorm() / unabsorbed.squaredNorm();
      const auto same = std::ranges::find_if(
          shares, [&](const EffectShare& s) { return s.effect == cause.effect && s.at == cause.at; });
      if (same != shares.end())
        same->share = std::max(same->share, share);
      else if (share > kLeastOverlap)
        shares.push_back({cause.effect, cause.at, share});
    }
  }
  std::ranges::stable_sort(shares, std::greater{}, &EffectShare::share);
  return shares;
}

FormulaOverlap overlapOf(const Setting& at, int effect) {
  const deflection::Effect& formula = at.placed.arm.effects[static_cast<std::size_t>(effect)];
  FormulaOverlap overlap;
  overlap.formula = deflection::textOf(at.placed.arm, formula);
  std::vector<Unknown> others = at.fitted;
  std::erase_if(others, [&](const Unknown& u) { return u.path.effect == effect; });
  const MatrixXd Q = others.empty() ? MatrixXd() : spanOf(at.jacobianBy(others));
  const MatrixXd signature = signatureOf(formula, at.jacobianBy(numbersOf(at.placed, effect)));
  if (signature.cols() == 0 || signature.norm() == 0) return overlap;
  const MatrixXd unabsorbed = without(Q, signature);
  overlap.absorbed = std::clamp(1 - unabsorbed.squaredNorm() / signature.squaredNorm(), 0., 1.);
  if (unabsorbed.norm() > kLeastKept * signature.norm()) overlap.shares = sharesOf(at, Q, unabsorbed);
  return overlap;
}

}  // namespace

std::vector<FormulaOverlap> findFormulaOverlaps(const Identification& result,
                                                const std::vector<Measurement>& measurements) {
  const auto& effects = result.fitted.arm.effects;
  const bool has_any = std::ranges::any_of(effects, [](const auto& e) { return e.formula != nullptr; });
  if (result.status != IdentificationStatus::kDone || !has_any) return {};
  const auto used = picked(measurements, result.used);
  const auto weights = weighMeasurements(result.fitted, used);
  if (!weights) return {};
  const auto fitted = fittedUnknowns(result);
  const auto catalogue = singleCauses(result.fitted, used, fitted, *weights);
  if (!catalogue) return {};
  std::vector<FormulaOverlap> overlaps;
  for (int k = 0; k < static_cast<int>(effects.size()); ++k)
    if (effects[static_cast<std::size_t>(k)].formula)
      overlaps.push_back(overlapOf({result.fitted, used, *weights, fitted, *catalogue}, k));
  return overlaps;
}

}  // namespace tubeplan::calibration
