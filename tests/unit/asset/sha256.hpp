// SHA-256 (FIPS 180-4), for comparing pixels with published hashes.
#pragma once

#include <string>
#include <string_view>

namespace sg::test {

// 64 lower-case hex digits.
std::string sha256(std::string_view bytes);

}  // namespace sg::test
