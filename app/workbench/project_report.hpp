// Report on a saved project: its inputs, its models with their origin and results, and the commands that reproduce the
// results.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/formats/cell/cell_writer.hpp"
#include "app/workbench/session.hpp"

namespace tubeplan::app {

/// Returns the inputs and all models as files in `folder`: measurements.csv (without measurements set aside),
/// model-0.yaml and so on.
[[nodiscard]] std::vector<TextFile> projectFiles(const Session& session, const std::filesystem::path& folder);

struct ProjectReportRequest {
  std::string project;  ///< project file
  std::string files;    ///< folder of projectFiles(), as written in the command lines
  std::string made;     ///< date of the report
};

/// Returns the data of the report page: {title, cell, measurements, facts, verdict?, sentence?, units, models: [...],
/// noise_floor?, history: [...], parameters?: [...], inputs: [{what, name, bytes, sha256}], set_aside?: [...],
/// commands: [...], version, commit}.
[[nodiscard]] nlohmann::json projectReportJson(const Session& session, const ProjectReportRequest& request);

}  // namespace tubeplan::app
