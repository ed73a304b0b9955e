// A saved project as a report: what it is of, how its models came about with their figures, and how to have them again.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/formats/cell/cell_writer.hpp"
#include "app/workbench/session.hpp"

namespace tubeplan::app {

/// The inputs and every model as files in that folder: measurements.csv (without those set aside), model-0.yaml and so
/// on.
[[nodiscard]] std::vector<TextFile> projectFiles(const Session& session, const std::filesystem::path& folder);

struct ProjectReportRequest {
  std::string project;  ///< file
  std::string files;    ///< the folder of projectFiles(), as the command lines name it
  std::string made;     ///< the date
};

/// What the page shows: {title, facts, verdict?, sentence?, units, ladder: [...], noise_floor, history: [...],
/// parameters: [...], inputs: [{what, name, bytes, sha256}], set_aside: [...], commands: [...], version, commit}.
[[nodiscard]] nlohmann::json projectReportJson(const Session& session, const ProjectReportRequest& request);

}  // namespace tubeplan::app
