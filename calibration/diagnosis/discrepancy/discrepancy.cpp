#include "calibration/diagnosis/discrepancy/discrepancy.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>
#include <numbers>

#include "calibration/diagnosis/discrepancy/discrepancy_motion.hpp"

namespace tubeplan::calibration {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;
using Function = std::function<double(const Measurement&)>;

namespace {

constexpr int kWaves = 3;
constexpr int kBumps = 10;
constexpr int kSlowWaves = 4;
// If the arm has more joints than this, products for two joints are used only if the joints are neighbours or one of
// them has the error.
constexpr int kManyJoints = 5;
constexpr std::size_t kMeasurementsForScale =
    300;  // number of measurements used to compute the root mean square of a term
// Amplitudes relative to the first wave of a joint; rougher functions have smaller amplitudes.
constexpr double kBump = 0.5, kProduct = 0.5, kShift = 0.7, kTurn = 0.5, kMinor = 0.5;
// Number of joints, counted from the base, that move most of the arm's weight.
constexpr std::size_t kWeighingJoints = 3;

/// Function of a measurement, with the name of the variable that the function depends on.
struct Feature {
  std::string follows;
  Function function;
  double amplitude = 1;
};

struct Range {
  double low = std::numeric_limits<double>::infinity(), high = -std::numeric_limits<double>::infinity();

  void take(double value) {
    if (std::isfinite(value)) low = std::min(low, value), high = std::max(high, value);
  }
  [[nodiscard]] bool isWide() const { return high > low; }
};

Range rangeOf(const std::vector<Measurement>& measurements, const Function& value) {
  Range range;
  for (const auto& measurement : measurements) range.take(value(measurement));
  return range;
}

Function product(const Function& a, const Function& b) {
  return [a, b](const Measurement& m) { return a(m) * b(m); };
}

/// Functions of one joint's position. The period of the first wave is one turn for a revolute joint, and twice the
/// travelled range for a prismatic joint.
class JointFeatures {
 public:
  JointFeatures(const deflection::Joint<double>& joint, Index index, const std::vector<Measurement>& measurements)
      : name_(joint.name),
        index_(index),
        range_(rangeOf(measurements, [index](const Measurement& m) { return m.q[index]; })) {
    const bool turns = joint.type == deflection::JointType::kRevolute;
    rate_ = turns ? 1 : std::numbers::pi / std::max(1e-9, range_.high - range_.low);
  }

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] bool moves() const { return range_.isWide(); }

  [[nodiscard]] Function sine(int k) const {
    return [i = index_, w = rate_ * k](const Measurement& m) { return std::sin(w * m.q[i]); };
  }
  [[nodiscard]] Function cosine(int k) const {
    return [i = index_, w = rate_ * k](const Measurement& m) { return std::cos(w * m.q[i]); };
  }

  [[nodiscard]] std::vector<Feature> waves(int most) const {
    std::vector<Feature> features;
    for (int k = 1; k <= most; ++k) {
      features.push_back({name_, sine(k), 1. / k});
      features.push_back({name_, cosine(k), 1. / k});
    }
    return features;
  }

  /// Returns functions that differ from zero only near one position of the joint, like the error of a worn gear tooth.
  [[nodiscard]] std::vector<Feature> bumps() const {
    std::vector<Feature> features;
    const double width = (range_.high - range_.low) / kBumps;
    for (int k = 0; k < kBumps; ++k) {
      const double centre = range_.low + (k + 0.5) * width;
      features.push_back({name_,
                          [i = index_, centre, width](const Measurement& m) {
                            const double away = (m.q[i] - centre) / width;
                            return std::exp(-away * away / 2);
                          },
                          kBump});
    }
    return features;
  }

  [[nodiscard]] std::vector<Feature> direction() const {
    const Function sense = [i = index_](const Measurement& m) {
      return m.approach_directions.empty() ? 0.
                                           : static_cast<double>(m.approach_directions[static_cast<std::size_t>(i)]);
    };
    const std::string follows = "direction of " + name_;
    return {
        {follows, sense, 1}, {follows, product(sense, sine(1)), kMinor}, {follows, product(sense, cosine(1)), kMinor}};
  }

 private:
  std::string name_;
  Index index_;
  Range range_;
  double rate_ = 1;
};

std::vector<Feature> productsOf(const JointFeatures& a, const JointFeatures& b) {
  const std::string follows = a.name() + " and " + b.name();
  std::vector<Feature> features;
  for (const auto& f : {a.sine(1), a.cosine(1)})
    for (const auto& g : {b.sine(1), b.cosine(1)}) features.push_back({follows, product(f, g), kProduct});
  return features;
}

/// Functions of the load and of the conditions stated by the measurements, independent of the joints.
struct Conditions {
  std::vector<Feature> load;
  deflection::OfEachCondition<std::vector<Feature>> stated;

