#include "tests/cross/browser.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstring>
#include <iterator>
#include <sstream>
#include <stdexcept>

#include "tests/cross/process.hpp"
#include "tests/support/golden.hpp"

namespace sg::cross {
namespace {

constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

Pixels pixels_from(const std::string& text) {
    std::string bytes;
    std::uint32_t group = 0;
    int bits = 0;
    for (char c : text) {
        std::size_t digit = kDigits.find(c);
        if (digit == kDigits.npos) continue;
        group = group << 6u | static_cast<std::uint32_t>(digit);
        bits += 6;
        if (bits < 8) continue;
        bits -= 8;
        bytes += static_cast<char>(group >> bits & 0xFFu);
    }
    Pixels out(bytes.size() / sizeof(float));
    if (bytes.empty() || bytes.size() % (kPlane * sizeof(float)) != 0)
        throw std::runtime_error("the browser gave another number of bytes");
    std::memcpy(out.data(), bytes.data(), bytes.size());
    return out;
}

}  // namespace

std::string base64(const void* data, std::size_t size) {
    const auto* bytes = static_cast<const unsigned char*>(data);
    std::string out;
    for (std::size_t i = 0; i < size; i += 3) {
        std::uint32_t group = 0;
        for (std::size_t k = 0; k < 3; ++k) group = group << 8u | (i + k < size ? bytes[i + k] : 0u);
        for (std::size_t k = 0; k < 4; ++k) out += i + k <= size ? kDigits[group >> (18 - 6 * k) & 63u] : '=';
    }
    return out;
}

std::string browser() {
    for (const char* name : {"chromium-headless-shell", "chromium"}) {
        if (has_program(name)) return name;
    }
    return "";
}

std::string body_of(const std::string& script, const std::string& flags) {
    auto file = scratch() / "page.html";
    write_file(file, "<body><script>" + script + "</script></body>");
    std::string dom = run(fmt::format("timeout 200 {} --headless --no-sandbox --disable-dev-shm-usage "
                                      "--user-data-dir='{}' {} --dump-dom 'file://{}' 2>/dev/null",
                                      browser(), (scratch() / "profile").string(), flags, file.string()))
                          .text;
    std::size_t begin = dom.find("<body>"), end = dom.find("</body>");
    return begin == dom.npos || end == dom.npos ? "" : dom.substr(begin + 6, end - begin - 6);
}

void PageOutcome::add(PageOutcome&& other) {
    std::move(other.pictures.begin(), other.pictures.end(), std::back_inserter(pictures));
    std::move(other.refusals.begin(), other.refusals.end(), std::back_inserter(refusals));
}

std::vector<std::span<const Drawing>> pages_of(std::span<const Drawing> drawings) {
    constexpr std::size_t kPerPage = 36;
    std::vector<std::span<const Drawing>> out;
    do {
        out.push_back(drawings.subspan(0, std::min(kPerPage, drawings.size())));
        drawings = drawings.subspan(out.back().size());
    } while (!drawings.empty());
    return out;
}

PageOutcome run_page(const std::string& input, const std::vector<std::string>& scripts,
                     const std::string& flags, std::size_t drawings, std::size_t further) {
    std::string script = "const input = " + input + ";\n";
    for (const std::string& name : scripts)
        script += test::read_file(test::source_dir() / "tests/cross" / name);
    std::istringstream lines(body_of(script, flags));
    PageOutcome out;
    std::string line;
    std::getline(lines, line);  // the first is empty
    while (out.refusals.size() < drawings + further) {
        if (!std::getline(lines, line) || line.starts_with("no "))
            throw std::runtime_error("the browser gave no answer: " + line);
        bool refused = line.starts_with("refused");
        if (out.refusals.size() < drawings) out.pictures.push_back(refused ? Pixels{} : pixels_from(line));
        out.refusals.push_back(refused ? line : "");
    }
    return out;
}

}  // namespace sg::cross
