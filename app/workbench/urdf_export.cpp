#include "app/workbench/urdf_export.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "app/formats/urdf/urdf_edit.hpp"
#include "app/formats/urdf/urdf_reader.hpp"
#include "app/formats/urdf/urdf_writer.hpp"
#include "app/storage/atomic_file.hpp"
#include "app/storage/input_question.hpp"
#include "app/storage/text_file.hpp"
#include "deflection/effects/constant_effects.hpp"

namespace tubeplan::app {

namespace {

std::string commentsOf(const std::vector<std::string>& remarks) {
  std::string comments;
  for (std::string what : remarks) {
    std::replace(what.begin(), what.end(), '-', ' ');  // a comment may not contain "--"
    comments += fmt::format("<!-- left out: {} -->\n", xmlEscaped(what));
  }
  return comments;
}

/// Returns a new robot with comments beneath its first line.
std::string newRobot(const deflection::Arm& arm, const std::string& reason = "") {
  UrdfText urdf = urdfOf(arm);
  if (!reason.empty()) urdf.left_out.push_back(reason);
  const std::size_t first_line = urdf.text.find('\n') + 1;
  return urdf.text.substr(0, first_line) + commentsOf(urdf.left_out) + urdf.text.substr(first_line);
}

/// Returns true if the arm with this tip leaves the text as it is.
bool isArmOf(const TextFile& urdf, const std::string& tip, const deflection::Arm& arm) {
  try {
    return withArmInUrdf(urdf.text, urdf.path.string(), tip, arm).changed.empty();
  } catch (const InputError&) {
    return false;
  }
}

/// Returns the tip with which the opened arm was imported; empty if the robot has only one tip.
std::string tipOf(const TextFile& urdf, const deflection::Arm& opened) {
  try {
    (void)parseUrdf(urdf.text, urdf.path.string());
  } catch (const InputQuestion& question) {
    for (const auto& tip : question.choice.values)
      if (isArmOf(urdf, tip.value, opened)) return tip.value;
  }
  return "";
}

/// Returns the robot's own text with the arm's numbers, and with comments at its end.
std::string ownRobot(const TextFile& urdf, const Session& session, const deflection::Arm& arm) {
  const std::string tip = tipOf(urdf, session.models.front()->cell.arm);
  const UrdfEdit edit = withArmInUrdf(urdf.text, urdf.path.string(), tip, arm);
  const bool ends_line = edit.text.ends_with('\n') || edit.left_out.empty();
  return edit.text + (ends_line ? "" : "\n") + commentsOf(edit.left_out);
}

}  // namespace

std::string exportedUrdf(const Session& session) {
  const Cell& cell = currentModel(session).cell;
  const deflection::Arm arm = deflection::writeConstantEffects(cell.arm).arm;
  const auto place = urdfPathFor(cell.path);
  if (!std::filesystem::exists(place)) return newRobot(arm);
  try {
    return ownRobot({place, readTextBytes(place.string())}, session, arm);
  } catch (const InputError& error) {
    return newRobot(arm, fmt::format("the other elements of {}: {}", place.filename().string(), error.what()));
  }
}

}  // namespace tubeplan::app
