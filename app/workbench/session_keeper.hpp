// Storage of the session in a file of the state folder after every change, so that the next program continues after a
// crash of the program or the machine.
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

/// Returns the default folder of sessions: $XDG_STATE_HOME/tubeplan, ~/.local/state/tubeplan.
[[nodiscard]] std::string defaultStateFolder();

class SessionKeeper {
 public:
  /// Creates `folder`; empty: nothing is kept. Throws InputError if it cannot be created.
  explicit SessionKeeper(std::filesystem::path folder);

  /// Returns the session kept for this cell's file, if no other program uses it, and keeps that file from now on. An
  /// unreadable one is renamed, with a message on standard error.
  [[nodiscard]] std::optional<Session> begin(const std::string& cell);

  /// Renames the session file that begin() found, so that it can be opened by hand.
  void putAside();

  /// Writes the session unless a later one is already written. The session is on disk on return; a failure is reported
  /// once on standard error and in problem().
  void keep(const Session& session);

  /// Returns the reason why nothing is kept; empty if sessions are kept.
  [[nodiscard]] std::string problem() const;

  /// Returns sessions in the folder, newest first, each as by projectSummary(); at most twenty.
  [[nodiscard]] nlohmann::json recent() const;

  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
  [[nodiscard]] std::filesystem::path file() const;

 private:
  std::filesystem::path folder_, file_;
  FileLock lock_;  ///< next to the session's file
  mutable std::mutex mutex_;
  std::uint64_t kept_ = 0;  ///< last revision written
  std::string problem_;
};

}  // namespace tubeplan::app
