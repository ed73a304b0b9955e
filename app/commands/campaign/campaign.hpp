// Request and results of a campaign (many simulated runs with random true arms), and the table of campaign kinds.
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

/// Request as given on the command line, in the cell's units. Each kind of campaign uses only some of the members.
struct CampaignRequest {
  std::string cell, truth;
  std::uint64_t seed = 1;

  // Options of campaigns of kinds `centre` and `outage`.
  std::string tubes;                 ///< selection or work list; the default is spread:80
  std::vector<std::string> columns;  ///< meanings of the work list's columns
  std::vector<int> touches = {3};
  std::vector<std::string> choices = {"best"};
  std::vector<double> touch_sigmas;
  std::optional<double> base_shift, base_turn, stiffness, unmodelled, encoder_sigma;

  int holes = 10;  // of kind `centre`

  // Options of campaigns of kind `outage`.
  int visits = 200, touch_every = 50;

  // Options of campaigns of kinds `diagnose` and `outage`.
  std::string hide = "any";
  double nothing = 0.5;

  // Options of campaigns of kind `diagnose`.
  std::string design = "bench";
  int measurements = 120, effects = 2;
};

/// Progress of a campaign: number of runs requested, and number completed so far.
struct CampaignProgress {
  std::uint64_t runs = 0, done = 0;
};

/// A results file to be written next to campaign.json.
struct CampaignResult {
  std::string name, content;
};

struct Campaign {
  std::unique_ptr<Experiment> experiment;
  PlanKey question;
  std::uint64_t largest_chunk = 1;  ///< largest number of runs given to a worker at once
  std::function<nlohmann::json(const CampaignProgress&)> figures;
  std::function<std::string(const nlohmann::json& figures)> text;
  std::function<std::vector<CampaignResult>(const nlohmann::json& figures)> files;
};

struct CampaignKind {
  std::string_view name, summary;
  Campaign (*make)(const CampaignRequest& request);  ///< throws InputError
};
[[nodiscard]] std::span<const CampaignKind> campaignKinds();

// Defined in centring_campaign.cpp, diagnosis_campaign.cpp and outage_campaign.cpp.
Campaign makeCentringCampaign(const CampaignRequest& request);
Campaign makeDiagnosisCampaign(const CampaignRequest& request);
Campaign makeOutageCampaign(const CampaignRequest& request);

}  // namespace tubeplan::app
