// Centring campaign: performs the runs, and derives the results from their tally.
#include "app/commands/campaign/centring_figures.hpp"
#include "app/formats/sheet/touch_input.hpp"
#include "app/studies/monte_carlo/tally_experiment.hpp"

namespace tubeplan::app {

namespace {

class CentringExperiment : public TallyExperiment<CentringTally> {
 public:
  explicit CentringExperiment(const CentringTask& task)
      : TallyExperiment(
            CentringTally(task.options.settings.size(), task.holes.visited.size(), task.model.tool.steps.size())),
        trials_(task.model, task.truth, task.holes, task.options) {}

  const CentringTrials& trials() const { return trials_; }

 private:
  bool count(std::uint64_t run, const std::function<bool()>&, CentringTally& tally) const override {
    tally.add(trials_.run(run), run);
    return true;
  }

  CentringTrials trials_;
};

constexpr std::uint64_t kLargestChunk = 256;  // number of runs that takes about a tenth of a second

}  // namespace

Campaign makeCentringCampaign(const CampaignRequest& request) {
  const auto task = std::make_shared<const CentringTask>(centringTask(request));
  auto experiment = std::make_unique<CentringExperiment>(*task);
  (void)requireTouches({{}, experiment->trials().problem()});
  Campaign campaign;
  campaign.question = centringKey(*task, request);
  campaign.largest_chunk = kLargestChunk;
  const CentringExperiment& made = *experiment;
  campaign.figures = [task, request, &made](const CampaignProgress& progress) {
    return centringJson({*task, request, made.trials(), made.tally(), progress});
  };
  campaign.text = centringText;
  campaign.files = [task, request, &made](const nlohmann::json& figures) {
    const CentringResults results{*task, request, made.trials(), made.tally(), {}};
    return std::vector<CampaignResult>{{"holes.csv", holesCsv(results)},
                                       {"report.html", centringPage(results, figures)}};
  };
  campaign.experiment = std::move(experiment);
  return campaign;
}

}  // namespace tubeplan::app
