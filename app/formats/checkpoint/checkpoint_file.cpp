#include "app/formats/checkpoint/checkpoint_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>

#include "app/storage/input_error.hpp"
#include "app/storage/text_file.hpp"

namespace tubeplan::app {

using nlohmann::json;

namespace {

std::string questionChecksum(const PlanKey& question) { return fingerprintOf(json(question).dump()); }

}  // namespace

void refuseDamaged(const CheckpointFormat& format, const std::filesystem::path& path, const std::string& what) {
  throw InputError::problem(path.string(), fmt::format("{}, so the file is damaged or is not {}", what, format.file),
                            format.remedy);
}

CheckpointFile readCheckpoint(const CheckpointFormat& format, const std::filesystem::path& path) {
  const std::string text = readKeptFile(path.string());
  const std::size_t end = std::min(text.find('\n'), text.size());
  CheckpointFile file;
  file.payload = text.substr(std::min(end + 1, text.size()));
  if (file.payload.ends_with('\n')) file.payload.pop_back();
  try {
    const json head = json::parse(text.substr(0, end));
    if (head.at("format") != format.name)
      refuseDamaged(format, path, "the file has the format " + inQuotes(head.at("format").dump()));
    file.question = head.at("question").get<PlanKey>();
    file.checksum = head.at("checksum");
    // Files of version 0.1 have no checksum of the question.
    if (head.contains("question_checksum") && head.at("question_checksum") != questionChecksum(file.question))
      refuseDamaged(format, path, "the file's first line does not match its checksum");
  } catch (const json::exception&) {
    refuseDamaged(format, path, "the file's first line has no known format");
  }
  if (fingerprintOf(file.payload) != file.checksum)
    refuseDamaged(format, path, "the file's content does not match its checksum");
  return file;
}

void readPayload(const CheckpointFormat& format, const std::filesystem::path& path, const CheckpointFile& file,
                 const std::function<void(const json&)>& read) {
  try {
    read(json::parse(file.payload));
  } catch (const json::exception&) {
    refuseDamaged(format, path, "the file's content does not have the form that this program writes");
  }
}

std::string checkpointText(const CheckpointFormat& format, const PlanKey& question, const std::string& payload) {
  const json head = {{"format", format.name},
                     {"question", question},
                     {"question_checksum", questionChecksum(question)},
                     {"checksum", fingerprintOf(payload)}};
  return head.dump() + "\n" + payload + "\n";
}

void putAside(const std::filesystem::path& path, const std::vector<std::string>& differences) {
  std::filesystem::path aside;
  std::error_code error;
  int number = 0;
  do aside = path.parent_path() / fmt::format("{}-{}{}", path.stem().string(), ++number, path.extension().string());
  while (std::filesystem::exists(aside, error));
  std::filesystem::rename(path, aside, error);
  if (error)
    throw InputError::problem(
        "--out", fmt::format("{} cannot be set aside: renaming the file failed ({})", path.string(), error.message()),
        "choose a folder with write permission");
  printRemark(fmt::format("started again: {} is of {}; it is renamed to {}", path.string(),
                          fmt::join(differences, ", "), aside.filename().string()));
}

void printRemark(const std::string& sentence) { fmt::print(stderr, "{}\n", sentence); }

}  // namespace tubeplan::app
