// SHA-256 (FIPS 180-4) in the format of `sha256sum`, to identify the inputs of a report.
#pragma once

#include <string>
#include <string_view>

namespace tubeplan::app {

/// Returns 64 hexadecimal digits. Throws std::bad_alloc if there is no memory for the library's work.
[[nodiscard]] std::string sha256Of(std::string_view bytes);

}  // namespace tubeplan::app
