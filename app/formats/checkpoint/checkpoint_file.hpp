// Files that store the results of unfinished work. The first line has the format, the question (the inputs that
// determine the results), a checksum of the question and a checksum of the results. The second line has the results so
// far as JSON.
#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/formats/checkpoint/plan_key.hpp"

namespace tubeplan::app {

/// Minimum pause between two writes, as a multiple of the duration of a write.
inline constexpr int kLeastShareOfWriting = 20;

/// Name of a checkpoint format, and wording of the message for a damaged file.
struct CheckpointFormat {
  const char* name;    ///< identifier in the file's first line: "tubeplan plan memory 1"
  const char* file;    ///< kind of file in messages: "a file written by tubeplan plan"
  const char* remedy;  ///< advice in messages: "remove it and plan again"
};

struct CheckpointFile {
  PlanKey question;
  std::string checksum, payload;
};

/// Throws InputError for a file that is damaged or has another format. `what` describes the damage in a sentence: "its
/// runs are out of order".
[[noreturn]] void refuseDamaged(const CheckpointFormat& format, const std::filesystem::path& path,
                                const std::string& what);

/// Reads a checkpoint file. Throws InputError if the file cannot be read, has another format or does not match its
/// checksums.
[[nodiscard]] CheckpointFile readCheckpoint(const CheckpointFormat& format, const std::filesystem::path& path);

/// Calls `read` with the file's results. Throws InputError for a damaged file if the results are not JSON, or not in
/// the form that `read` expects.
void readPayload(const CheckpointFormat& format, const std::filesystem::path& path, const CheckpointFile& file,
                 const std::function<void(const nlohmann::json&)>& read);

[[nodiscard]] std::string checkpointText(const CheckpointFormat& format, const PlanKey& question,
                                         const std::string& payload);

/// Renames a file with results for other inputs to the first free name in its folder (tally.json to tally-1.json).
/// Reports the new name and the differences between the inputs on standard error. Throws InputError if the file cannot
/// be renamed.
void putAside(const std::filesystem::path& path, const std::vector<std::string>& differences);

/// Prints a sentence about earlier results, and whether they are used, on standard error.
void printRemark(const std::string& sentence);

}  // namespace tubeplan::app
