// The actions of `tubeplan job`.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/commands/action_options.hpp"
#include "app/commands/figures_target.hpp"
#include "app/outage/hand_over.hpp"
#include "app/outage/job_desk.hpp"

namespace tubeplan::app {

struct JobOptions {
  std::string action, file, tube, out, from, start, csv, mark, read_back, leg, pdf;
  std::vector<double> position;
  EventEntry entry;
  JobPart part;
  HandOverRequest hand_over;
  std::int64_t event = 0, after = -1;
  std::uint64_t seed = 1;
  FiguresTarget figures;
};

/// One action of the command, with the function that runs it.
struct JobAction : ActionOptions {
  int (*run)(const JobOptions&);
};

[[nodiscard]] const std::vector<JobAction>& jobActions();

}  // namespace tubeplan::app
