// tubeplan improve: diagnose, add, identify, until nothing more is shown.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/atomic_file.hpp"
#include "app/command.hpp"
#include "app/command_inputs.hpp"
#include "app/diagnosis_json.hpp"
#include "app/input_error.hpp"
#include "app/ladder.hpp"
#include "app/readers/cell_writer.hpp"
#include "app/readers/measurements_reader.hpp"
#include "app/reading_input.hpp"

namespace tubeplan::app {

namespace {

using calibration::Diagnosis, calibration::Explanation, calibration::Verdict;

struct ImproveOptions {
  std::string cell, measurements, out, json;
  double sigma = 0;
  int steps = 6;
  std::uint64_t seed = 1;
};

constexpr double kWorthIt = 0.95;  // of the held-out error: what an effect must at least bring it down to

/// What a diagnosis says to add: its explanation; where none is enough, the closest if it is worth it on readings kept
/// out. Nothing otherwise.
const Explanation* worthAdding(const Diagnosis& diagnosis) {
  if (!diagnosis.alternatives.empty()) return &diagnosis.alternatives.front();
  if (diagnosis.verdict != Verdict::kUnexplained || diagnosis.closest.empty()) return nullptr;
  const Explanation& closest = diagnosis.closest.front();
  return closest.heldout.rms < kWorthIt * diagnosis.heldout_before.rms ? &closest : nullptr;
}

/// One round of the loop as it went.
struct Step {
  Verdict verdict = Verdict::kNotRun;
  std::string sentence;
  std::vector<std::string> added;
};

struct Improvement {
  Cell cell;
  std::vector<Step> steps;
  std::vector<Rung> rungs;
  calibration::Identification last;
};

calibration::Identification fitOf(const Cell& cell, const std::vector<calibration::Measurement>& readings,
                                  std::uint64_t seed) {
  calibration::IdentificationOptions options;
  options.free = {cell.identify, !cell.base_known};
  options.seed = seed;
  return calibration::identify(cell.arm, cell.X_WB, cell.base_known, readings, options);
}

Improvement improve(const ImproveOptions& options, const std::vector<calibration::Measurement>& readings, Cell cell) {
  Improvement result{std::move(cell), {}, {}, {}};
  result.last = fitOf(result.cell, readings, options.seed);
  result.rungs.push_back(rungOf("as given", result.last));
  for (int step = 0; step < options.steps; ++step) {
    calibration::DiagnosisOptions diagnosis_options;
    diagnosis_options.baseline.free = {result.cell.identify, !result.cell.base_known};
    diagnosis_options.seed = options.seed;
    const auto start =
        calibration::placeForReadings(result.cell.arm, result.cell.X_WB, result.cell.base_known, readings);
    const Diagnosis diagnosis = calibration::diagnose(start, readings, diagnosis_options);
    result.steps.push_back({diagnosis.verdict, diagnosisSentence(diagnosis, result.cell.units), {}});
    const Explanation* explanation = worthAdding(diagnosis);
    if (!explanation) break;
    for (const auto& effect : explanation->effects) {
      result.cell.arm.effects.push_back(effect.fitted);
      for (const auto& name : freedNames(result.cell.arm, effect.fitted)) result.cell.identify.push_back(name);
      result.steps.back().added.push_back(effect.effect + "@" + effect.at);
    }
    result.last = fitOf(result.cell, readings, options.seed);
    result.rungs.push_back(rungOf(fmt::format("+ {}", fmt::join(result.steps.back().added, " + ")), result.last));
  }
  return result;
}

nlohmann::json improvementJson(const Improvement& result) {
  nlohmann::json json = ladderJson(result.rungs, result.cell.units);
  json["steps"] = nlohmann::json::array();
  for (const auto& step : result.steps)
    json["steps"].push_back({{"verdict", nameOf(step.verdict)}, {"sentence", step.sentence}, {"added", step.added}});
  return json;
}

int run(const ImproveOptions& options) {
  const Cell cell = readCell(options.cell);
  auto readings = readMeasurements(options.measurements, cell.arm, cell.sheet ? &*cell.sheet : nullptr);
  stateSigma(readings, cell, options.measurements, options.sigma);
  requireDefinedFormulas(readings, cell, options.measurements);
  checkJsonTarget(options.json);
  checkWritableFile(options.out, "--out");
  const auto result = improve(options, readings, cell);
  if (result.last.status == calibration::IdentificationStatus::kRefused)
    throw InputError(options.measurements, result.last.reason, "readings that tell the free parameters", "");
  for (const auto& file : improvedCell(cell, result.cell, result.last, options.out))
    writeFileAtomically(file.path, file.text, "--out");
  writeJson(options.json, improvementJson(result));
  if (!printsText(options.json)) return kDone;
  for (std::size_t k = 0; k < result.steps.size(); ++k)
    fmt::print("step {}: {}: {}\n", k + 1, nameOf(result.steps[k].verdict), result.steps[k].sentence);
  fmt::print("{}wrote {}\n", ladderText(result.rungs, result.cell.units), options.out);
  return kDone;
}

}  // namespace

Run configureImprove(CLI::App& cli) {
  const auto options = std::make_shared<ImproveOptions>();
  cli.add_option("CELL", options->cell, "the cell file")->required();
  cli.add_option("MEASUREMENTS", options->measurements, "readings of any kind (CSV)")->required();
  cli.add_option("--out", options->out, "write the improved cell to this file, its arm beside it")->required();
  cli.add_option("--steps", options->steps, "the most rounds of diagnosing and adding")->check(CLI::Range(1, 20));
  cli.add_option("--sigma", options->sigma, "noise of a coordinate where the file states none");
  cli.add_option("--seed", options->seed, "seed of the simulated noise and the folds");
  cli.add_option("--json", options->json, "write the figures as JSON to this file, or - for standard output");
  return [options] { return run(*options); };
}

}  // namespace tubeplan::app
