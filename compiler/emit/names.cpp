#include "emit/names.hpp"

#include <fmt/core.h>

#include <cctype>

namespace sg::emit {

std::string Names::unique(std::string_view prefix, std::string_view wanted) {
    std::string name(prefix);
    for (char c : wanted.substr(0, 48)) {
        bool good = std::isalnum(static_cast<unsigned char>(c)) && static_cast<unsigned char>(c) < 0x80u;
        if (good) {
            name += c;
        } else if (name.back() != '_') {
            name += '_';  // never two in a row: GLSL reserves them
        }
    }
    while (name.size() > prefix.size() && name.back() == '_') name.pop_back();
    if (name.size() == prefix.size()) name += "x";
    auto [first, fresh] = taken_.try_emplace(name, 2);
    if (fresh) return name;
    for (int& n = first->second;;) {
        std::string candidate = fmt::format("{}_{}", name, n++);
        if (taken_.try_emplace(candidate, 2).second) return candidate;
    }
}

std::string comment_text(std::string_view text) {
    std::string out;
    for (char c : text) {
        auto byte = static_cast<unsigned char>(c);
        out += byte < 0x20u || byte >= 0x7Fu || c == '\\' ? '?' : c;
    }
    return out;
}

std::string float_literal(double value) {
    std::string out = fmt::format("{}", static_cast<float>(value) + 0.0f);  // no -0
    bool whole = out.find_first_of(".en") == std::string::npos;
    return whole ? out + ".0" : out;
}

}  // namespace sg::emit
