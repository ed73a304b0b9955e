// A campaign as it is asked for and as it is answered. Kinds of campaign are an open table.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/formats/checkpoint/plan_key.hpp"
#include "app/studies/monte_carlo/experiment.hpp"

namespace tubeplan::app {

/// As typed, in the cell's units; what is not stated is each kind's own.
struct CampaignRequest {
  std::string cell, truth;
  std::uint64_t seed = 1;

  // centre
  std::string tubes;                 ///< empty: spread:80
  std::vector<std::string> columns;  ///< what those of a work list are
  int holes = 10;
  std::vector<int> touches = {3};
  std::vector<std::string> choices = {"best"};
  std::vector<double> touch_sigmas;
  std::optional<double> base_shift, base_turn, stiffness, unmodelled, encoder_sigma;

  // diagnose
  std::string design = "bench", hide = "any";
  int readings = 120;
  double nothing = 0.5;
  int effects = 2;
};

/// What figures say of the runs behind them.
struct CampaignProgress {
  std::uint64_t runs = 0, done = 0;
};

/// A file of results beside campaign.json.
struct CampaignResult {
  std::string name, content;
};

struct Campaign {
  std::unique_ptr<Experiment> experiment;
  PlanKey question;
  std::uint64_t largest_chunk = 1;  ///< runs that a worker takes at once
  std::function<nlohmann::json(const CampaignProgress&)> figures;
  std::function<std::string(const nlohmann::json& figures)> text;
  std::function<std::vector<CampaignResult>(const nlohmann::json& figures)> files;
};

struct CampaignKind {
  std::string_view name, summary;
  Campaign (*make)(const CampaignRequest& request);  ///< throws InputError
};
[[nodiscard]] std::span<const CampaignKind> campaignKinds();

// Declared here, each defined in the file of its name.
Campaign makeCentringCampaign(const CampaignRequest& request);
Campaign makeDiagnosisCampaign(const CampaignRequest& request);

}  // namespace tubeplan::app
