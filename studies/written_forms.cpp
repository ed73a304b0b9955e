// Study of identified geometry for arms described in every notation: random mechanisms of three to eight joints whose
// true axes deviate from the drawing, with noisy positions. For each notation the output states the error of the fitted
// arm at other postures relative to its predicted covariance, and the coverage of the predictions' 95 % intervals.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <stdexcept>

#include "calibration/estimation/identification.hpp"
#include "calibration/measurements/measurement_prediction.hpp"
#include "deflection/row_conventions.hpp"
#include "tests/calibration/random_mechanisms.hpp"

namespace tubeplan::calibration {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::Vector3d, Eigen::VectorXd;

constexpr double kNoise = 1e-4;  // [m]
constexpr int kMeasurements = 80, kJudged = 30;

struct Form {
  const char* name;
  PlacedArm (*write)(PlacedArm);
};

PlacedArm byStandardRows(PlacedArm drawn) {
  const auto converted = deflection::convertRows(drawn.arm, deflection::RowConvention::kStandard);
  if (!converted.is_converted) throw std::runtime_error(converted.reason);
  drawn.arm = converted.arm;
  return drawn;
}

const Form kForms[] = {
    {"modified DH", [](PlacedArm drawn) { return drawn; }}, {"origin", byOrigins}, {"standard DH", byStandardRows}};

/// Returns the arm as built, with every axis displaced from the drawing by about 1 mm and several milliradians.
PlacedArm builtFrom(const PlacedArm& drawn, RandomStream& random) {
  PlacedArm built = byOrigins(drawn);
  for (auto& row : built.arm.rows) {
    auto& origin = std::get<deflection::Origin<double>>(row.placement);
    const Eigen::Matrix3d R = deflection::rotationFromFixedAngles<double>(origin.rpy) *
                              deflection::rotationFromVector<double>(random.vector(2e-3));
    origin.position += random.vector(1e-3);
    origin.rpy = deflection::fixedAnglesOf(R);
  }
  built.arm.p_LT += random.vector(2e-3);
  built.base_poses[0].X_WB.translation() += random.vector(5e-3);
  return built;
}

VectorXd postureOf(const deflection::Arm& arm, RandomStream& random) {
  VectorXd q(arm.jointCount());
  for (Index k = 0; k < q.size(); ++k) q[k] = random.uniform(arm.joint(k).lower, arm.joint(k).upper);
  return q;
}

Vector3d tipOf(const PlacedArm& placed, const VectorXd& q) {
  return predictTip(placed.arm, placed.base_poses[0].X_WB, q, 0).value;
}

std::vector<Measurement> measurementsOf(const PlacedArm& built, RandomStream& random) {
  std::vector<Measurement> measurements(kMeasurements);
  for (int k = 0; k < kMeasurements; ++k) {
    Measurement& measurement = measurements[static_cast<std::size_t>(k)];
    measurement.id = std::to_string(k + 1);
    measurement.q = postureOf(built.arm, random);
    measurement.sigma = kNoise;
    measurement.p_W = tipOf(built, measurement.q) + random.vector(kNoise);
  }
  return measurements;
}

/// Statistics of all fits of arms that are described in the same kinematic notation.
struct Tally {
  int fits = 0, failed = 0, within = 0, tried = 0;
  double squares = 0, foretold = 0, chi2 = 0, freedom = 0, worst = 0;
};

/// Returns the derivatives of the tip position with respect to each fitted variable [m per unit].
MatrixXd slopesAt(const PlacedArm& fitted, const std::vector<Unknown>& unknowns, const VectorXd& q) {
  constexpr double kStep = 1e-5;
  MatrixXd slopes(3, static_cast<Index>(unknowns.size()));
  for (Index k = 0; k < slopes.cols(); ++k) {
    VectorXd x = zerosOf(unknowns);
    x[k] = kStep;
    const Vector3d ahead = tipOf(applied(fitted, unknowns, x), q);
    x[k] = -kStep;
    slopes.col(k) = (ahead - tipOf(applied(fitted, unknowns, x), q)) / (2 * kStep);
  }
  return slopes;
}

void judge(const Identification& found, const PlacedArm& built, RandomStream random, Tally& tally) {
  const auto unknowns = fittedUnknowns(found);
  double squares = 0, foretold = 0;
  for (int k = 0; k < kJudged; ++k) {
    const VectorXd q = postureOf(built.arm, random);
    const Vector3d error = tipOf(found.fitted, q) - tipOf(built, q);
    const MatrixXd slopes = slopesAt(found.fitted, unknowns, q);
    const Vector3d variance = (slopes * found.covariance * slopes.transpose()).diagonal();
    squares += error.squaredNorm();
    foretold += variance.sum();
    for (int axis = 0; axis < 3; ++axis) tally.within += std::abs(error[axis]) < 1.96 * std::sqrt(variance[axis]);
    tally.tried += 3;
  }
  tally.squares += squares / kJudged;
  tally.foretold += foretold / kJudged;
  tally.worst = std::max(tally.worst, std::sqrt(squares / foretold));
}

void tryForm(const Form& form, const PlacedArm& written, const PlacedArm& built,
             const std::vector<Measurement>& measurements, std::uint64_t seed, Tally& tally) {
  IdentificationOptions options;
  options.free = {{"geometry"}, true};
  options.folds = 0;
  options.intervals_by_profile = false;
  const Identification found = identify(written, measurements, options);
  ++tally.fits;
  if (found.status != IdentificationStatus::kDone || found.p_value < 1e-3) {
    ++tally.failed;
    fmt::print("seed {} {}: p {:.3g}, chi-square {:.1f} of {} {}\n", seed, form.name, found.p_value, found.chi2,
               found.degrees_of_freedom, found.reason);
  }
  if (found.status != IdentificationStatus::kDone) return;
  tally.chi2 += found.chi2;
  tally.freedom += found.degrees_of_freedom;
  judge(found, built, RandomStream(seed + 2000), tally);
}

void tryAll(int seeds, std::uint64_t first) {
  std::vector<Tally> tallies(std::size(kForms));
  double largest_difference = 0;
  for (std::uint64_t seed = first; seed < first + static_cast<std::uint64_t>(seeds); ++seed) {
    RandomStream random(seed + 1000);
    PlacedArm drawn = mechanism(seed);
    drawn.base_poses[0].is_known = false;
    const PlacedArm built = builtFrom(drawn, random);
    const auto measurements = measurementsOf(built, random);
    for (std::size_t f = 0; f < std::size(kForms); ++f) {
      const PlacedArm written = kForms[f].write(drawn);
      for (int k = 0; k < 5; ++k) {
        const VectorXd q = postureOf(drawn.arm, random);
        largest_difference = std::max(largest_difference, (tipOf(written, q) - tipOf(drawn, q)).norm());
      }
      tryForm(kForms[f], written, built, measurements, seed, tallies[f]);
    }
  }
  fmt::print("{:<12} {:>5} {:>7} {:>22} {:>16} {:>10} {:>9}\n", "form", "fits", "refused", "chi-square per freedom",
             "error / foretold", "worst", "95 % hold");
  for (std::size_t f = 0; f < std::size(kForms); ++f) {
    const Tally& tally = tallies[f];
    fmt::print("{:<12} {:>5} {:>7} {:>22.3f} {:>16.3f} {:>10.2f} {:>8.1f} %\n", kForms[f].name, tally.fits,
               tally.failed, tally.chi2 / tally.freedom, std::sqrt(tally.squares / tally.foretold), tally.worst,
               100. * tally.within / tally.tried);
  }
  fmt::print("the same arm in its forms, farthest apart: {:.2g} m\n", largest_difference);
}

}  // namespace
}  // namespace tubeplan::calibration

int main(int argc, char** argv) {
  CLI::App cli{"Geometry identified from arms written in every form"};
  int seeds = 200;
  std::uint64_t first = 1;
  cli.add_option("--seeds", seeds, "random arms");
  cli.add_option("--first", first, "the first seed");
  CLI11_PARSE(cli, argc, argv);
  tubeplan::calibration::tryAll(seeds, first);
}
