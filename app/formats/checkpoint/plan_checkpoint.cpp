#include "app/formats/checkpoint/plan_checkpoint.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <nlohmann/json.hpp>

#include "app/formats/checkpoint/checkpoint_file.hpp"
#include "app/formats/checkpoint/plan_cache_json.hpp"
#include "app/storage/atomic_file.hpp"
#include "app/storage/input_error.hpp"

namespace tubeplan::app {

namespace fs = std::filesystem;

namespace {

using nlohmann::json;

constexpr CheckpointFormat kPlanFormat{"tubeplan plan memory 1", "a file written by tubeplan plan",
                                       "remove that file and plan again"};

planner::PlanCache cacheOf(const CheckpointFile& file, const fs::path& path) {
  planner::PlanCache cache;
  readPayload(kPlanFormat, path, file, [&](const json& payload) { cache = cacheFrom(payload); });
  return cache;
}

/// Calls `read`. Throws InputError for a damaged file if the entries are not in the form that is written to it.
void readEntries(const fs::path& path, const std::function<void()>& read) {
  try {
    read();
  } catch (const json::exception&) {
    refuseDamaged(kPlanFormat, path, "the file's content does not have the form that this program writes");
  }
}

/// Returns the tubes whose results are needed: those of the list and, unless few of them remain, those of the earlier
/// plan, from which the bound follows.
std::set<int> tubesToRead(const std::vector<int>& tubes, const std::vector<int>& before) {
  constexpr std::size_t kLittle = 10;
  std::set<int> read(tubes.begin(), tubes.end());
  if (kLittle * tubes.size() >= before.size()) read.insert(before.begin(), before.end());
  return read;
}

bool isThere(const fs::path& path) {
  std::error_code error;
  return fs::exists(path, error);
}

}  // namespace

PlanCheckpoint::PlanCheckpoint(fs::path folder, bool must_resume, const std::string& from)
    : folder_(std::move(folder)), must_resume_(must_resume), from_(from) {
  if (savesProgress()) removeLeftovers(folder_, kProgressFile);
  if (from.empty()) return;
  const fs::path path = fs::path(from) / kCacheFile;
  if (!isThere(path))
    throw InputError::problem("--from", fmt::format("there is no {} in {}", kCacheFile, inQuotes(from)),
                              "give the folder of a completed plan, or plan without --from");
  const CheckpointFile file = readCheckpoint(kPlanFormat, path);
  from_fingerprint_ = file.checksum;
  from_question_ = file.question;
  readEntries(path, [&] { from_text_ = PlanCacheText(file.payload); });
}

std::optional<Eigen::VectorXd> PlanCheckpoint::postureAt(int tube) const {
  if (from_.empty()) return std::nullopt;
  planner::PlanCache known;
  readEntries(fs::path(from_) / kCacheFile, [&] { known = from_text_.read({tube}); });
  const auto& order = known.visiting_order;
  const auto place = static_cast<std::size_t>(std::ranges::find(order, tube) - order.begin());
  if (place >= known.visiting_branches.size() || !known.reach.contains(tube)) return std::nullopt;
  const auto branch = static_cast<std::size_t>(known.visiting_branches[place]);
  const auto& branches = known.reach[tube].branches;
  return branch < branches.size() ? std::optional(branches[branch].q) : std::nullopt;
}

void PlanCheckpoint::begin(const PlanKey& question, const std::vector<int>& tubes) {
  question_ = question;
  if (savesProgress() && takeStopped(question)) return;
  if (must_resume_ && !takeDone(question))
    throw InputError::problem("--resume",
                              fmt::format("there is no stopped plan ({}) in '{}'", kProgressFile, folder_.string()),
                              "give the folder of the stopped plan, or omit --resume to start again");
  if (!must_resume_ && !from_.empty()) takeFrom(question, tubes);
}

bool PlanCheckpoint::takeStopped(const PlanKey& question) {
  const fs::path path = folder_ / kProgressFile;
  if (!isThere(path)) return false;
  const CheckpointFile file = readCheckpoint(kPlanFormat, path);
  const auto differences = findDifferences(file.question, question);
  if (differences.empty()) {
    cache_ = cacheOf(file, path);
    printRemark(fmt::format("continuing from {}: {} are done", path.string(), summary()));
    return true;
  }
  if (must_resume_)
    throw InputError::problem(
        "--resume", fmt::format("the plan in {} was stopped with {}", path.string(), fmt::join(differences, ", ")),
        "repeat the options of the stopped run, or omit --resume to start again");
  putAside(path, differences);
  return false;
}

bool PlanCheckpoint::takeDone(const PlanKey& question) {
  const fs::path path = folder_ / kCacheFile;
  if (!isThere(path)) return false;
  const CheckpointFile file = readCheckpoint(kPlanFormat, path);
  if (!findDifferences(file.question, question).empty()) return false;
  cache_ = cacheOf(file, path);
  printRemark(fmt::format("the plan in {} is complete and is written again", folder_.string()));
  return true;
}

void PlanCheckpoint::takeFrom(const PlanKey& question, const std::vector<int>& tubes) {
  if (partOf(from_question_, "sheet") != partOf(question, "sheet"))
    throw InputError::problem(
        "--from",
        fmt::format("the tube sheet of that plan (fingerprint {}) differs from that of the cell (fingerprint {})",
                    partOf(from_question_, "sheet"), partOf(question, "sheet")),
        "check `leg` and `map` of the cell, or plan without --from");
  const fs::path path = fs::path(from_) / kCacheFile;
  model_differences_ = findModelDifferences(from_question_, question);
  if (!model_differences_.empty()) {
    printRemark(fmt::format("of {} only the order is reused ({}); postures and motions are planned and verified again",
                            from_, fmt::join(model_differences_, ", ")));
    readEntries(path, [&] { cache_.visiting_order = from_text_.visitingOrder(); });
    return;
  }
  text_ = std::move(from_text_);
  if (partOf(from_question_, kEndsPart) != partOf(question, kEndsPart)) text_.dropEnds();
  readEntries(path, [&] { cache_ = text_.read(tubesToRead(tubes, text_.visitingOrder())); });
  cache_.orders.clear();
}

void PlanCheckpoint::saveNowAndThen() {
  if (Clock::now() - saved_ < pause_) return;
  const auto start = Clock::now();
  save();
  pause_ = std::max<Clock::duration>(pause_, kLeastShareOfWriting * (Clock::now() - start));
}

void PlanCheckpoint::save() {
  writeFileAtomically(folder_ / kProgressFile, text(), "--out");
  saved_ = Clock::now();
}

void PlanCheckpoint::discard() {
  std::error_code ignored;
  fs::remove(folder_ / kProgressFile, ignored);
}

std::string PlanCheckpoint::summary() const {
  if (cache_.reach.empty()) return "";
  return fmt::format("the reach of {} tubes, {} travels and {} proofs", cache_.reach.size(), cache_.travels.size(),
                     cache_.proofs.size());
}

std::string PlanCheckpoint::text() const { return checkpointText(kPlanFormat, question_, text_.with(cache_)); }

}  // namespace tubeplan::app
