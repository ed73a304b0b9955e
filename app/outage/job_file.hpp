// Job file (job.yaml): the work of an outage, as its user writes it.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "app/formats/cell/cell_reader.hpp"
#include "app/formats/units.hpp"
#include "tubesheets/tube.hpp"

namespace tubeplan::app {

/// One leg of a steam generator.
struct JobLeg {
  tubesheets::Leg leg = tubesheets::Leg::kHot;
  std::string cell;          ///< path of the leg's cell, or of the other leg's cell if this leg is its mirror image
  bool is_mirrored = false;  ///< true if the cell is the mirror image of the other leg's cell
};

/// Name of a leg: the steam generator and the side (hot, cold or full).
struct LegName {
  std::string generator;
  tubesheets::Leg leg = tubesheets::Leg::kHot;

  [[nodiscard]] bool operator==(const LegName&) const = default;
};

/// Returns the name as "A/hot".
[[nodiscard]] std::string addressText(const LegName& name);

struct SteamGenerator {
  std::string name;
  std::vector<JobLeg> legs;
  std::string states;  ///< path of a table with the states of tubes, valid for both ends; empty if there is none
};

struct JobTool {
  std::string name;
  double speed = 0;   ///< speed of the probe in the tube [m/s]; 0 if the time in the tube is neglected
  double change = 0;  ///< time to mount the tool [s]
  double load = 0;    ///< weight of the tool at the tip [N]
};

/// Method by which the identity of a tube is confirmed before the tool enters.
enum class ConfirmationMethod { kNone, kReadBack, kPosition };

[[nodiscard]] std::string_view confirmationName(ConfirmationMethod method);

/// One package of work: a selection of tubes, on the given legs of the given steam generators.
struct WorkPackage {
  std::string name;
  std::string tubes;  ///< request in the language of tubesheets/work_list.hpp, or path of a work list
  std::vector<std::string> generators;
  std::vector<tubesheets::Leg> legs;
  std::string tool;    ///< name of the tool
  std::string extent;  ///< extent of the examination, such as "TEH-TEC", as the user names it
  double length = 0;   ///< length of the extent [m]
  double dwell = 0;    ///< time at each tube in addition to the travel of the probe [s]
  ConfirmationMethod confirm = ConfirmationMethod::kReadBack;
};

/// One shift of every day.
struct JobShift {
  std::string name;
  int from = 0, to = 0;  ///< start and end [minutes after midnight]; a shift may end on the next day
};

struct JobFile {
  std::string path, text, name;
  Units units;
  std::vector<SteamGenerator> generators = {};
  std::vector<JobTool> tools = {};
  std::vector<WorkPackage> packages = {};  ///< packages, in order of priority
  std::vector<JobShift> shifts = {};       ///< shifts of the file, and one for each time of day that no shift has
  /// Groups of legs of which at most one has an arm at any time.
  std::vector<std::vector<LegName>> exclusive_legs = {};
  int arms = 1;      ///< number of arms that work at the same time, each in a different leg
  double mount = 0;  ///< time to mount an arm in a leg and calibrate its base [s]

  [[nodiscard]] const JobTool& toolOf(const WorkPackage& package) const;
  /// Returns the package of that name, which must exist.
  [[nodiscard]] const WorkPackage& packageOf(const std::string& wanted) const;
};

/// Reads the cell of a leg, or the mirror image of the other leg's cell.
[[nodiscard]] Cell readCellOf(const JobLeg& leg);

/// Reads a job file. Throws InputError, with file, line and key, for anything that docs/outage.md does not describe,
/// and for shifts that overlap. Paths are relative to the folder of the job file.
[[nodiscard]] JobFile readJobFile(const std::string& path);

/// Returns a sentence on a package whose time in the tubes is zero because only its length, or only the speed of its
/// tool is stated; empty for any other.
[[nodiscard]] std::string untimedText(const WorkPackage& package, const JobFile& job);

/// Parses the text of a job file that was read from `path`.
[[nodiscard]] JobFile parseJobFile(const std::string& text, const std::string& path);

}  // namespace tubeplan::app
