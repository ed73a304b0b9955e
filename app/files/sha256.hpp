// SHA-256 (FIPS 180-4), as `sha256sum` prints it: which inputs a report is of.
#pragma once

#include <string>
#include <string_view>

namespace tubeplan::app {

/// 64 hexadecimal digits.
[[nodiscard]] std::string sha256Of(std::string_view bytes);

}  // namespace tubeplan::app
