// Full name of one end of a tube: steam generator, leg, row and column.
#pragma once

#include <compare>
#include <string>
#include <string_view>

#include "tubesheets/tube.hpp"

namespace tubeplan::app {

struct TubeAddress {
  std::string generator;
  tubesheets::Leg leg = tubesheets::Leg::kHot;
  int row = 0, column = 0;

  [[nodiscard]] auto operator<=>(const TubeAddress&) const = default;
};

/// Returns the address as "A/hot/R12C40".
[[nodiscard]] std::string addressText(const TubeAddress& address);

/// Reads an address. Throws InputError, naming the option, for any other text: a tube's name alone ("R12C40") is
/// refused, because every leg of every steam generator has a tube of that name.
[[nodiscard]] TubeAddress parseAddress(std::string_view text, const std::string& option);

}  // namespace tubeplan::app
