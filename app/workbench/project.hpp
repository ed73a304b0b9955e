// Project file of a session: the cell, every model in the form of its files, readings with those set aside, touches,
// and results. Plans are excluded and are computed again.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/workbench/session.hpp"

namespace tubeplan::app {

inline constexpr const char* kProjectExtension = ".tubeplan";

/// Returns the text of a project file, as readProject() reads it.
[[nodiscard]] std::string projectText(const Session& session);

/// Returns the session of a project file. Files that the cell names besides its arm (hole maps, meshes) are read at
/// their original places. Throws InputError for a file that is no project, is damaged, or names missing files.
[[nodiscard]] Session readProject(const std::filesystem::path& file);

/// Returns {file, cell, readings, models, saved} from the first line alone; null for a file that is no project.
[[nodiscard]] nlohmann::json projectSummary(const std::filesystem::path& file);

/// Returns true if two sessions begin with the same text of the cell and have the same readings.
[[nodiscard]] bool hasSameInputs(const Session& one, const Session& other);

/// Returns true if the session contains anything that its inputs alone do not give.
[[nodiscard]] bool hasWork(const Session& session);

/// Returns true if the session has work that is not saved in a project.
[[nodiscard]] bool isUnsaved(const Session& session);

}  // namespace tubeplan::app
