// Files of unfinished work. The first line has the format, the question, its checksum and that of the content; the
// second line has the results so far as JSON.
#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/formats/checkpoint/plan_key.hpp"

namespace tubeplan::app {

inline constexpr int kLeastShareOfWriting = 20;  ///< minimum ratio of the pause between writes to the time of a write

/// Name of a file format, with the texts of the message for a damaged file.
struct CheckpointFormat {
  const char* name;    ///< name of the format: "tubeplan plan memory 1"
  const char* file;    ///< kind of file: "a file written by tubeplan plan"
  const char* remedy;  ///< advice: "remove it and plan again"
};

struct CheckpointFile {
  PlanKey question;
  std::string checksum, payload;
};

/// Throws InputError for a file that is damaged or another one. `what` is a sentence: "its runs are out of order".
[[noreturn]] void refuseDamaged(const CheckpointFormat& format, const std::filesystem::path& path,
                                const std::string& what);

/// Reads a file. Throws InputError if it cannot be read, has another format or does not match its checksums.
[[nodiscard]] CheckpointFile readCheckpoint(const CheckpointFormat& format, const std::filesystem::path& path);

/// Calls `read` with the file's content. Throws InputError for a damaged file if the content, or a value in it, is not
/// as `read` expects.
void readPayload(const CheckpointFormat& format, const std::filesystem::path& path, const CheckpointFile& file,
                 const std::function<void(const nlohmann::json&)>& read);

[[nodiscard]] std::string checkpointText(const CheckpointFormat& format, const PlanKey& question,
                                         const std::string& payload);

/// Renames work on another question to the first free name beside it (tally.json to tally-1.json), and reports it on
/// standard error with the differences of the questions. Throws InputError if that is not possible.
void putAside(const std::filesystem::path& path, const std::vector<std::string>& differences);

/// Prints a sentence about earlier work, and its use, on standard error.
void say(const std::string& sentence);

}  // namespace tubeplan::app
