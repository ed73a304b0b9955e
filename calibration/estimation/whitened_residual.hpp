// The residual of a whole campaign in units of its noise: every kind of reading, any number of set-ups, the touched
// points that nobody measured eliminated exactly.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "calibration/estimation/shared_noise.hpp"
#include "calibration/hooks.hpp"
#include "calibration/measurement.hpp"
#include "calibration/placed_arm.hpp"
#include "deflection/tip_derivatives.hpp"

namespace tubeplan::calibration {

/// Where each reading's rows stand, how they are weighted, and which readings touched one unknown point.
///
/// Elimination: whitened readings of one unknown point P are W_i p_i with Q an orthonormal basis of the stacked W_i;
/// the best P leaves (I - Q Q^T) W p. So the point costs 3 degrees of freedom and no variable. Of a touched surface the
/// stacked rows are W_i C_i, with C_i the change of the reading with the surface's numbers; what they do not tell of
/// them costs nothing.
struct ReadingWeights {
  struct UnknownPoint {
    std::string name;
    std::vector<int> readings;
    Eigen::MatrixXd Q;         ///< as many rows as all of its readings have, at most a column for each number
    Eigen::MatrixXd estimate;  ///< takes the stacked errors to the numbers of the place
  };
  std::vector<int> first_row;              ///< of each reading
  std::vector<Eigen::MatrixXd> whitener;   ///< L^-1 of the own covariance L L^T, times the root of its weight
  std::vector<Eigen::MatrixXd> noise;      ///< covariance of each reading by its own and the encoders' noise [m^2]
  std::vector<Eigen::MatrixXd> own_noise;  ///< the same without what it shares with other readings
  std::vector<Eigen::MatrixXd> by_place_numbers;  ///< C_i; empty of readings without an unknown place
  std::vector<SharedNoise> shared;
  double model_error = 0;  ///< m, standard deviation of each coordinate beyond the noise, added to every covariance
  std::vector<UnknownPoint> points;
  int rows = 0;
  int degrees_of_freedom = 0;  ///< rows less those of the points

  /// Of a reading alone: its noise and the model's own error.
  [[nodiscard]] Eigen::MatrixXd covariance(std::size_t reading) const;
};

/// Weights at a state of the arm: the covariance of each reading with its encoders' noise. `factors`, where given, are
/// the weights of a robust fit, one for each reading. Nothing where the model cannot be evaluated; asked to stop, it
/// unwinds by WorkStopped.
[[nodiscard]] std::optional<ReadingWeights> weighReadings(const PlacedArm& placed,
                                                          const std::vector<Measurement>& readings,
                                                          const Eigen::VectorXd& factors = {}, double model_error = 0,
                                                          const StopQuestion& stop = {});

/// The same weights with another model error or other factors.
[[nodiscard]] ReadingWeights reweighted(const ReadingWeights& weights, const std::vector<Measurement>& readings,
                                        double model_error, const Eigen::VectorXd& factors = {});

struct WhitenedResidual {
  bool ok = false;
  Eigen::VectorXd r;         ///< whitened, predicted less measured; rows of `weights`
  Eigen::MatrixXd jacobian;  ///< by the unknowns' variables, where asked for
  Eigen::VectorXd error;     ///< the same in metres, not whitened; of an unknown point: from its estimate
};

/// The residual at variables x of the unknowns, from the state `start`; unwinds by WorkStopped.
[[nodiscard]] WhitenedResidual whitenedResidual(const PlacedArm& start, const std::vector<Unknown>& unknowns,
                                                const std::vector<Measurement>& readings, const ReadingWeights& weights,
                                                const Eigen::VectorXd& x, bool with_jacobian,
                                                const StopQuestion& stop = {});

/// Takes off columns (rows of `weights`) that each reading's whitener has weighted what readings have in common: noise
/// of encoders that were read once, and what the unknown points absorb.
void takeSharedOff(const ReadingWeights& weights, Eigen::Ref<Eigen::MatrixXd> columns);

/// The same of the rows of these readings alone, one after another, as far as they share with no others.
void takeOffWithin(const ReadingWeights& weights, const std::vector<int>& readings, Eigen::MatrixXd& rows);

/// Length of each reading's error [m].
[[nodiscard]] Eigen::VectorXd errorLengths(const std::vector<Measurement>& readings, const ReadingWeights& weights,
                                           const Eigen::VectorXd& error);

/// Root mean square over the readings of the number of rows: the length that an error of one in each row makes.
[[nodiscard]] double lengthOfRows(const std::vector<Measurement>& readings);

/// What noise alone leaves: root mean square over the readings of the error's length [m], with the touched points'
/// estimates taken off.
[[nodiscard]] double noiseFloor(const std::vector<Measurement>& readings, const ReadingWeights& weights);

}  // namespace tubeplan::calibration
