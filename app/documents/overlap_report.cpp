#include "app/documents/overlap_report.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/formats/units.hpp"
#include "calibration/diagnosis/causes/cause.hpp"

namespace tubeplan::app {

namespace {

constexpr std::size_t kMostNamed = 3;
constexpr double kLeastNamedShare = 0.2;  // smallest fraction for which the text names an effect

}  // namespace

nlohmann::json overlapJson(const std::vector<calibration::FormulaOverlap>& overlaps) {
  nlohmann::json json = nlohmann::json::array();
  for (const auto& overlap : overlaps) {
    nlohmann::json effects = nlohmann::json::array();
    for (const auto& share : overlap.shares)
      effects.push_back({{"effect", share.effect}, {"at", share.at}, {"share", rounded(share.share)}});
    json.push_back({{"formula", overlap.formula}, {"absorbed", rounded(overlap.absorbed)}, {"effects", effects}});
  }
  return json;
}

std::string overlapText(const std::vector<calibration::FormulaOverlap>& overlaps) {
  std::string text;
  for (const auto& overlap : overlaps) {
    text +=
        fmt::format("{}: {:.0f} % of its effect on these readings can be reproduced by the other fitted parameters\n",
                    overlap.formula, 100 * overlap.absorbed);
    for (std::size_t k = 0; k < std::min(kMostNamed, overlap.shares.size()); ++k) {
      const auto& share = overlap.shares[k];
      if (share.share >= kLeastNamedShare)
        text += fmt::format("  {:.0f} % of the rest is {}\n", 100 * share.share,
                            calibration::causeTitle(share.effect, share.at));
    }
  }
  return text;
}

}  // namespace tubeplan::app
