#include "calibration/diagnosis/model_selection/noise_hypotheses.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "calibration/diagnosis/causes/repeated_numbers.hpp"
#include "calibration/estimation/fit.hpp"
#include "calibration/estimation/prior.hpp"
#include "calibration/measurements/measurement_kinds.hpp"
#include "calibration/measurements/measurement_prediction.hpp"
#include "calibration/statistics.hpp"

namespace tubeplan::calibration {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

namespace {

// Prior probabilities of a discrepancy with all terms, of a discrepancy with only one source, and of a larger noise
// than stated.
constexpr double kDiscrepancy = 0.05;
constexpr double kSingleSource = 0.05;
constexpr double kMoreNoise = 0.1;
// Maximum number of measurements whose columns are in memory at once.
constexpr std::size_t kMeasurementsInMemory = 1024;
constexpr Eigen::Index kPrincipalTerms = 80;  // number of principal terms of the discrepancy in the evidence of a fit
// Maximum number of elements of the causes' columns that are kept in memory.
constexpr double kMostKept = 5e7;
constexpr double kMostForSources = 2e6;  // product of rows and terms above which single sources are not weighed

std::vector<double> discrepancySizes(double noise) {
  std::vector<double> sizes;
  for (double size = 0.7 * noise; size < 200 * noise && sizes.size() < 9; size *= 2) sizes.push_back(size);
  return sizes;
}

/// Returns blocks of measurement indices; all measurements of an unknown point are in one block.
std::vector<std::vector<int>> blocksOf(const std::vector<Measurement>& measurements) {
  std::vector<std::vector<int>> blocks;
  for (const auto& group : groupsByPlace(measurements)) {
    if (blocks.empty() || blocks.back().size() + group.size() > kMeasurementsInMemory) blocks.emplace_back();
    blocks.back().insert(blocks.back().end(), group.begin(), group.end());
  }
  return blocks;
}

/// Converts rows that were whitened with the weights `from` to rows whitened with the weights `to`.
void whitenAnew(const std::vector<Measurement>& measurements, const MeasurementWeights& from,
                const MeasurementWeights& to, MatrixXd& columns) {
  for (std::size_t k = 0; k < measurements.size(); ++k) {
    auto rows = columns.middleRows(to.first_row[k], rowsOf(measurements[k]));
    rows = (to.whitener[k] * from.whitener[k].inverse() * rows).eval();
  }
}

/// Columns of one block of measurements, whitened with the stated noise, including the components that touched points
/// absorb.
struct Block {
  std::vector<Measurement> measurements;
  MeasurementWeights weights;  ///< weights including the touched points
  MatrixXd J, S, Z;
  VectorXd y;
};

/// Returns the causes' columns of one block for the stated noise. The columns are computed once and kept if they fit
/// into memory.
MatrixXd signaturesOf(DiagnosisWork& work, const std::vector<int>& which, const Block& block,
                      const MeasurementWeights& without_points) {
  const std::vector<int>& first_row = work.basis.weights.first_row;
  const auto rowOf = [&](std::size_t k) { return first_row[static_cast<std::size_t>(which[k])]; };
  Eigen::MatrixXf& kept = work.kept_signatures;
  MatrixXd S(block.y.size(), static_cast<Index>(work.signatures->columns().size()));
  if (kept.size() > 0 && work.noise.size() == 1) {
    for (std::size_t k = 0; k < which.size(); ++k)
      S.middleRows(without_points.first_row[k], rowsOf(block.measurements[k])) =
          kept.middleRows(rowOf(k), rowsOf(block.measurements[k])).cast<double>();
    return S;
  }
  S = work.signatures->columnsAt(block.measurements, without_points, work.basis.stop);
  if (S.rows() != block.y.size() || static_cast<double>(work.basis.weights.rows) * S.cols() > kMostKept) return S;
  kept.resize(work.basis.weights.rows, S.cols());
  for (std::size_t k = 0; k < which.size(); ++k)
    kept.middleRows(rowOf(k), rowsOf(block.measurements[k])) =
        S.middleRows(without_points.first_row[k], rowsOf(block.measurements[k])).cast<float>();
  return S;
}

bool fillBlock(DiagnosisWork& work, const std::vector<int>& which, Block& block) {
  const FittedBasis& basis = work.basis;
  block.measurements = picked(basis.measurements, which);
  auto weights = weighMeasurements(basis.fitted, block.measurements, {}, 0, basis.stop);
  if (!weights) return false;
  block.weights = std::move(*weights);
  MeasurementWeights without_points = block.weights;
  without_points.points.clear();
  without_points.shared.clear();
  auto residual = whitenedResidual(basis.fitted, basis.unknowns, block.measurements, without_points,
                                   zerosOf(basis.unknowns), true, basis.stop);
  if (!residual.ok) return false;
  block.J = std::move(residual.jacobian);
  block.y = -residual.r;
  block.S = signaturesOf(work, which, block, without_points);
  block.Z = work.discrepancy->columnsAt(block.measurements, without_points);
  return block.S.rows() == block.y.size() && block.Z.rows() == block.y.size();
}

/// Adds the block's columns to the Gram matrix, whitened for the stated noise plus `model_error` [m], without the
/// components that unknown points absorb.
void addTo(EvidenceGram& gram, const Block& block, double model_error) {
  const MeasurementWeights weights = reweighted(block.weights, block.measurements, model_error);
  gram.log_density += logDensityOf(weights);
  MatrixXd all(block.y.size(), block.J.cols() + block.S.cols() + block.Z.cols() + 1);
  all << block.J, block.S, block.Z, block.y;
  if (model_error > 0) whitenAnew(block.measurements, block.weights, weights, all);
  removeSharedParts(weights, all);
  gram.add(all.leftCols(block.J.cols()), all.middleCols(block.J.cols(), block.S.cols()),
           all.middleCols(block.J.cols() + block.S.cols(), block.Z.cols()), all.rightCols<1>());
}

double degreesLeft(const DiagnosisWork& work) {
  return work.basis.weights.degrees_of_freedom -
         numbersDetermined(posteriorCovariance(work.basis.residual.jacobian, work.basis.unknowns), work.basis.unknowns);
}

/// Stores the discrepancy's columns at all measurements for the evidence of separate fits: those of principal terms and
/// of single sources.
void keepDiscrepancy(const DiagnosisWork& work, NoiseHypothesis& noise) {
  const auto& terms = work.discrepancy->terms();
  noise.principal_terms = noise.evidence->principalTerms(kPrincipalTerms);
  noise.discrepancy.resize(noise.weights.rows, noise.principal_terms.cols());
  const bool has_sources =
      static_cast<double>(noise.weights.rows) * static_cast<double>(terms.size()) < kMostForSources;
  MatrixXd all(has_sources ? noise.weights.rows : 0, static_cast<Index>(terms.size()));
  for (const auto& which : blocksOf(work.basis.measurements)) {
    throwIfStopped(work.basis.stop);
    const auto measurements = picked(work.basis.measurements, which);
    const auto weights = weighMeasurements(work.basis.fitted, measurements, {}, noise.model_error, work.basis.stop);
    if (!weights) return;
    const MatrixXd columns = work.discrepancy->columnsAt(measurements, *weights);
    const MatrixXd principal = columns * noise.principal_terms;
    for (std::size_t k = 0; k < measurements.size(); ++k) {
      const int to = noise.weights.first_row[static_cast<std::size_t>(which[k])], rows = rowsOf(measurements[k]);
      noise.discrepancy.middleRows(to, rows) = principal.middleRows(weights->first_row[k], rows);
      if (has_sources) all.middleRows(to, rows) = columns.middleRows(weights->first_row[k], rows);
    }
  }
  if (!has_sources) return;
  std::vector<double> shares;
  for (const auto& term : terms) shares.push_back(term.share);
  noise.sources = std::make_unique<SingleSources>(std::move(all), work.discrepancy->sources(), shares);
}

/// Returns the stated noise of one coordinate [m].
double noiseOfCoordinate(const DiagnosisWork& work) {
  return noiseFloor(work.basis.measurements, work.basis.weights) / lengthOfRows(work.basis.measurements);
}

/// Returns the error of a coordinate in excess of the stated noise [m] that explains this chi-square; 0 if the stated
/// noise suffices.
double errorBeyondNoise(const DiagnosisWork& work, double chi2, double freedom) {
  if (freedom < 3 || !(chiSquareTail(chi2, freedom) < kLackOfFit)) return 0;
  return noiseOfCoordinate(work) * std::sqrt(std::max(0.1, chi2 / freedom - 1));
}

/// Returns scale factors to try for the noise with this model error, from below 1 to beyond the error of the model
/// without a discrepancy. With few measurements, an unknown function absorbs much of the noise, so the model error
/// estimated with it is too small.
std::vector<double> noiseScales(const DiagnosisWork& work, double model_error) {
  constexpr double kLeast = 0.7, kMost = 1.5, kFarthest = 6, kStep = 1.08;
  const double per_coordinate = noiseOfCoordinate(work);
  const double alone = errorBeyondNoise(work, work.noise.front().evidence->chi2(), degreesLeft(work));
  const double up = std::hypot(per_coordinate, alone) / std::hypot(per_coordinate, model_error);
  std::vector<double> scales;
  for (double scale = kLeast; scale < kMost * std::clamp(up, 1., kFarthest); scale *= kStep) scales.push_back(scale);
  return scales;
}

/// Adds a noise assumption with its evidence. Returns false if the model cannot be evaluated.
bool addNoise(DiagnosisWork& work, double model_error, double log_prior) {
  NoiseHypothesis noise;
  noise.model_error = model_error;
  noise.log_prior = log_prior;
  noise.weights = reweighted(work.basis.weights, work.basis.measurements, model_error);
  EvidenceGram gram;
  for (const auto& which : blocksOf(work.basis.measurements)) {
    reportProgress(work.options.hooks, "catalogue");
    Block block;
    if (!fillBlock(work, which, block)) return false;
    addTo(gram, block, model_error);
  }
  const double floor = noiseFloor(work.basis.measurements, work.basis.weights);
  noise.options.discrepancies =
      discrepancySizes(std::hypot(floor, lengthOfRows(work.basis.measurements) * model_error));
  noise.options.discrepancy_prior = kDiscrepancy;
  noise.options.source_prior = kSingleSource;
  if (model_error > 0) noise.options.noise_scales = noiseScales(work, model_error);
  noise.options.noise_rows = degreesLeft(work);
  noise.evidence = std::make_unique<LinearEvidence>(gram, work.basis.unknowns, noise.options);
  keepDiscrepancy(work, noise);
  work.noise.push_back(std::move(noise));
  return true;
}

/// Returns the error of a coordinate [m] in excess of the stated noise that remains even with the largest unknown
/// discrepancy.
double errorBeyondRichest(const DiagnosisWork& work) {
  const RichestFit richest = work.noise.front().evidence->richest();
  return errorBeyondNoise(work, richest.chi2, work.noise.front().options.noise_rows - richest.numbers);
}

}  // namespace

double logDensityOf(const MeasurementWeights& weights) {
  double log = -0.5 * weights.rows * std::log(2 * std::numbers::pi);
  for (const MatrixXd& whitener : weights.whitener) log += std::log(std::abs(whitener.determinant()));
  for (const SharedNoise& shared : weights.shared) log += (1 - shared.shrink.array()).log().sum();
  return log;
}

bool linearize(DiagnosisWork& work) {
  work.causes = listCauses(work.basis.fitted, work.basis.measurements, work.basis.unknowns, work.options.hooks);
  work.signatures = std::make_unique<Signatures>(work.basis.fitted, work.causes.causes);
  if (removeRepeated(work.basis.fitted, work.basis.measurements, work.basis.unknowns, *work.signatures, work.causes,
                     work.basis.stop))
    work.signatures = std::make_unique<Signatures>(work.basis.fitted, work.causes.causes);
  work.discrepancy = std::make_unique<Discrepancy>(work.basis.fitted, work.basis.measurements);
  if (!addNoise(work, 0, 0)) return false;
  const double more = errorBeyondRichest(work);
  return !(more > 0) || doubtNoise(work, more);
}

double errorBeyondBest(const DiagnosisWork& work) {
  // Models are sorted by weight, so the first one with a fit is the best.
  const auto best = std::ranges::find_if(work.models, &CompetingModel::hasFit);
  if (best == work.models.end()) return 0;
  double numbers = 0;
  for (const ModelTerm& term : best->terms) numbers += static_cast<double>(term.numbers.size());
  return errorBeyondNoise(work, best->fit.chi2, work.noise.front().options.noise_rows - numbers);
}

bool doubtNoise(DiagnosisWork& work, double model_error) {
  work.noise.front().log_prior = std::log1p(-kMoreNoise);
  const bool is_added = addNoise(work, model_error, std::log(kMoreNoise));
  work.kept_signatures.resize(0, 0);
  return is_added;
}

}  // namespace tubeplan::calibration