  explicit Conditions(const std::vector<Measurement>& measurements) {
    const Range loads = rangeOf(measurements, [](const Measurement& m) { return m.load; });
    if (loads.isWide()) {
      const auto share = [most = loads.high](const Measurement& m) { return m.load / most; };
      load = {{"load", share, 1}, {"load", product(share, share), 1}};
    }
    for (const auto& kind : deflection::kConditionKinds) stated[kind.condition] = featuresOf(kind, measurements);
  }

 private:
  /// Returns a linear function from -1 to 1, or waves over the range of the condition; zero at a measurement that does
  /// not state the condition.
  static std::vector<Feature> featuresOf(const deflection::ConditionKind& kind,
                                         const std::vector<Measurement>& measurements) {
    const auto value = [of = kind.condition](const Measurement& m) { return m.conditions[of]; };
    const Range range = rangeOf(measurements, value);
    if (!range.isWide()) return {};
    const auto share = [value, range](const Measurement& m) {
      return (value(m) - range.low) / (range.high - range.low);
    };
    const auto orNothing = [](double x) { return std::isfinite(x) ? x : 0.; };
    if (kind.course == deflection::Course::kProportional)
      return {{kind.name, [=](const Measurement& m) { return orNothing(2 * share(m) - 1); }, 1}};
    std::vector<Feature> waves;
    for (int k = 1; k <= kSlowWaves; ++k)
      waves.push_back({kind.name,
                       [=](const Measurement& m) { return orNothing(std::cos(k * std::numbers::pi * share(m))); },
                       1. / k});
    return waves;
  }
};

/// Builds the terms of the discrepancy process, channel by channel.
class TermMaker {
 public:
  TermMaker(const deflection::Arm& arm, const std::vector<Measurement>& measurements) : conditions_(measurements) {
    Index index = 0;
    for (const auto& joint : arm.joints()) joints_.emplace_back(joint, index++, measurements);
    has_directions_ =
        std::ranges::any_of(measurements, [](const Measurement& m) { return !m.approach_directions.empty(); });
  }

  [[nodiscard]] std::vector<DiscrepancyTerm> make() {
    for (std::size_t j = 0; j < joints_.size(); ++j) addJointError(j);
    const int tool = static_cast<int>(joints_.size()), base = tool + 3;
    for (int axis = 0; axis < 3; ++axis) {
      addToolShift(tool + axis);
      addBaseShift(base + axis);
      addBaseTurn(base + 3 + axis);
    }
    return std::move(terms_);
  }

 private:
  /// Adds terms for an error at `place`. Terms with the same place and variable belong to one source.
  void add(const std::string& place, int channel, const std::vector<Feature>& features, double amplitude = 1) {
    for (const Feature& feature : features) {
      const auto source = sources_.try_emplace(place + " " + feature.follows, static_cast<int>(sources_.size())).first;
      terms_.push_back({feature.follows, channel, source->second, feature.function, feature.amplitude * amplitude});
    }
  }

  void addConditions(const std::string& place, int channel, double amplitude) {
    for (const auto& features : conditions_.stated.all) add(place, channel, features, amplitude);
  }

  void addJointError(std::size_t j) {
    const int channel = static_cast<int>(j);
    const std::string& place = joints_[j].name();
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      if (!joints_[i].moves()) continue;
      add(place, channel, joints_[i].waves(i == j ? kWaves : 2));
      if (i == j) add(place + " near", channel, joints_[i].bumps());
      for (std::size_t l = i + 1; l < joints_.size(); ++l) {
        const bool is_near = joints_.size() <= kManyJoints || i == j || l == j || l == i + 1;
        if (is_near && joints_[l].moves()) add(place, channel, productsOf(joints_[i], joints_[l]));
      }
    }
    if (has_directions_) add(place, channel, joints_[j].direction());
    add(place, channel, conditions_.load);
    for (const Feature& load : conditions_.load)
      for (const auto& f : {joints_[j].sine(1), joints_[j].cosine(1)})
        add(place, channel, {{"load", product(load.function, f), kMinor}});
    addConditions(place, channel, kMinor);
  }

  void addToolShift(int channel) {
    for (const JointFeatures& joint : joints_)
      if (joint.moves()) add("tool", channel, joint.waves(kWaves), kShift);
    for (const JointFeatures& joint : joints_)
      if (has_directions_) add("tool", channel, {joint.direction().front()}, kShift);
    add("tool", channel, conditions_.load, kShift);
    for (const auto& kind : deflection::kConditionKinds)
      if (kind.moves_tool) add("tool", channel, conditions_.stated[kind.condition], kShift);
  }

