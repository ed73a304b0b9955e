#include "calibration/identified_numbers.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "calibration/profile_interval.hpp"

namespace tubeplan::calibration {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

namespace {

constexpr double kPoorNormal = 0.2;  // sigma of a compliance over itself from which the normal interval is poor
constexpr double kLeaning = 0.3;     // correlation with a number near its bound that spoils the normal interval

std::string namesOf(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t k = 0; k < names.size(); ++k)
    text += (k == 0 ? "" : k + 1 == names.size() ? " and " : ", ") + names[k];
  return text;
}

std::string noteOf(const IdentifiedNumber& number, bool hardly_gives) {
  if (number.is_at_bound && hardly_gives)
    return "the readings ask for no give at all, or less than none, which no part has: take it as rigid, or look "
           "for a missing effect";
  if (number.is_at_bound) return "at its bound: the readings ask for more than is physical";
  return hardly_gives ? "its compliance is within two sigmas of none: the readings hardly need it" : "";
}

/// Whether the normal interval of a stiffness is poor: it is wide, or made wide by another that can hardly go on in the
/// direction that would make up for it.
bool isNormalPoor(const std::vector<Unknown>& unknowns, const VectorXd& x, const MatrixXd& covariance, Index k) {
  const auto sigma = [&](Index i) { return std::sqrt(covariance(i, i)); };
  if (sigma(k) > kPoorNormal / valueAt(unknowns[static_cast<std::size_t>(k)], x[k])) return true;
  for (Index i = 0; i < x.size(); ++i) {
    const Unknown& other = unknowns[static_cast<std::size_t>(i)];
    const double room = std::min(x[i] - other.lower, other.upper - x[i]);
    if (i != k && room < 2 * sigma(i) && std::abs(covariance(i, k)) > kLeaning * sigma(i) * sigma(k)) return true;
  }
  return false;
}

/// The profile of a kept number; those held that it is tied to may move as well.
ProfileInterval profileOf(const ToldFit& work, const IdentifiedNumber& number, int kept, double sigma, double noise) {
  auto unknowns = work.kept();
  Fit fit = work.fit;
  std::vector<double> x(fit.solution.x.begin(), fit.solution.x.end());
  for (const HeldUnknown& held : work.told.held) {
    const Unknown& unknown = work.unknowns[static_cast<std::size_t>(held.unknown)];
    if (std::count(number.with.begin(), number.with.end(), unknown.name) == 0) continue;
    const bool is_of_arm = unknown.owner == Unknown::Owner::kArm;
    unknowns.push_back(is_of_arm ? rebased(unknown, deflection::findParameter(work.start.arm, unknown.name)->value)
                                 : unknown);
    x.push_back(0);
  }
  fit.solution.x = Eigen::Map<VectorXd>(x.data(), static_cast<Index>(x.size()));
  return profileInterval(work.start, unknowns, work.fitted, fit, kept, sigma, noise, work.options.hooks.stop);
}

}  // namespace

void sayHeld(const ToldFit& work, Identification& result) {
  for (const HeldUnknown& held : work.told.held) {
    auto& number = result.numbers[static_cast<std::size_t>(held.unknown)];
    number.is_held = true;
    const bool is_of_arm = number.unknown.owner == Unknown::Owner::kArm;
    number.value = is_of_arm ? deflection::findParameter(work.start.arm, number.unknown.name)->value : 0;
    const std::string where = number.value == number.unknown.start ? "held at its start" : "held where the fit left it";
    number.told = held.is_seen && !held.with.empty() ? Told::kWith : Told::kNo;
    for (const int other : held.with) {
      number.with.push_back(work.unknowns[static_cast<std::size_t>(other)].name);
      auto& partner = result.numbers[static_cast<std::size_t>(other)];
      if (held.with.size() > 3 || partner.unknown.owner == Unknown::Owner::kBase) continue;
      partner.told = Told::kWith;
      partner.with.push_back(number.unknown.name);
    }
    if (number.told == Told::kNo)
      number.note = "the readings do not depend on it enough to tell it: " + where;
    else
      number.note = "told only in a combination with " + namesOf(number.with) + ": " + where;
  }
}

void sayFitted(const ToldFit& work, Identification& result) {
  const auto kept = work.kept();
  const auto at_bound = atBound(kept, work.fit.solution.x);
  for (std::size_t i = 0; i < work.told.kept.size(); ++i) {
    tell(work.options.hooks, "intervals", i, work.told.kept.size());
    auto& number = result.numbers[static_cast<std::size_t>(work.told.kept[i])];
    const Unknown& unknown = number.unknown;
    const auto k = static_cast<Index>(i);
    const double x = work.fit.solution.x[k];
    const double sigma = std::sqrt(result.covariance(k, k)) * result.widening;
    number.told = number.with.empty() ? Told::kYes : Told::kWith;
    number.value = valueAt(unknown, x);
    number.sigma = sigma * std::abs(slopeAt(unknown, x));
    double lower = x - 1.959964 * sigma, upper = x + 1.959964 * sigma;
    const bool is_compliance = unknown.scale == Unknown::Scale::kCompliance;
    const double give = 1 / number.value;  // of a stiffness: its compliance
    const bool is_tied = !number.with.empty();
    if (work.options.intervals_by_profile && is_compliance &&
        (is_tied ||
         isNormalPoor(kept, work.fit.solution.x, result.covariance * result.widening * result.widening, k))) {
      const auto profile = profileOf(work, number, static_cast<int>(k), sigma, result.widening);
      lower = profile.lower, upper = profile.upper;
      number.is_profile = true;
    }
    std::tie(number.lower, number.upper) = valuesBetween(unknown, lower, upper);
    number.is_at_bound = std::count(at_bound.begin(), at_bound.end(), static_cast<int>(i)) > 0;
    number.note = noteOf(number, is_compliance && give < 2 * sigma);
  }
}

}  // namespace tubeplan::calibration
