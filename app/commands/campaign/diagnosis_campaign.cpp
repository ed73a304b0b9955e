// Diagnosis campaign: performs the runs, and derives the results from their tally.
#include <fmt/format.h>

#include "app/commands/campaign/campaign.hpp"
#include "app/commands/campaign/campaign_json.hpp"
#include "app/commands/campaign/campaign_options.hpp"
#include "app/commands/campaign/diagnosis_trial.hpp"
#include "app/documents/effect_words_json.hpp"
#include "app/documents/figures.hpp"
#include "app/documents/figures_text.hpp"
#include "app/formats/units_json.hpp"
#include "app/report/campaign_report.hpp"
#include "app/storage/count_text.hpp"
#include "app/storage/input_error.hpp"
#include "app/storage/suggestion.hpp"
#include "app/studies/monte_carlo/tally_experiment.hpp"
#include "deflection/effects/effect.hpp"

namespace tubeplan::app {

namespace {

using nlohmann::json;

constexpr std::size_t kOutcomes = kDiagnosisOutcomes.size();
using OutcomeCounts = std::array<std::uint64_t, kOutcomes>;

/// Numbers of trials, by hidden effect (none first, then in the order of the catalogue), magnitude class and outcome.
class DiagnosisTally {
 public:
  DiagnosisTally() : counts_(deflection::effectKinds().size() + 1) {}

  void add(const DiagnosisTrial& trial) {
    ++counts_[static_cast<std::size_t>(trial.effect + 1)][trial.size_class][static_cast<std::size_t>(trial.outcome)];
  }

  void put(TallyWords& words) const {
    for (const auto& classes : counts_)
      for (const auto& outcomes : classes) words.insert(words.end(), outcomes.begin(), outcomes.end());
  }

  [[nodiscard]] bool merge(const TallyWords& words) {
    WordReader reader(words);
    for (auto& classes : counts_)
      for (auto& outcomes : classes)
        for (auto& count : outcomes) count += reader.next();
    return reader.isWhole();
  }

  /// Returns the outcome counts for one hidden effect (-1 if there is no hidden effect), for one magnitude class or for
  /// all (-1).
  [[nodiscard]] OutcomeCounts of(int effect, int size_class = -1) const {
    OutcomeCounts sum{};
    const auto& classes = counts_[static_cast<std::size_t>(effect + 1)];
    for (std::size_t c = 0; c < kSizeClasses; ++c)
      if (size_class < 0 || static_cast<std::size_t>(size_class) == c)
        for (std::size_t k = 0; k < kOutcomes; ++k) sum[k] += classes[c][k];
    return sum;
  }

 private:
  std::vector<std::array<OutcomeCounts, kSizeClasses>> counts_;
};

struct DiagnosisTask {
  Cell cell;
  DiagnosisTrialOptions options;
  std::vector<int> kinds;
};

class DiagnosisExperiment : public TallyExperiment<DiagnosisTally> {
 public:
  explicit DiagnosisExperiment(const DiagnosisTask& task)
      : TallyExperiment(DiagnosisTally()), trials_(task.cell, task.kinds, task.options) {}

 private:
  bool count(std::uint64_t run, const std::function<bool()>& stop, DiagnosisTally& tally) const override {
    const auto trial = trials_.run(run, stop);
    if (trial) tally.add(*trial);
    return trial.has_value();
  }

