// Files that work is kept in until it goes on: a first line with the format, the question that was asked, its checksum
// and that of what follows; then one line of JSON with what is done.
#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/formats/checkpoint/plan_key.hpp"

namespace tubeplan::app {

inline constexpr int kLeastShareOfWriting = 20;  ///< pauses are so many times as long as a write

/// What kind of file it is, and the words for one that is damaged.
struct CheckpointFormat {
  const char* name;      ///< "tubeplan plan memory 1"
  const char* expected;  ///< "a file written by tubeplan plan"
  const char* remedy;    ///< "remove it and plan again"
};

struct CheckpointFile {
  PlanKey question;
  std::string checksum, payload;
};

[[noreturn]] void refuseDamaged(const CheckpointFormat& format, const std::filesystem::path& path,
                                const std::string& found);

/// Throws InputError where the file cannot be read, is of another format or does not fit its checksums.
[[nodiscard]] CheckpointFile readCheckpoint(const CheckpointFormat& format, const std::filesystem::path& path);

/// `read` of the file's content; where that meets JSON it cannot use, the file is refused as damaged.
void readPayload(const CheckpointFormat& format, const std::filesystem::path& path, const CheckpointFile& file,
                 const std::function<void(const nlohmann::json&)>& read);

[[nodiscard]] std::string checkpointText(const CheckpointFormat& format, const PlanKey& question,
                                         const std::string& payload);

/// Renames work on another question to the first free name beside it (tally.json to tally-1.json), and says so on
/// standard error with the differences of the question. Throws InputError where that cannot be done.
void putAside(const std::filesystem::path& path, const std::vector<std::string>& differences);

/// On stderr: what was found of earlier work, and what is done with it.
void say(const std::string& sentence);

}  // namespace tubeplan::app
