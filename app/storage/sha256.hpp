// SHA-256 digests (FIPS 180-4) in the format of `sha256sum`, which identify the input files of a report.
#pragma once

#include <string>
#include <string_view>

namespace tubeplan::app {

/// Returns the digest as 64 hexadecimal digits. Throws std::bad_alloc if OpenSSL runs out of memory.
[[nodiscard]] std::string sha256Of(std::string_view bytes);

}  // namespace tubeplan::app