  DiagnosisTrials trials_;
};

DiagnosisTask diagnosisTask(const CampaignRequest& request) {
  requireFractionOfNothing(request);
  if (request.effects < 1 || request.effects > 2)
    throw InputError("--effects", std::to_string(request.effects), "1 or 2");
  DiagnosisTask task;
  task.cell = readCell(request.cell);
  task.options.measurements.design = request.design;
  task.options.measurements.measurements = request.measurements;
  task.options.nothing = request.nothing;
  task.options.effects = request.effects;
  task.options.seed = request.seed;
  task.kinds = observableKinds(task.cell, task.options);
  if (request.hide == "any") return task;
  std::vector<std::string> names;
  for (const int kind : task.kinds) {
    names.emplace_back(deflection::effectKinds()[static_cast<std::size_t>(kind)].name);
    if (names.back() != request.hide) continue;
    task.kinds = {kind};
    return task;
  }
  const std::string near = suggestion(request.hide, names);
  names.emplace_back("any");
  throw InputError("--hide", inQuotes(request.hide), alternatives(names), near);
}

PlanKey diagnosisQuestion(const DiagnosisTask& task, const CampaignRequest& request) {
  std::string identify, kinds;
  for (const auto& name : task.cell.identify) identify += name + " ";
  for (const int kind : task.kinds) kinds += fmt::format("{} ", kind);
  const auto& design = prepareSimulation(task.cell, task.options.measurements).design;
  std::string loads;
  for (const double load : design.loads) loads += fmt::format("{} ", load);
  return {{"program", programText()},
          {"kind of campaign", "diagnose"},
          {"arm and scene", modelFingerprint(task.cell)},
          {"base", numbersFingerprint(task.cell.X_WB.matrix())},
          {"list of parameters", fingerprintOf(identify)},
          {"seed", std::to_string(request.seed)},
          {"design", fmt::format("{}, sigma {} m, {} loads, {}", request.design, design.sigma, design.loads.size(),
                                 fingerprintOf(loads))},
          {"number of readings", std::to_string(request.measurements)},
          {"fraction without an effect", fmt::format("{}", request.nothing)},
          {"list of effects", fmt::format("{} effects, {}", task.kinds.size(), fingerprintOf(kinds))},
          {"number of effects in one explanation", std::to_string(request.effects)}};
}

std::uint64_t sumOf(const OutcomeCounts& counts, std::initializer_list<DiagnosisOutcomeKind> outcomes) {
  std::uint64_t sum = 0;
  for (const auto outcome : outcomes) sum += counts[static_cast<std::size_t>(outcome)];
  return sum;
}

std::uint64_t madeOf(const OutcomeCounts& counts) {
  std::uint64_t sum = 0;
  for (std::size_t k = 1; k < kOutcomes; ++k) sum += counts[k];
  return sum;
}

json countsJson(const OutcomeCounts& counts) {
  json named;
  for (std::size_t k = 0; k < kOutcomes; ++k) named[kDiagnosisOutcomes[k]] = counts[k];
  return named;
}

/// Names of the rates in JSON, each with a description. All are fractions of those runs with a hidden effect for which
/// a diagnosis was made.
constexpr std::array<std::pair<const char*, const char*>, 5> kRates{{{"truth_among_answers", "truth among the answers"},
                                                                     {"named", "named alone"},
                                                                     {"wrong", "another named"},
                                                                     {"refused", "refused as unexplained"},
                                                                     {"missed", "not seen"}}};

json ratesJson() {
  json rates = json::array();
  for (const auto& [name, words] : kRates) rates.push_back({{"name", name}, {"words", words}});
  return rates;
}

/// Returns the outcomes in the order of table columns, from the correct answer to runs without a diagnosis.
json outcomesJson() {
  using Kind = DiagnosisOutcomeKind;
  json outcomes = json::array();
  for (const Kind kind : {Kind::kNamed, Kind::kAmong, Kind::kOther, Kind::kUnexplained, Kind::kInconclusive,
                          Kind::kAdequate, Kind::kNotMade}) {
    const auto k = static_cast<std::size_t>(kind);
    outcomes.push_back({{"name", kDiagnosisOutcomes[k]}, {"words", kOutcomeWords[k]}});
  }
  return outcomes;
}

json foundJson(const OutcomeCounts& counts) {
  using Kind = DiagnosisOutcomeKind;
  const std::uint64_t made = madeOf(counts);
  return {{"truth_among_answers", shareJson(sumOf(counts, {Kind::kNamed, Kind::kAmong}), made)},
          {"named", shareJson(sumOf(counts, {Kind::kNamed}), made)},
          {"wrong", shareJson(sumOf(counts, {Kind::kOther}), made)},
          {"refused", shareJson(sumOf(counts, {Kind::kUnexplained}), made)},
          {"missed", shareJson(sumOf(counts, {Kind::kAdequate, Kind::kInconclusive}), made)}};
}

OutcomeCounts hiddenCounts(const DiagnosisTally& tally, int size_class = -1) {
  OutcomeCounts sum{};
  for (std::size_t kind = 0; kind < deflection::effectKinds().size(); ++kind) {
    const auto counts = tally.of(static_cast<int>(kind), size_class);
    for (std::size_t k = 0; k < kOutcomes; ++k) sum[k] += counts[k];
  }
  return sum;
}

json diagnosisFigures(const DiagnosisTask& task, const CampaignRequest& request, const DiagnosisTally& tally,
                      const CampaignProgress& progress) {
  using Kind = DiagnosisOutcomeKind;
  const auto nothing = tally.of(-1);
  json figures = {{"kind", "diagnose"},
                  {"cell", task.cell.name},
                  {"seed", request.seed},
                  {"status", progress.done == progress.runs ? "done" : "stopped"},
                  {"runs", progress.runs},
                  {"runs_done", progress.done},
                  {"units", unitsJson(task.cell.units)},
                  {"design", request.design},
                  {"readings", request.measurements},
                  {"nothing_hidden",
                   {{"outcomes", countsJson(nothing)},
                    {"false_alarms", shareJson(sumOf(nothing, {Kind::kOther, Kind::kUnexplained}), madeOf(nothing))},
                    {"inconclusive", shareJson(sumOf(nothing, {Kind::kInconclusive}), madeOf(nothing))}}},
                  {"hidden", foundJson(hiddenCounts(tally))},
                  {"rates", ratesJson()},
                  {"outcomes", outcomesJson()},
                  {"by_size", json::array()},
                  {"by_effect", json::array()}};
  figures["hidden"]["outcomes"] = countsJson(hiddenCounts(tally));
  for (std::size_t c = 0; c < kSizeClasses; ++c) {
    json entry = foundJson(hiddenCounts(tally, static_cast<int>(c)));
    const auto share = [](std::size_t k) { return std::pow(kLeastShare, 1 - static_cast<double>(k) / kSizeClasses); };
    entry["size"] = {finiteJson(share(c)), finiteJson(share(c + 1))};
    figures["by_size"].push_back(entry);
  }
  for (const int kind : task.kinds) {
    const auto counts = tally.of(kind);
    json entry = foundJson(counts);
    entry["effect"] = deflection::effectKinds()[static_cast<std::size_t>(kind)].name;
    entry["outcomes"] = countsJson(counts);
    addEffectWords(entry["effect"], entry);
    figures["by_effect"].push_back(entry);
  }
  return figures;
}

constexpr std::string_view kShareWords = "{count} of {of}, {value:.1%} % ({low:.1%} to {high:.1%})\n";

/// Returns one line for each of the outcomes "inconclusive" and "not made" that occurred, with the number of runs.
std::string undecidedText(const std::string& hidden, const json& outcomes) {
  std::string text;
  for (const auto kind : {DiagnosisOutcomeKind::kInconclusive, DiagnosisOutcomeKind::kNotMade}) {
    const auto k = static_cast<std::size_t>(kind);
    const auto count = outcomes[std::string(kDiagnosisOutcomes[k])].get<std::uint64_t>();
    if (count > 0) text += fmt::format("{}: {} {}\n", hidden, countText(count, "run"), kOutcomeWords[k]);
  }
  return text;
}

std::string diagnosisCampaignText(const json& figures) {
  const auto& hidden = figures["hidden"];
  std::string text = textOf(figures, "{runs_done} of {runs} run(|s), {readings} reading(|s) of {design} in each\n");
  text += "nothing hidden: false alarms " + textOf(figures["nothing_hidden"]["false_alarms"], kShareWords);
  for (const auto& [key, words] : kRates)
    text += fmt::format("an effect hidden: {:<24}", words) + textOf(hidden[key], kShareWords);
  text += undecidedText("nothing hidden", figures["nothing_hidden"]["outcomes"]);
  text += undecidedText("an effect hidden", hidden["outcomes"]);
  for (const auto& entry : figures["by_size"])
    text += textOf(entry, "  of {size:.2i} of the largest plausible size: truth among the answers ") +
            textOf(entry["truth_among_answers"], kShareWords);
  return text;
}

std::string outcomesCsv(const json& figures) {
  std::string text = "effect";
  for (const auto outcome : kDiagnosisOutcomes) text += fmt::format(",{}", outcome);
  const auto add = [&](const std::string& name, const json& counts) {
    text += "\n" + name;
    for (const auto outcome : kDiagnosisOutcomes)
      text += fmt::format(",{}", counts[std::string(outcome)].get<std::uint64_t>());
  };
  add("nothing", figures["nothing_hidden"]["outcomes"]);
  for (const auto& entry : figures["by_effect"]) add(entry["effect"], entry["outcomes"]);
  return text + "\n";
}

}  // namespace

Campaign makeDiagnosisCampaign(const CampaignRequest& request) {
  const auto task = std::make_shared<const DiagnosisTask>(diagnosisTask(request));
  auto experiment = std::make_unique<DiagnosisExperiment>(*task);
  const DiagnosisExperiment& made = *experiment;
  Campaign campaign;
  campaign.question = diagnosisQuestion(*task, request);
  campaign.largest_chunk = 1;  // single runs, because a run takes seconds
  campaign.figures = [task, request, &made](const CampaignProgress& progress) {
    return diagnosisFigures(*task, request, made.tally(), progress);
  };
  campaign.text = diagnosisCampaignText;
  campaign.files = [task](const json& figures) {
    json page = figures;
    page["title"] = "Diagnoses of " + task->cell.name + " over random true arms";
    return std::vector<CampaignResult>{{"outcomes.csv", outcomesCsv(figures)},
                                       {"report.html", renderCampaignReport(page)}};
  };
  campaign.experiment = std::move(experiment);
  return campaign;
}

}  // namespace tubeplan::app
