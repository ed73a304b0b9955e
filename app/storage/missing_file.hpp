// Error for an input file that does not exist, for which some languages have a separate exception.
#pragma once

#include "app/storage/input_error.hpp"

namespace tubeplan::app {

struct MissingFile final : InputError {
  explicit MissingFile(const InputError& error) : InputError(error) {}
};

}  // namespace tubeplan::app
