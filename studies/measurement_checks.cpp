// Study of the checks of measurements: how often the checks name mistakes seeded into clean sets, and how often they
// suspect a mistake in sets without mistakes, including sets with physical effects and sets of real robots.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <map>

#include "app/storage/text_file.hpp"
#include "tests/calibration/measurement_checks/seeded_pairs.hpp"

namespace tubeplan::calibration {
namespace {

namespace fs = std::filesystem;

struct Cost {
  double total = 0, most = 0;  // [s]
  int count = 0;
  void add(double seconds) { total += seconds, most = std::max(most, seconds), ++count; }
};

MeasurementChecks timed(const SeededSet& set, Cost& cost) {
  const auto began = std::chrono::steady_clock::now();
  auto checks = checksOf(set);
  cost.add(std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count());
  return checks;
}

std::string textOf(const MeasurementChecks& checks) {
  std::vector<std::string> texts;
  for (const auto& check : checks.checks)
    texts.push_back(fmt::format("{}{} [{}] {:.4g}->{:.4g} m; equally {}",
                                check.severity == CheckSeverity::kMistake ? "!" : "",
                                check.assume.empty() ? check.name : check.assume, check.sentence, check.error_as_is,
                                check.error_if_corrected, fmt::join(check.equally, " ")));
  return texts.empty() ? "nothing" : fmt::format("{}", fmt::join(texts, " | "));
}

void studyMistakes(int count, bool is_verbose, const std::string& only) {
  const auto& kinds = seededMistakes();
  std::map<std::string, std::array<int, 4>> named;
  Cost cost;
  int made = 0;
  std::array<int, 4> all{};
  for (std::uint64_t number = 0; made < count && number < 20u * static_cast<std::uint64_t>(count); ++number) {
    const auto& kind = kinds[number % kinds.size()];
    if (!only.empty() && std::string(kind.label).find(only) == std::string::npos) continue;
    SeededRandom random(number + 1000);
    std::optional<std::string> correction;
    std::optional<SeededSet> set;
    for (std::uint64_t next = 0; next < 10 && !correction; ++next) {
      set = cleanSet(number / kinds.size() + 7 * (number % kinds.size()) + next);
      if (set) correction = kind.make(*set, random);
    }
    if (!correction) continue;
    ++made;
    const auto checks = timed(*set, cost);
    const Naming naming = judgeNaming(kind, *correction, checks);
    ++named[kind.label][static_cast<std::size_t>(naming)];
    ++all[static_cast<std::size_t>(naming)];
    if (is_verbose && naming != Naming::kRight)
      fmt::print("  {} {}: {} ({}): {}\n",
                 naming == Naming::kWrong    ? "WRONG"
                 : naming == Naming::kMissed ? "MISSED"
                                             : "equally",
                 kind.label, *correction, set->name, textOf(checks));
  }
  fmt::print("{:<24}{:>8}{:>10}{:>8}{:>8}\n", "mistake", "first", "as well", "wrong", "missed");
  for (const auto& [label, counts] : named)
    fmt::print("{:<24}{:>8}{:>10}{:>8}{:>8}\n", label, counts[0], counts[1], counts[2], counts[3]);
  fmt::print("{} mistakes: {:.1f} % named first, {:.1f} % among those that explain the readings as well\n", made,
             100. * all[0] / std::max(1, made), 100. * all[1] / std::max(1, made));
  fmt::print("{:.0f} ms a set, at most {:.0f} ms\n", 1e3 * cost.total / std::max(1, cost.count), 1e3 * cost.most);
}

void studyPairs(int count, std::uint64_t seed, bool is_verbose, const std::string& only) {
  std::array<int, 5> all{};
  std::map<std::string, std::array<int, 5>> of_kind;
  Cost cost;
  int made = 0;
  for (std::uint64_t number = 0; made < count && number < 20u * static_cast<std::uint64_t>(count); ++number) {
    auto pair = seededPair(seed + number);
    if (!pair || (!only.empty() && pair->label.find(only) == std::string::npos)) continue;
    ++made;
    const auto checks = timed(pair->set, cost);
    const auto naming = static_cast<std::size_t>(judgePair(*pair, checks));
    ++all[naming];
    for (const auto& name : pair->corrections) ++of_kind[name.substr(0, name.find('='))][naming];
    if (is_verbose && naming != 0)
      fmt::print("  {} {} ({}): {}\n", kPairNamings[naming], fmt::join(pair->corrections, ","), pair->set.name,
                 textOf(checks));
  }
  fmt::print("{:<24}", "one of the pair");
  for (const char* name : kPairNamings) fmt::print("{:>14}", name);
  fmt::print("\n");
  for (const auto& [kind, counts] : of_kind)
    fmt::print("{:<24}{:>14}\n", kind, fmt::join(counts, fmt::format("{:>12}", "")));
  fmt::print("{} pairs:", made);
  for (std::size_t k = 0; k < all.size(); ++k)
    fmt::print(" {} {} ({:.1f} %)", kPairNamings[k], all[k], 100. * all[k] / std::max(1, made));
  fmt::print("\n");
  fmt::print("{:.0f} ms a set, at most {:.0f} ms\n", 1e3 * cost.total / std::max(1, cost.count), 1e3 * cost.most);
}

std::optional<SeededSet> setOfFiles(const fs::path& cell, const fs::path& measurement_file) {
  SeededSet set{measurement_file.string(), app::readCell(cell.string()), {}};
  set.table = app::parseMeasurementTable(app::readTextFile(measurement_file.string()), measurement_file.string(),
                                         set.cell.arm, set.cell.sheet ? &*set.cell.sheet : nullptr);
  app::stateSigma(set.table.measurements, set.cell, set.name, 0);
  return set;
}

void studyFiles(const fs::path& cell, const fs::path& measurement_file) {
  Cost cost;
  const auto checks = timed(*setOfFiles(cell, measurement_file), cost);
  fmt::print("{}\n{:.0f} ms\n", textOf(checks), 1e3 * cost.most);
}

std::vector<SeededSet> recordedSets() {
  const fs::path shared = fs::path(TUBEPLAN_SOURCE_DIR) / "../shared";
  std::vector<SeededSet> sets;
  if (!fs::exists(shared)) {
    fmt::print("no sets of real robots beside the project: simulated ones alone\n");
    return sets;
  }
  for (const auto& entry : fs::directory_iterator(shared / "hidden-effects")) {
    const std::string name = entry.path().filename().string();
    sets.push_back(*setOfFiles(
        fs::path(TUBEPLAN_SOURCE_DIR) / "app/cells" / (name.starts_with("bench") ? "bench.yaml" : "bowl.yaml"),
        entry.path() / "measurements.csv"));
  }
  static constexpr std::pair<const char*, const char*> kReal[] = {
      {"hilti/cell.yaml", "hilti/measurements.csv"},
      {"irb120/cell.yaml", "irb120/measurements.csv"},
      {"justin-right/cell.yaml", "justin-right/measurements.csv"},
      {"justin-right/cell-assumed-weights.yaml", "justin-right/measurements.csv"},
      {"kuka-iiwa7/cell.yaml", "kuka-iiwa7/measurements-allaxes.csv"},
      {"kuka-iiwa7/cell-payload.yaml", "kuka-iiwa7/measurements-payload.csv"},
      {"motoman/cell.yaml", "motoman/measurements.csv"},
      {"motoman/cell-left.yaml", "motoman/measurements-left.csv"},
      {"motoman/cell-wide.yaml", "motoman/measurements-wide.csv"},
      {"panda-touch/cell.yaml", "panda-touch/measurements.csv"},
      {"ur5/cell.yaml", "ur5/measurements.csv"},
      {"wam/cell.yaml", "wam/measurements.csv"}};
  for (const auto& [cell, measurement_file] : kReal)
    sets.push_back(*setOfFiles(shared / "real" / cell, shared / "real" / measurement_file));
  return sets;
}

/// Looks at `count` sets without a mistake: the recorded ones and those drawn by numbers from `first` on, which, unless
/// it is 0, are looked at alone.
void studyCleanSets(int count, std::uint64_t first, bool is_verbose) {
  Cost cost;
  int made = 0, mistakes = 0, remarks = 0;
  const auto look = [&](const SeededSet& set) {
    ++made;
    const auto checks = timed(set, cost);
    const bool is_mistake = firstMistake(checks) != nullptr;
    const bool is_remark = std::any_of(checks.checks.begin(), checks.checks.end(),
                                       [](const auto& check) { return !check.assume.empty(); });
    mistakes += is_mistake;
    remarks += is_remark && !is_mistake;
    if (is_mistake || is_remark || is_verbose) fmt::print("  {}: {}\n", set.name, textOf(checks));
  };
  if (first == 0)
    for (const auto& set : recordedSets()) look(set);
  for (std::uint64_t number = first; made < count && number < first + 10u * static_cast<std::uint64_t>(count); ++number)
    if (const auto set = hidingSet(number)) look(*set);
  fmt::print(
      "{} sets without a mistake: {} ({:.1f} %) suspected of one, {} more with a remark that proposes something\n",
      made, mistakes, 100. * mistakes / std::max(1, made), remarks);
  fmt::print("{:.0f} ms a set, at most {:.0f} ms\n", 1e3 * cost.total / std::max(1, cost.count), 1e3 * cost.most);
}

}  // namespace
}  // namespace tubeplan::calibration

