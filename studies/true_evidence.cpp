// Study that compares the evidence of the model of the truly hidden effects, fitted from their true sizes, with that of
// the models that the diagnosis finds. The comparison shows whether a miss is due to the search or to the measurements.
// The output is JSON for studies/blind_trial/oracle.py.
#include <CLI/CLI.hpp>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/formats/cell/effects_reader.hpp"
#include "app/formats/measurements/measurement_input.hpp"
#include "app/jobs/diagnosis.hpp"
#include "app/studies/model/cell_fit.hpp"

namespace {

using namespace tubeplan;
using calibration::Explanation;
using nlohmann::json;

json modelJson(const Explanation& explanation) {
  json names = json::array();
  for (const auto& effect : explanation.effects) {
    json indistinguishable = json::array({effect.effect + "@" + effect.at});
    for (const auto& [name, at] : effect.indistinguishable) indistinguishable.push_back(name + "@" + at);
    names.push_back(indistinguishable);
  }
  return {{"effects", names},
          {"log_weight", -explanation.criterion / 2},
          {"chi2", explanation.chi2},
          {"probability", explanation.probability},
          {"remainder", explanation.remainder_probability}};
}

json listJson(const std::vector<Explanation>& explanations) {
  json list = json::array();
  for (const auto& explanation : explanations) list.push_back(modelJson(explanation));
  return list;
}

int run(const std::string& cell_file, const std::string& measurements_file, const std::vector<std::string>& hidden) {
  const app::Cell cell = app::readCell(cell_file);
  const auto measurements = app::readMeasurements(measurements_file, cell);
  const auto diagnosis = app::diagnoseMeasurements(cell, measurements, {});
  auto used = measurements;
  for (auto at = diagnosis.set_aside.rbegin(); at != diagnosis.set_aside.rend(); ++at) used.erase(used.begin() + *at);
  std::vector<deflection::Effect> effects;
  for (const auto& text : hidden) effects.push_back(app::parseEffect(text, cell.arm, cell.units, "hidden").effect);
  calibration::DiagnosisOptions options;
  options.baseline.free = app::freeNumbersOf(cell);
  std::vector<std::vector<deflection::Effect>> requested;
  if (!effects.empty()) requested.push_back(effects);
  const auto models = calibration::competingExplanations(app::startOf(cell, used), used, options, requested);
  json out{{"verdict", calibration::nameOf(diagnosis.verdict)},
           {"nothing", diagnosis.nothing_probability},
           {"unknown", diagnosis.unknown_probability},
           {"scatter", diagnosis.scatter_probability},
           {"degrees_of_freedom", diagnosis.degrees_of_freedom},
           {"set_aside", diagnosis.set_aside.size()},
           {"alternatives", listJson(diagnosis.alternatives)},
           {"found", listJson(models.found)},
           {"truth", listJson(models.requested)}};
  std::cout << out.dump() << "\n";
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App cli("the evidence of what is hidden beside that of what is found");
  std::string cell, measurements;
  std::vector<std::string> hidden;
  cli.add_option("cell", cell)->required();
  cli.add_option("readings", measurements)->required();
  cli.add_option("hidden", hidden, "EFFECT@AT or EFFECT@AT:NUMBER=VALUE");
  CLI11_PARSE(cli, argc, argv);
  return run(cell, measurements, hidden);
}
