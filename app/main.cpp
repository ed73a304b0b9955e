#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "app/command.hpp"
#include "app/command_line.hpp"
#include "app/input_error.hpp"

int main(int argc, char** argv) {
  try {
    return tubeplan::app::runCommandLine(std::vector<std::string>(argv + 1, argv + argc));
  } catch (const tubeplan::app::InputError& error) {
    std::fprintf(stderr, "tubeplan: %s\n", error.what());
    return tubeplan::app::kBadInput;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "tubeplan: internal error: %s\n", error.what());
    return tubeplan::app::kInternalError;
  }
}
