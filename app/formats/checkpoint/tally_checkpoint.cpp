#include "app/formats/checkpoint/tally_checkpoint.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>

#include "app/formats/checkpoint/checkpoint_file.hpp"
#include "app/formats/checkpoint/whole_number.hpp"
#include "app/storage/atomic_file.hpp"
#include "app/storage/input_error.hpp"

namespace tubeplan::app {

namespace fs = std::filesystem;

namespace {

using nlohmann::json;

RunSet runsFrom(const json& ranges, const fs::path& path) {
  RunSet set;
  std::uint64_t last = 0;
  for (const auto& range : ranges) {
    const RunRange runs{wholeNumber<std::uint64_t>(range.at(0)), wholeNumber<std::uint64_t>(range.at(1))};
    if (runs.first < last || runs.end <= runs.first)
      refuseDamaged(kTallyFormat, path, "the file's runs are out of order");
    set.insert(runs);
    last = runs.end;
  }
  return set;
}

TallySoFar tallyOf(const CheckpointFile& file, const fs::path& path) {
  TallySoFar tally;
  readPayload(kTallyFormat, path, file, [&](const json& payload) {
    tally.done = runsFrom(payload.at("done"), path);
    tally.total = wholeNumbers<std::uint64_t>(payload.at("total"));
  });
  return tally;
}

std::string tallyText(const PlanKey& question, const TallySoFar& tally) {
  json done = json::array();
  for (const auto& range : tally.done.ranges()) done.push_back({range.first, range.end});
  return checkpointText(kTallyFormat, question, json{{"done", done}, {"total", tally.total}}.dump());
}

}  // namespace

TallyCheckpoint::TallyCheckpoint(fs::path folder, bool must_resume)
    : folder_(std::move(folder)), must_resume_(must_resume) {
  removeLeftovers(folder_, kTallyFile);
}

std::optional<TallySoFar> TallyCheckpoint::begin(const PlanKey& question, std::uint64_t runs) {
  question_ = question;
  std::error_code error;
  if (!fs::exists(path(), error)) {
    if (must_resume_)
      throw InputError::problem("--resume",
                                fmt::format("there is no campaign ({}) in '{}'", kTallyFile, folder_.string()),
                                "give the folder of the campaign, or omit --resume to start again");
    return std::nullopt;
  }
  const CheckpointFile file = readCheckpoint(kTallyFormat, path());
  TallySoFar tally = tallyOf(file, path());
  auto differences = findDifferences(file.question, question);
  const auto& ranges = tally.done.ranges();
  if (!ranges.empty() && ranges.back().end > runs)
    differences.push_back(fmt::format("more runs (up to {}, now {})", ranges.back().end, runs));
  if (differences.empty()) {
    printRemark(fmt::format("continuing from {}: {} of {} runs are done", path().string(), tally.done.size(), runs));
    return tally;
  }
  if (must_resume_)
    throw InputError::problem(
        "--resume", fmt::format("the campaign in {} was run with {}", path().string(), fmt::join(differences, ", ")),
        "repeat the options of that campaign, with at least as many runs, or omit --resume to start again");
  putAside(path(), differences);
  return std::nullopt;
}

void TallyCheckpoint::save(const std::function<TallySoFar()>& tally, bool must) {
  const auto start = Clock::now();
  if (!must && start - saved_ < pause_) return;
  writeFileAtomically(path(), tallyText(question_, tally()), "--out");
  saved_ = Clock::now();
  pause_ = std::max<Clock::duration>(pause_, kLeastShareOfWriting * (saved_ - start));
}

}  // namespace tubeplan::app
