// Tests of mistakes on the command line: the error message is a sentence that names the command or the option.
#include "app/commands/command_line.hpp"

#include <algorithm>

#include "app/commands/command_words.hpp"
#include "tests/app/test_files.hpp"

namespace tubeplan::app {
namespace {

std::string refusal(const std::vector<std::string>& words) {
  return messageOf([&] { (void)runCommandLine(words); });
}

TEST(CommandLine, EveryCommandNamesItsMissingArgument) {
  for (const auto& command : commandWords()) {
    const auto argument =
        std::ranges::find_if(command.options, [](const auto& option) { return option.is_positional; });
    if (argument == command.options.end()) continue;  // the command has no argument that could be missing
    const std::string message = refusal({command.name});
    expectSays(message, command.name + ": " + argument->names.front());
    expectSays(message, "missing; usage: tubeplan " + command.name + " " + argument->names.front());
    expectSays(message, "see `tubeplan " + command.name + " --help`");
    EXPECT_EQ(message.find("is required"), std::string::npos) << message;
    EXPECT_EQ(message.find("words as in"), std::string::npos) << message;
  }
}

TEST(CommandLine, EveryKindOfMistakeIsASentence) {
  const struct {
    std::vector<std::string> words;
    std::string message;
  } mistakes[] = {
      {{"ladder"},
       "ladder: MEASUREMENTS and CELL are missing; usage: tubeplan ladder MEASUREMENTS CELL..., see `tubeplan ladder "
       "--help`"},
      {{"ladder", "m.csv"},
       "ladder: CELL is missing; usage: tubeplan ladder MEASUREMENTS CELL..., see `tubeplan ladder --help`"},
      {{"effects"}, "effects: CELL is missing; usage: tubeplan effects CELL [EFFECT], see `tubeplan effects --help`"},
      {{"pose", "a.yaml"},
       "pose: --joints is missing; usage: tubeplan pose CELL --joints POSTURE, see `tubeplan pose --help`"},
      {{"touches", "a.yaml", "--optimal", "Q"}, "--optimal: found 'Q', expected D, G or V"},
      {{"serve", "a.yaml", "--port", "99999"}, "--port: found 99999, expected 0 to 65535"},
      {{"serve", "a.yaml", "--port", "http"}, "--port: found 'http', expected 0 to 65535"},
      {{"identify", "a.yaml", "m.csv", "--drop", "0.7"}, "--drop: found 0.7, expected 0 to 0.5"},
      {{"identify", "a.yaml", "m.csv", "--sigma", "0"}, "--sigma: found 0, expected a length above zero"},
      {{"identify", "a.yaml", "m.csv", "--seed", "1.5"},
       "--seed: found 1.5, expected a whole number from 0 to 2^64 - 1"},
      {{"score", "a.yaml", "--truth", "b.yaml", "--runs", "5", "--stiffness", "-1"},
       "--stiffness: found -1, expected a number of zero or more"},
      {{"pose", "a.yaml", "--joints=1", "--load", "heavy"}, "--load: found 'heavy', expected a number"},
      {{"touches", "a.yaml", "--loads", "1,b,2"}, "--loads: found 'b', expected a number"},
      {{"simulate", "a.yaml", "--readings", "1.5"}, "--readings: found 1.5, expected a whole number"},
      {{"simulate", "a.yaml", "--readings", "99999999999"},
       "--readings: found 99999999999, expected a whole number of at most 9 digits"},
      {{"pose", "a.yaml", "--joints=1", "--all=maybe"}, "--all: found 'maybe', expected no value; write --all alone"},
      {{"pose", "a.yaml", "--joints=1", "--load"}, "--load: found no value, expected a number"},
      {{"pose", "a.yaml", "--joints"}, "--joints: the value is missing; see `tubeplan pose --help`"},
      {{"pose", "a.yaml", "--joints=1", "--load", "3", "--load=4"},
       "--load: found 2 values, expected one; give the option once"},
      {{"score", "a.yaml", "--truth", "b.yaml", "--unmodelled", "1"},
       "--unmodelled: the option also needs --runs; add --runs, or leave --unmodelled out"},
      {{"map", "a.yaml", "b.yaml", "c.yaml"},
       "map: too many arguments, starting at 'b.yaml'; usage: tubeplan map CELL, see `tubeplan map --help`"},
      {{"plan", "a.yaml", "--tubez=all", "--out", "plan"}, "--tubez: there is no such option; did you mean '--tubes'?"},
      {{"map", "a.yaml", "--frobnicate"}, "--frobnicate: there is no such option; see `tubeplan map --help`"},
      {{"map", "a.yaml", "-q"}, "-q: there is no such option; see `tubeplan map --help`"},
      {{"--frobnicate", "map"},
       "--frobnicate: the command is missing before this option; begin with a command; `tubeplan help` lists the "
       "commands"},
      {{"--frobnicate", "--help"},
       "--frobnicate: the command is missing before this option; begin with a command; `tubeplan help` lists the "
       "commands"},
  };
  for (const auto& [words, message] : mistakes) EXPECT_EQ(refusal(words), message);
}

TEST(CommandLine, AnUnknownOptionComesBeforeOtherMistakes) {
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"plan", "--tubez", "all"},
        {"plan", "a.yaml", "--tubez", "all"},
        {"plan", "a.yaml", "b.yaml", "--tubez", "all", "--out", "plan"},
        {"plan", "a.yaml", "--tubez", "all", "--load", "heavy", "--out", "plan"},
        {"plan", "a.yaml", "--tubez", "all", "--format", "yaml", "--out", "plan"},
        {"plan", "a.yaml", "--tubez", "all", "--out"}})
    expectSays(refusal(words), "--tubez: there is no such option; did you mean '--tubes'?");
}

TEST(CommandLine, AnUnknownCommandIsNamedWithTheKnownOnes) {
  const std::string message = refusal({"mapp"});
  expectSays(message, "COMMAND: found 'mapp', expected pose, map, ");
  expectSays(message, "did you mean 'map'?");
  expectSays(refusal({"help", "frobnicate"}), "see `tubeplan help`");
}

}  // namespace
}  // namespace tubeplan::app
