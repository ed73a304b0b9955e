#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <string>
#include <vector>

#include "app/cli/command.hpp"
#include "app/cli/command_line.hpp"
#include "app/cli/stop_signal.hpp"
#include "app/files/input_error.hpp"
#include "app/studies/job_steps.hpp"

int main(int argc, char** argv) {
  try {
    const int exit_code = tubeplan::app::runCommandLine(std::vector<std::string>(argv + 1, argv + argc));
    if (std::fflush(stdout) != 0)
      throw tubeplan::app::InputError("standard output", std::strerror(errno), "a place that can be written");
    return exit_code;
  } catch (const tubeplan::app::JobStopped& stopped) {
    std::fprintf(stderr, "stopped; %s\n", stopped.kept.empty() ? "nothing was written" : stopped.kept.c_str());
    return tubeplan::app::kStoppedExitCode;
  } catch (const tubeplan::app::InputError& error) {
    std::fprintf(stderr, "tubeplan: %s\n", error.what());
    return tubeplan::app::kBadInput;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "tubeplan: internal error: %s\n", error.what());
    return tubeplan::app::kInternalError;
  }
}
