// Campaign of outages: performs the runs, and derives the results from their tally.
#include "app/commands/campaign/outage_figures.hpp"
#include "app/formats/sheet/touch_input.hpp"

namespace tubeplan::app {

namespace {

class OutageExperiment : public Experiment {
 public:
  explicit OutageExperiment(const OutageTask& task)
      : trials_(task.centring.model, task.centring.truth, task.centring.holes, task.options) {}

  std::optional<TallyWords> run(RunRange runs, const std::function<bool()>& stop) const override {
    OutageTally tally;
    for (std::uint64_t run = runs.first; run < runs.end; ++run) {
      const auto trial = stop() ? std::nullopt : trials_.run(run, stop);
      if (!trial) return std::nullopt;
      tally.add(*trial, run);
    }
    return wordsOfOutages(tally);
  }
  bool add(const TallyWords& tally) override { return total_.merge(tally); }
  std::optional<TallyWords> sum(const TallyWords& a, const TallyWords& b) const override {
    OutageTally tally;
    if (!tally.merge(a) || !tally.merge(b)) return std::nullopt;
    return wordsOfOutages(tally);
  }
  TallyWords total() const override { return wordsOfOutages(total_); }

  const OutageTrials& trials() const { return trials_; }
  const OutageTally& tally() const { return total_; }

 private:
  static TallyWords wordsOfOutages(const OutageTally& tally) {
    TallyWords words;
    tally.put(words);
    return words;
  }

  OutageTrials trials_;
  OutageTally total_;
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
  campaign.files = [](const nlohmann::json& figures) {
    return std::vector<CampaignResult>{{"changes.csv", changesCsv(figures)}};
  };
  campaign.experiment = std::move(experiment);
  return campaign;
}

}  // namespace tubeplan::app
