// Campaign of outages: performs the runs, and derives the results from their tally.
#include "app/commands/campaign/outage_figures.hpp"
#include "app/formats/sheet/touch_input.hpp"
#include "app/report/campaign_report.hpp"
#include "app/studies/monte_carlo/tally_experiment.hpp"

namespace tubeplan::app {

namespace {

class OutageExperiment : public TallyExperiment<OutageTally> {
 public:
  explicit OutageExperiment(const OutageTask& task)
      : TallyExperiment(OutageTally()),
        trials_(task.centring.model, task.centring.truth, task.centring.holes, task.options) {}

  const OutageTrials& trials() const { return trials_; }

 private:
  bool count(std::uint64_t run, const std::function<bool()>& stop, OutageTally& tally) const override {
    const auto trial = trials_.run(run, stop);
    if (trial) tally.add(*trial, run);
    return trial.has_value();
  }

  OutageTrials trials_;
};

}  // namespace

Campaign makeOutageCampaign(const CampaignRequest& request) {
  const auto task = std::make_shared<const OutageTask>(outageTask(request));
  auto experiment = std::make_unique<OutageExperiment>(*task);
  (void)requireTouches({{}, experiment->trials().problem()});
  const OutageExperiment& made = *experiment;
  Campaign campaign;
  campaign.question = outageKey(*task, request);
  campaign.largest_chunk = 1;  // single runs, because a run takes seconds
  campaign.figures = [task, request, &made](const CampaignProgress& progress) {
    return outageJson(*task, request, made.tally(), progress);
  };
  campaign.text = outageText;
  campaign.files = [task](const nlohmann::json& figures) {
    nlohmann::json page = figures;
    page["title"] = "Watched outages of " + task->centring.cell.name;
    return std::vector<CampaignResult>{{"changes.csv", changesCsv(figures)},
                                       {"report.html", renderCampaignReport(page)}};
  };
  campaign.experiment = std::move(experiment);
  return campaign;
}

}  // namespace tubeplan::app