  void addBaseShift(int channel) {
    if (!joints_.empty() && joints_.front().moves()) add("base", channel, joints_.front().waves(2), kShift);
    add("base", channel, conditions_.load, kShift);
    addConditions("base", channel, kShift);
  }

  /// Adds the rotation of a compliant support, which depends on the joints because of the arm's weight.
  void addBaseTurn(int channel) {
    for (std::size_t j = 0; j < std::min(joints_.size(), kWeighingJoints); ++j) {
      if (!joints_[j].moves()) continue;
      add("base's turn", channel, joints_[j].waves(2), kTurn);
      if (j > 0 && joints_.front().moves()) add("base's turn", channel, productsOf(joints_.front(), joints_[j]), kTurn);
    }
    add("base's turn", channel, conditions_.load, kTurn);
    addConditions("base's turn", channel, kTurn);
  }

  Conditions conditions_;
  std::vector<JointFeatures> joints_;
  bool has_directions_ = false;
  std::map<std::string, int> sources_;
  std::vector<DiscrepancyTerm> terms_;
};

/// Returns the change of the measurement's rows [m] due to a term with coefficient 1.
VectorXd columnOf(const std::vector<Motion>& motions, const DiscrepancyTerm& term) {
  VectorXd column = motions.front().displacements.col(term.channel) * term.function(motions.front().at);
  for (std::size_t k = 1; k < motions.size(); ++k)
    column += motions[k].displacements.col(term.channel) * term.function(motions[k].at);
  return column;
}

/// Scales the terms so that the whole process has a root-mean-square error of 1 m, split among the terms by their
/// amplitudes. Removes terms that change no measurement.
void scaleTerms(const PlacedArm& placed, const std::vector<Measurement>& measurements,
                std::vector<DiscrepancyTerm>& terms) {
  std::vector<double> squares(terms.size());
  double count = 0;
  MeasurementPredictor predictor(placed.arm);
  const std::size_t step = std::max<std::size_t>(1, measurements.size() / kMeasurementsForScale);
  for (std::size_t k = 0; k < measurements.size(); k += step) {
    const auto motions = motionsOf(predictor, placed, measurements[k]);
    if (motions.empty()) continue;
    ++count;
    for (std::size_t t = 0; t < terms.size(); ++t) squares[t] += columnOf(motions, terms[t]).squaredNorm();
  }
  double total = 0;
  for (std::size_t t = 0; t < terms.size(); ++t)
    if (squares[t] > 0) total += terms[t].scale * terms[t].scale;
  for (std::size_t t = 0; t < terms.size(); ++t) {
    const double rms = std::sqrt(squares[t] / std::max(1., count));
    terms[t].share = terms[t].scale * terms[t].scale / total;
    terms[t].scale = rms > 0 ? terms[t].scale / std::sqrt(total) / rms : 0;
  }
  std::erase_if(terms, [](const DiscrepancyTerm& term) { return !(term.scale > 0); });
}

}  // namespace

Discrepancy::Discrepancy(const PlacedArm& placed, const std::vector<Measurement>& measurements)
    : placed_(placed), terms_(TermMaker(placed.arm, measurements).make()) {
  scaleTerms(placed_, measurements, terms_);
}

std::vector<std::vector<int>> Discrepancy::sources() const {
  std::map<int, std::vector<int>> sources;
  for (std::size_t t = 0; t < terms_.size(); ++t) sources[terms_[t].source].push_back(static_cast<int>(t));
  std::vector<std::vector<int>> lists;
  for (auto& [source, terms] : sources) lists.push_back(std::move(terms));
  return lists;
}

MatrixXd Discrepancy::columnsAt(const std::vector<Measurement>& measurements, const MeasurementWeights& weights) const {
  MatrixXd columns(weights.rows, static_cast<Index>(terms_.size()));
  std::atomic<bool> ok = true;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, measurements.size(), 16), [&](const auto& range) {
    MeasurementPredictor predictor(placed_.arm);
    for (std::size_t k = range.begin(); k != range.end(); ++k) {
      auto motions = motionsOf(predictor, placed_, measurements[k]);
      if (motions.empty()) {
        ok = false;
        return;
      }
      for (Motion& motion : motions) motion.displacements = (weights.whitener[k] * motion.displacements).eval();
      auto rows = columns.middleRows(weights.first_row[k], motions.front().displacements.rows());
      for (std::size_t t = 0; t < terms_.size(); ++t)
        rows.col(static_cast<Index>(t)) = terms_[t].scale * columnOf(motions, terms_[t]);
    }
  });
  if (!ok) return {};
  removeSharedParts(weights, columns);
  return columns;
}

}  // namespace tubeplan::calibration