int main(int argc, char** argv) {
  CLI::App cli{"Mistakes named, and mistakes suspected where there are none"};
  int mistakes = 500, pairs = 500, clean = 300;
  std::uint64_t seed = 1, first_clean = 0;
  bool is_verbose = false;
  std::string only;
  std::vector<std::string> files;
  cli.add_option("--mistakes", mistakes, "seeded mistakes to name");
  cli.add_option("--pairs", pairs, "pairs of seeded mistakes to name");
  cli.add_option("--seed", seed, "of the first pair");
  cli.add_option("--files", files, "a cell and its readings, to be told of alone")->expected(2);
  cli.add_option("--clean", clean, "sets without a mistake");
  cli.add_option("--first-clean", first_clean, "number of the first drawn set without a mistake; recorded ones with 0");
  cli.add_option("--only", only, "mistakes whose label holds this");
  cli.add_flag("--verbose", is_verbose, "what was not named first, and what clean sets are told");
  CLI11_PARSE(cli, argc, argv);
  if (!files.empty()) {
    tubeplan::calibration::studyFiles(files[0], files[1]);
    return 0;
  }
  if (pairs > 0) tubeplan::calibration::studyPairs(pairs, seed, is_verbose, only);
  if (mistakes > 0) tubeplan::calibration::studyMistakes(mistakes, is_verbose, only);
  if (clean > 0) tubeplan::calibration::studyCleanSets(clean, first_clean, is_verbose);
  return 0;
}
