#include "app/workbench/live.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>

#include "app/documents/figures.hpp"
#include "app/formats/arm/joint_units.hpp"
#include "app/formats/measurements/measurement_input.hpp"
#include "app/formats/measurements/measurements_reader.hpp"
#include "app/storage/input_error.hpp"
#include "app/workbench/exchange.hpp"
#include "app/workbench/job_routes.hpp"
#include "app/workbench/measurement_sets.hpp"
#include "tubesheets/csv_table.hpp"

namespace tubeplan::app {

namespace {

using nlohmann::json;

constexpr std::size_t kMostTail = 64u << 10;  // bytes read at the end of an encoder log, enough for the last row

void publish(Workbench& workbench, json news) {
  workbench.events().liveMoved(news.dump(-1, ' ', false, json::error_handler_t::replace));
}

json jointsInUnits(const Eigen::VectorXd& q, const Cell& cell) {
  json values = json::array();
  for (Eigen::Index j = 0; j < cell.arm.jointCount(); ++j) {
    const auto& joint = cell.arm.joint(j);
    values.push_back(cell.units.toFile(q[j], jointDimension(joint)));
  }
  return values;
}

std::string firstLine(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string line;
  for (; std::getline(stream, line);)
    if (!tubesheets::trimBlanks(line).empty() && line.front() != '#') break;
  if (line.ends_with('\r')) line.pop_back();
  return line;
}

/// Returns the text without an incomplete last line, which another program may still be writing.
std::string wholeLines(std::string text) {
  text.erase(text.find_last_of('\n') == std::string::npos ? 0 : text.find_last_of('\n') + 1);
  return text;
}

std::string textFrom(const std::filesystem::path& file, std::uintmax_t begin) {
  std::ifstream stream(file, std::ios::binary);
  stream.seekg(static_cast<std::streamoff>(begin));
  std::ostringstream text;
  text << stream.rdbuf();
  return wholeLines(text.str());
}

/// Returns the last row of a table of encoder readings; nullopt if the table has only a header. The row is parsed as a
/// touch in a measurement table, whose joint and load columns have the same names and units.
std::optional<calibration::Measurement> lastRow(const std::filesystem::path& file, const std::string& header,
                                                const Cell& cell) {
  const auto size = std::filesystem::file_size(file);
  std::string text = textFrom(file, size > kMostTail ? size - kMostTail : 0);
  while (!text.empty() && (text.back() == '\n' || text.back() == '\r')) text.pop_back();
  const std::string row = text.substr(text.find_last_of('\n') == std::string::npos ? 0 : text.find_last_of('\n') + 1);
  if (row.empty() || row == header) return std::nullopt;
  return parseMeasurements("id,kind,point," + header + "\nlive,touch,live," + row + "\n", file.string(), cell.arm)
      .front();
}

bool isMeasurementTable(const std::string& header) {
  const auto table = tubesheets::parseCsv(header + "\n");
  return table.find("id") && table.find("kind");
}

}  // namespace

json showEncoders(Workbench& workbench, const Eigen::VectorXd& q, double load, const std::string& source) {
  const Session session = workbench.session();
  const Cell& cell = currentModel(session).cell;
  const auto shape =
      deflection::solveFlexibleKinematics(cell.arm, {q, load, deflection::gravityInBase(cell.arm, cell.X_WB)});
  if (shape.status != deflection::KinematicsStatus::kConverged)
    throw InputError::problem("joints", shape.reason, "choose another posture or a smaller load");
  const json news = {{"joints", jointsInUnits(q, cell)},
                     {"load", cell.units.toFile(load, dimension::kForce)},
                     {"source", source},
                     {"tip", vectorJson(cell.X_WB * deflection::toIsometry(shape.X_BD).translation(), cell.units,
                                        dimension::kLength)}};
  publish(workbench, news);
  return news;
}

void showLiveProblem(Workbench& workbench, const InputError& error, const std::string& source) {
  publish(workbench, {{"source", source}, {"problem", errorJson(error)}});
}

std::size_t takeArrived(Workbench& workbench, const std::string& text, const std::string& name, bool passes_known) {
  const Session session = workbench.session();
  const auto before =
      session.measurements ? session.measurements->measurements : std::vector<calibration::Measurement>();
  auto measurements = parseMeasurementText(text, name, currentModel(session).cell, 0, before);
  return workbench.arrivals().take(std::move(measurements), session.measurements.get(), passes_known);
}

void joinArrived(Workbench& workbench) {
  if (workbench.arrivals().isEmpty() || workbench.jobs().isBusy()) return;
  bool was_diagnosed = false;
  const auto arrived = workbench.arrivals().drain();
  for (bool is_done = false; !is_done;) {  // repeated if the measurements have changed meanwhile
    const Session before = workbench.session();
    const auto joined = joinedSet(before.measurements.get(), arrived, currentModel(before).cell);
    is_done = workbench.change([&](Session& session) {
      if (session.measurements != before.measurements) return false;
      was_diagnosed = findResult(session, "diagnose", currentModel(session).id) != nullptr;
      putMeasurements(session, joined);
      return true;
    });
  }
  (void)beginComparison(workbench, {}, true);
  if (was_diagnosed) (void)beginDiagnosis(workbench, {});
}

void WatchedFile::look(Workbench& workbench) {
  std::error_code error;
  const auto changed = std::filesystem::last_write_time(file_, error);
  const auto size = error ? 0 : std::filesystem::file_size(file_, error);
  if (error || (changed == changed_ && size == size_)) return;
  changed_ = changed;
  size_ = size;
  try {
    take(workbench);
  } catch (const InputError& error) {
    showLiveProblem(workbench, error, file_.filename().string());
  }
}

void WatchedFile::take(Workbench& workbench) {
  const std::string header = firstLine(file_), name = file_.filename().string();
  if (header.empty()) return;
  if (isMeasurementTable(header)) {
    const std::string text = textFrom(file_, 0);
    if (std::count(text.begin(), text.end(), '\n') > 1) (void)takeArrived(workbench, text, name, true);
    return;
  }
  const auto row = lastRow(file_, header, currentModel(workbench.session()).cell);
  if (row) (void)showEncoders(workbench, row->q, row->load, name);
}

}  // namespace tubeplan::app
