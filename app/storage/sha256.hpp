// SHA-256 (FIPS 180-4), as `sha256sum` prints it: which inputs a report is of.
#pragma once

#include <string>
#include <string_view>

namespace tubeplan::app {

/// 64 hexadecimal digits. Throws std::bad_alloc where there is no memory for the library's work.
[[nodiscard]] std::string sha256Of(std::string_view bytes);

}  // namespace tubeplan::app
