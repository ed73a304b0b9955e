// Error that the user removes by one choice, such as the link at the tip of a robot with several ends.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "app/storage/input_error.hpp"

namespace tubeplan::app {

/// Choice that a request can name: the key of the request, the label of a field for it, and the values to choose from,
/// the likeliest first.
struct InputChoice {
  struct Value {
    std::string value, words;
  };
  std::string name, label;
  std::vector<Value> values;
};

/// InputError with the choice that removes it. A program may offer the choice and repeat the request with it.
struct InputQuestion final : InputError {
  InputChoice choice;

  InputQuestion(const InputError& error, InputChoice offered) : InputError(error) { choice = std::move(offered); }
};

}  // namespace tubeplan::app
