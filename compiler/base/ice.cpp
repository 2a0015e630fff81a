#include "base/ice.hpp"

#include <fmt/core.h>

#include <cstdio>
#include <cstdlib>

namespace sg {

void internal_error(const char* file, int line, std::string_view what) {
    std::string_view name(file);
    if (auto slash = name.find_last_of('/'); slash != name.npos) name.remove_prefix(slash + 1);
    fmt::print(stderr,
               "surfgrad: internal error: {} ({}:{})\nThis is a bug in surfgrad, not in your input.\n", what,
               name, line);
    std::fflush(nullptr);
    std::_Exit(3);
}

}  // namespace sg
