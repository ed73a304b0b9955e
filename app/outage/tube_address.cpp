#include "app/outage/tube_address.hpp"

#include <fmt/format.h>

#include "app/storage/input_error.hpp"

namespace tubeplan::app {

std::string addressText(const TubeAddress& address) {
  return fmt::format("{}/{}/{}", address.generator, tubesheets::legName(address.leg),
                     tubesheets::tubeName(address.row, address.column));
}

TubeAddress parseAddress(std::string_view text, const std::string& option) {
  const std::size_t second = text.rfind('/'),
                    first = second == 0 || second == text.npos ? text.npos : text.rfind('/', second - 1);
  if (first == text.npos || first == 0)
    throw InputError(option, inQuotes(text), "a tube with its steam generator and leg, such as A/hot/R12C40",
                     "`tubeplan job status` lists the steam generators and legs of the job");
  const auto leg = tubesheets::findLeg(text.substr(first + 1, second - first - 1));
  if (!leg)
    throw InputError(option, inQuotes(text.substr(first + 1, second - first - 1)),
                     "one of the legs " + tubesheets::legNames());
  const auto tube = tubesheets::parseTubeName(text.substr(second + 1));
  if (!tube) throw InputError(option, inQuotes(text.substr(second + 1)), "a tube such as R12C40");
  return {std::string(text.substr(0, first)), *leg, tube->row, tube->column};
}

}  // namespace tubeplan::app
