// Fits and diagnoses interrupted by Ctrl-C end with exit code 130, one line of output and no partial file.
#include <chrono>
#include <csignal>
#include <fstream>
#include <thread>

#include "tests/app/program.hpp"

namespace tubeplan::app {
namespace {

class StoppedCommand : public ProgramTest {
 protected:
  StoppedCommand() {
    EXPECT_EQ(run("simulate " + shipped("bench.yaml") +
                  " --design bench --readings 1500 --seed 3 --hide hysteresis@theta4:0.06deg --out made")
                  .exit_code,
              0);
  }

  /// Returns true if the process handles SIGINT, according to /proc.
  [[nodiscard]] static bool notesInterrupts(pid_t process) {
    std::ifstream status("/proc/" + std::to_string(process) + "/status");
    for (std::string line; std::getline(status, line);)
      if (line.starts_with("SigCgt:")) return (std::stoull(line.substr(7), nullptr, 16) >> (SIGINT - 1)) % 2 == 1;
    return false;
  }

  /// Returns the wait status of the program, which is interrupted as soon as it handles SIGINT.
  [[nodiscard]] int interrupted(const std::string& arguments) const {
    const std::string command =
        "cd '" + folder.string() + "' && exec '" TUBEPLAN_PROGRAM "' " + arguments + " >out.txt 2>err.txt </dev/null";
    const pid_t child = ::fork();
    if (child == 0) {
      ::execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
      ::_exit(127);
    }
    int status = 0;
    while (!notesInterrupts(child)) {
      if (::waitpid(child, &status, WNOHANG) == child) return status;
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    ::kill(child, SIGINT);
    ::waitpid(child, &status, 0);
    return status;
  }
};

TEST_F(StoppedCommand, EndsAtCtrlCWithoutAFile) {
  const std::string on = " " + shipped("bench.yaml") + " made/measurements.csv";
  for (const std::string& arguments :
       {"diagnose" + on + " --json made.json --report made.html", "identify" + on + " --out made.yaml --json made.json",
        "compare" + on + " --json made.json --report made.html", "improve" + on + " --out made.yaml --json made.json",
        "ladder made/measurements.csv " + shipped("bench.yaml") + " --rigid --json made.json"}) {
    int status = interrupted(arguments);
    // A command may finish before the interrupt arrives; the command is then run again.
    for (int again = 0; again < 20 && !(WIFEXITED(status) && WEXITSTATUS(status) == 130); ++again) {
      for (const char* file : {"made.json", "made.html", "made.yaml"}) std::filesystem::remove(folder / file);
      status = interrupted(arguments);
    }
    ASSERT_TRUE(WIFEXITED(status)) << arguments;
    EXPECT_EQ(WEXITSTATUS(status), 130) << arguments << contentOf(folder / "err.txt");
    EXPECT_EQ(contentOf(folder / "err.txt"), "stopped; nothing was written\n") << arguments;
    EXPECT_EQ(contentOf(folder / "out.txt"), "") << arguments;
    for (const char* file : {"made.json", "made.html", "made.yaml"})
      EXPECT_FALSE(std::filesystem::exists(folder / file)) << arguments << " left " << file;
  }
}

}  // namespace
}  // namespace tubeplan::app
