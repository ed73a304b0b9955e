// Routes for files of the opened folder: opening and saving of cells and projects.
#include <fmt/format.h>

#include "app/formats/cell/cell_places.hpp"
#include "app/formats/urdf/urdf_import.hpp"
#include "app/storage/atomic_file.hpp"
#include "app/storage/input_error.hpp"
#include "app/storage/text_file.hpp"
#include "app/workbench/project.hpp"
#include "app/workbench/request_body.hpp"
#include "app/workbench/routes.hpp"
#include "app/workbench/state_json.hpp"
#include "app/workbench/urdf_export.hpp"

namespace tubeplan::app {

namespace {

/// Returns the names of the folder's YAML files that name an arm. Faulty cell files are included; opening them reports
/// the fault.
std::vector<std::string> cellNames(const OpenedFolder& folder) {
  auto names = folder.names(".yaml");
  std::erase_if(names, [&](const std::string& name) { return !isCellFile(folder.path() / name); });
  return names;
}

Answer files(Workbench& workbench, const Request&) {
  const OpenedFolder& folder = workbench.folder();
  return answerOf({{"folder", folder.path().string()},
                   {"cells", cellNames(folder)},
                   {"measurements", folder.names(".csv")},
                   {"projects", folder.names(kProjectExtension)},
                   {"recent", workbench.keeper().recent()}});
}

/// Replaces the session by one for another cell or project. Refuses to discard unsaved work without confirmation.
Answer openInstead(Workbench& workbench, const nlohmann::json& body, const std::filesystem::path& path) {
  if (isUnsaved(workbench.session()) && !booleanOf(body, "discard", false))
    return refusal(409, InputError::problem("cell", "the work is not saved as a project",
                                            "save the work first, or confirm that it is to be discarded"));
  Session opened = openCell(path.string(), "");
  opened.saved_revision = opened.revision;
  if (!workbench.replace(std::move(opened)))
    return refusal(409, InputError::problem("cell", "another cell cannot be opened while a job is running",
                                            "wait until the job finishes, or stop it"));
  return answerOf(stateJson(workbench));
}

Answer openCellFile(Workbench& workbench, const Request& request) {
  const auto body = objectOf(request);
  return openInstead(workbench, body, workbench.folder().fileToRead(textOf(body, "file")));
}

/// Opens the project {"file"} in the opened folder, or the kept session {"recent"} in the state folder.
Answer openProject(Workbench& workbench, const Request& request) {
  const auto body = objectOf(request);
  const auto& keeper = workbench.keeper();
  const std::string recent = textOf(body, "recent");
  if (recent.empty()) return openInstead(workbench, body, workbench.folder().fileToRead(textOf(body, "file")));
  if (keeper.folder().empty())
    throw InputError::problem("recent",
                              "the session " + inQuotes(recent) + " is not saved: the server has no state folder",
                              "open a file of the opened folder");
  return openInstead(workbench, body, OpenedFolder(keeper.folder()).fileToRead(recent));
}

Answer saveProject(Workbench& workbench, const Request& request) {
  const auto body = objectOf(request);
  std::string name = textOf(body, "file");
  if (!name.ends_with(kProjectExtension)) name += kProjectExtension;
  const auto place = workbench.folder().fileToWrite(name);
  if (std::filesystem::exists(place) && !booleanOf(body, "overwrite", false))
    return refusal(409, InputError::problem(name, "this file already exists",
                                            "choose another name, or confirm that it is to be replaced"));
  const Session saved = workbench.session();
  writeFileAtomically(place, projectText(saved), "file");
  workbench.change([&](Session& session) {
    session.saved_revision = session.revision == saved.revision ? saved.revision + 1 : saved.revision;
    session.project = name;
    return true;
  });
  return answerOf(stateJson(workbench));
}

/// Returns true if the opened folder has no file in the way of a cell of this name, made of this robot description.
bool isFree(const OpenedFolder& folder, const std::string& cell, const std::string& urdf) {
  const auto own = urdfPathFor(folder.fileToWrite(cell));
  return !std::filesystem::exists(folder.fileToWrite(cell)) &&
         !std::filesystem::exists(armPathFor(folder.path() / cell)) &&
         (!std::filesystem::exists(own) || readTextBytes(own.string()) == urdf);
}

/// Returns a name for a new cell of the opened folder that no other file has: "robot.yaml", or "robot-2.yaml".
std::string freeName(const OpenedFolder& folder, const std::string& stem, const std::string& urdf) {
  std::string name = stem;
  for (int k = 2; !isFree(folder, name + ".yaml", urdf); ++k) name = fmt::format("{}-{}", stem, k);
  return name + ".yaml";
}

/// Returns the name of a file without folder and extension, for the names of the files made of it.
std::string stemOf(const std::string& name) {
  const std::string stem = std::filesystem::path(name).stem().string().substr(0, 100);
  return stem.empty() || stem.front() == '.' ? "robot" : stem;
}

/// Writes an arm and a cell into the opened folder, made of a robot description, with the description itself for a
/// later export, for the request {"name", "text" (URDF), "tip"?}.
Answer importArm(Workbench& workbench, const Request& request) {
  const auto body = objectOf(request);
  const std::string name = textOf(body, "name", "robot.urdf");
  const auto text = requiredOf(body, "text", "the text of the file").get<std::string>();
  const ImportedUrdf imported = importUrdf(text, name, textOf(body, "tip"));
  const std::string cell = freeName(workbench.folder(), stemOf(name), text);
  const auto arm = armPathFor(workbench.folder().path() / cell);
  const auto urdf = urdfPathFor(workbench.folder().path() / cell).filename().string();
  writeFilesTogether({{arm, imported.arm},
                      {workbench.folder().fileToWrite(cell), cellOfUrdf(imported.read, arm.filename().string())},
                      {workbench.folder().fileToWrite(urdf), text}},
                     "file");
  return answerOf({{"written", {cell, arm.filename().string(), urdf}},
                   {"tip", imported.read.tip},
                   {"left_out", imported.read.left_out},
                   {"remarks", imported.read.remarks}});
}

constexpr Route kFileRoutes[] = {
    {"GET", "files", files},
    {"POST", "cell/open", openCellFile},
    {"POST", "arm/import", importArm},
    {"POST", "project/open", openProject},
    {"POST", "project/save", saveProject},
};

}  // namespace

std::span<const Route> fileRoutes() { return kFileRoutes; }

}  // namespace tubeplan::app
