// Shell completions and the manual page list all commands and options that the program accepts.
#include "app/commands/command_words.hpp"

#include <algorithm>

#include "app/commands/command_table.hpp"
#include "tests/app/program.hpp"

namespace tubeplan::app {
namespace {

class CommandWordsTest : public ProgramTest {};

TEST_F(CommandWordsTest, EveryOptionOfEveryCommandIsCompleted) {
  for (const char* shell : {"bash", "zsh", "fish"}) {
    const Outcome script = run(std::string("completion ") + shell);
    ASSERT_EQ(script.exit_code, 0) << script.err;
    for (const auto& command : commandWords()) {
      expectSays(script.out, command.name);
      const std::string help = run(command.name + " --help").out;
      for (const auto& option : command.options)
        for (const auto& name : option.names) {
          expectSays(help, name);
          if (!option.is_positional) expectSays(script.out, name.substr(name.find_first_not_of('-')));
        }
    }
  }
  EXPECT_EQ(run("completion tcsh").exit_code, kBadInput);
}

TEST_F(CommandWordsTest, BashTakesItsScriptAndCompletes) {
  (void)write("tubeplan.bash", run("completion bash").out);
  const std::string script = "source " + (folder / "tubeplan.bash").string() +
                             "; COMP_WORDS=(tubeplan diag); COMP_CWORD=1; _tubeplan; echo \"${COMPREPLY[@]}\"; "
                             "COMP_WORDS=(tubeplan pose --jo); COMP_CWORD=2; _tubeplan; echo \"${COMPREPLY[@]}\"";
  (void)write("ask.bash", script);
  const std::string out = (folder / "out.txt").string();
  ASSERT_EQ(std::system(("bash " + (folder / "ask.bash").string() + " > " + out).c_str()), 0);
  EXPECT_EQ(contentOf(out), "diagnose\n--joints\n");
}

TEST_F(CommandWordsTest, TheManualPageHasEveryCommandAndNoStrayRequest) {
  const std::string page = run("man").out;
  EXPECT_TRUE(page.starts_with(".TH TUBEPLAN 1"));
  for (const Command& command : commands()) expectSays(page, ".SS " + std::string(command.name) + "\n");
  expectSays(page, "(default: 8642)");
  std::istringstream lines(page);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with(".")) continue;
    const std::string request = line.substr(1, line.find(' ') == std::string::npos ? line.npos : line.find(' ') - 1);
    EXPECT_TRUE(request == "TH" || request == "SH" || request == "SS" || request == "TP" || request == "PP" ||
                request == "B" || request == "nf" || request == "fi")
        << line;
  }
}

}  // namespace
}  // namespace tubeplan::app
