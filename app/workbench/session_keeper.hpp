// Keeps the situation in a file of the state folder after every change, so that a program that is killed, or a machine
// that stops, loses nothing: the next one takes it up.
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

/// Where sessions are kept unless something else is asked for: $XDG_STATE_HOME/tubeplan, ~/.local/state/tubeplan.
[[nodiscard]] std::string defaultStateFolder();

class SessionKeeper {
 public:
  /// `folder` is made; empty: nothing is kept. Throws InputError where it cannot be.
  explicit SessionKeeper(std::filesystem::path folder);

  /// The session kept of this cell's file, where there is one that no other program works on; from now on that file is
  /// kept. One that cannot be read is put aside with a word on standard error.
  [[nodiscard]] std::optional<Session> begin(const std::string& cell);

  /// What begin() found is put aside under another name, to be opened by hand.
  void putAside();

  /// Writes the situation unless a later one is already written. Whoever returns knows it written; a failure is
  /// reported once on standard error and in problem().
  void keep(const Session& session);

  /// Why nothing is kept; empty where it is.
  [[nodiscard]] std::string problem() const;

  /// Sessions in the folder, newest first, as projectSummary; at most twenty.
  [[nodiscard]] nlohmann::json recent() const;

  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
  [[nodiscard]] std::filesystem::path file() const;

 private:
  std::filesystem::path folder_, file_;
  FileLock lock_;  ///< beside the file
  mutable std::mutex mutex_;
  std::uint64_t kept_ = 0;  ///< revision
  std::string problem_;
};

}  // namespace tubeplan::app
