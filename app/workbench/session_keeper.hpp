// Storage of the session in a file of the state folder after every change, so that work continues after a crash of the
// program or the machine.
#pragma once

#include <cstdint>
#include <filesystem>
#include <mutex>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "app/storage/staged_files.hpp"
#include "app/workbench/session.hpp"

namespace tubeplan::app {

/// Returns the default folder of sessions: $XDG_STATE_HOME/tubeplan, otherwise ~/.local/state/tubeplan; empty without a
/// home folder.
[[nodiscard]] std::string defaultStateFolder();

class SessionKeeper {
 public:
  /// Creates `folder`. If the path is empty, no session is stored. Throws InputError if the folder cannot be created.
  explicit SessionKeeper(std::filesystem::path folder);

  /// Returns the session kept for a cell file, unless another program uses it, and stores to the same session file from
  /// now on. An unreadable session file is renamed, with a message on standard error.
  [[nodiscard]] std::optional<Session> begin(const std::string& cell);

  /// Renames the session file found by begin(), so that the user can still open it.
  void putAside();

  /// Writes the session to disk before returning, unless a later revision is already written. A failure is reported
  /// once on standard error and in problem().
  void keep(const Session& session);

  /// Returns the reason why sessions are not kept; empty if they are kept.
  [[nodiscard]] std::string problem() const;

  /// Returns the sessions in the folder, newest first, each as projectSummary() returns it; at most twenty.
  [[nodiscard]] nlohmann::json recent() const;

  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
  [[nodiscard]] std::filesystem::path file() const;

 private:
  std::filesystem::path folder_, file_;
  FileLock lock_;  ///< lock file next to the session file
  mutable std::mutex mutex_;
  std::uint64_t kept_ = 0;  ///< revision of the session written last
  std::string problem_;
};

}  // namespace tubeplan::app
