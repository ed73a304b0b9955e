// Tests of the command `tubeplan serve`.
#include "tests/app/program.hpp"

namespace tubeplan::app {
namespace {

class ServeCommand : public ProgramTest {};

TEST_F(ServeCommand, refusesAnOpenDoorWithoutAToken) {
  const auto outcome = run("serve " + shipped("bench.yaml") + " --host 0.0.0.0 --port 0");
  EXPECT_EQ(outcome.exit_code, 2);
  expectSays(outcome.err, "--token");
  EXPECT_EQ(run("serve " + shipped("bench.yaml") + " --host 0.0.0.0 --token short").exit_code, 2);
  EXPECT_EQ(run("serve missing.yaml").exit_code, 2);
  EXPECT_EQ(run("serve " + shipped("bench.yaml") + " missing.csv").exit_code, 2);
}

TEST_F(ServeCommand, printsItsAddressAndEndsWhenAsked) {
  const std::string command = "cd '" + folder.string() + "' && { '" TUBEPLAN_PROGRAM "' serve " +
                              shipped("bench.yaml") +
                              " --state state --port 0 >address.txt 2>&1 & } && program=$! && for k in $(seq 100); do "
                              "test -s address.txt && break; sleep 0.1; done; kill -TERM $program; wait $program";
  const int status = std::system(command.c_str());
  EXPECT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 0);
  expectSays(contentOf(folder / "address.txt"), "http://127.0.0.1:");
}

}  // namespace
}  // namespace tubeplan::app
