// Request and answer of a campaign. Kinds of campaign are an open table.
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

/// Request as typed, in the cell's units; each kind has its own defaults.
struct CampaignRequest {
  std::string cell, truth;
  std::uint64_t seed = 1;

  // centring
  std::string tubes;                 ///< empty: spread:80
  std::vector<std::string> columns;  ///< meanings of a work list's columns
  int holes = 10;
  std::vector<int> touches = {3};
  std::vector<std::string> choices = {"best"};
  std::vector<double> touch_sigmas;
  std::optional<double> base_shift, base_turn, stiffness, unmodelled, encoder_sigma;

  // diagnosis
  std::string design = "bench", hide = "any";
  int readings = 120;
  double nothing = 0.5;
  int effects = 2;
};

/// Numbers of runs behind the figures.
struct CampaignProgress {
  std::uint64_t runs = 0, done = 0;
};

/// File of results next to campaign.json.
struct CampaignResult {
  std::string name, content;
};

struct Campaign {
  std::unique_ptr<Experiment> experiment;
  PlanKey question;
  std::uint64_t largest_chunk = 1;  ///< maximum number of runs that a worker takes at once
  std::function<nlohmann::json(const CampaignProgress&)> figures;
  std::function<std::string(const nlohmann::json& figures)> text;
  std::function<std::vector<CampaignResult>(const nlohmann::json& figures)> files;
};

struct CampaignKind {
  std::string_view name, summary;
  Campaign (*make)(const CampaignRequest& request);  ///< throws InputError
};
[[nodiscard]] std::span<const CampaignKind> campaignKinds();

// Each is defined in the file of its name.
Campaign makeCentringCampaign(const CampaignRequest& request);
Campaign makeDiagnosisCampaign(const CampaignRequest& request);

}  // namespace tubeplan::app
