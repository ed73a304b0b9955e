#include <malloc.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <filesystem>
#include <new>
#include <string>
#include <vector>

#include "app/cli/command.hpp"
#include "app/cli/stop_signal.hpp"
#include "app/commands/command_line.hpp"
#include "app/storage/input_error.hpp"
#include "app/studies/job_steps.hpp"

namespace {

/// Reports a failed write to standard output (full disk, or a pipe closed by its reader) and returns the exit code.
int reportLostOutput(int error) {
  std::fprintf(stderr, "tubeplan: standard output: the text cannot be written (%s); check its destination\n",
               std::strerror(error));
  return tubeplan::app::kBadInput;
}

/// Makes malloc keep freed memory: the solver MUMPS allocates and frees several megabytes in each iteration of Ipopt.
void keepFreedMemory() {
  mallopt(M_MMAP_THRESHOLD, 32 << 20);
  mallopt(M_TRIM_THRESHOLD, 256 << 20);
  mallopt(M_TOP_PAD, 16 << 20);
}

/// Ends the program with a message for an exception that no handler catches, such as lack of memory for a new thread in
/// oneTBB's pool. The next run removes partly written files, as after a kill.
[[noreturn]] void endInWords() {
  const std::exception_ptr thrown = std::current_exception();
  if (!thrown) std::abort();
  try {
    std::rethrow_exception(thrown);
  } catch (const std::bad_alloc&) {
    std::fputs("tubeplan: not enough memory\n", stderr);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "tubeplan: internal error: %s\n", error.what());
  } catch (...) {
    std::abort();
  }
  std::_Exit(tubeplan::app::kInternalError);
}

}  // namespace

int main(int argc, char** argv) {
  keepFreedMemory();
  std::set_terminate(endInWords);
  std::signal(SIGPIPE, SIG_IGN);  // report a closed pipe as a write error instead of ending the program
  try {
    const int exit_code = tubeplan::app::runCommandLine(std::vector<std::string>(argv + 1, argv + argc));
    return std::fflush(stdout) == 0 ? exit_code : reportLostOutput(errno);
  } catch (const tubeplan::app::JobStopped& stopped) {
    std::fprintf(stderr, "stopped; %s\n", stopped.kept.empty() ? "nothing was written" : stopped.kept.c_str());
    return tubeplan::app::kStoppedExitCode;
  } catch (const tubeplan::app::InputError& error) {
    std::fprintf(stderr, "tubeplan: %s\n", error.what());
    return tubeplan::app::kBadInput;
  } catch (const std::filesystem::filesystem_error& error) {
    std::fprintf(stderr, "tubeplan: %s\n", tubeplan::app::inputErrorOf(error).what());
    return tubeplan::app::kBadInput;
  } catch (const std::bad_alloc&) {
    std::fprintf(stderr, "tubeplan: not enough memory\n");
    return tubeplan::app::kInternalError;
  } catch (const std::exception& error) {
    if (std::ferror(stdout) != 0 || std::ferror(stderr) != 0) return reportLostOutput(errno);
    std::fprintf(stderr, "tubeplan: internal error: %s\n", error.what());
    return tubeplan::app::kInternalError;
  }
}
