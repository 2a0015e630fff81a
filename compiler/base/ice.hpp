// Our own bugs. SG_ASSERT and SG_UNREACHABLE are active in every build: they print what happened and leave
// with exit code 3. What a user can mend goes through base/diag.hpp instead; the two never mix.
#pragma once

#include <string_view>

namespace sg {

// Prints "surfgrad: internal error: WHAT (FILE:LINE)" and leaves the process with exit code 3.
[[noreturn]] void internal_error(const char* file, int line, std::string_view what);

}  // namespace sg

#define SG_ASSERT(condition)                                                                         \
    do {                                                                                             \
        if (!(condition)) ::sg::internal_error(__FILE__, __LINE__, "assertion failed: " #condition); \
    } while (false)
#define SG_UNREACHABLE(what) ::sg::internal_error(__FILE__, __LINE__, what)
