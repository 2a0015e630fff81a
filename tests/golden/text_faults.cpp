#include "text_faults.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <regex>
#include <vector>

#include "emit/names.hpp"
#include "ir/ir.hpp"

namespace sg::test {
namespace {

bool is_letter(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

std::vector<std::string_view> lines_of(std::string_view text) {
    std::vector<std::string_view> out;
    for (std::size_t at = 0; at < text.size();) {
        std::size_t end = std::min(text.find('\n', at), text.size());
        out.push_back(text.substr(at, end - at));
        at = end + 1;
    }
    return out;
}

// The function that the compiler wrote: the last of the text. Comments and line breaks become one blank each.
std::string last_function(std::string_view glsl) {
    std::size_t begin = glsl.rfind("\n}");
    while (begin > 0 && begin != glsl.npos && !(glsl[begin] == '\n' && is_letter(glsl[begin + 1]))) --begin;
    std::string out;
    for (std::string_view line : lines_of(glsl.substr(begin + 1))) {
        line = line.substr(0, line.find("//"));
        const std::size_t first = line.find_first_not_of(' ');
        if (first == line.npos) continue;
        line = line.substr(first);
        while (line.back() == ' ') line.remove_suffix(1);
        if (!out.empty() && out.back() != '(') out += ' ';
        out += line;
    }
    return out;
}

std::size_t times(std::string_view text, std::string_view word) {
    std::size_t count = 0;
    for (std::size_t at = text.find(word); at != text.npos; at = text.find(word, at + 1)) {
        const bool begins = at == 0 || !is_letter(text[at - 1]);
        const std::size_t end = at + word.size();
        count += begins && (end == text.size() || !is_letter(text[end])) ? 1 : 0;
    }
    return count;
}

bool is_known(const std::string& name, const std::set<std::string>& known) {
    if (known.count(name) > 0) return true;
    const std::size_t number = name.find_last_not_of("0123456789");
    return number + 1 < name.size() && name[number] == '_' && known.count(name.substr(0, number)) > 0;
}

bool takes_derivatives(std::string_view expression) {
    if (expression.starts_with("sg_stage_sample(")) return true;
    for (const ir::OpInfo& op : ir::all_ops()) {
        if (ir::takes_screen_derivatives(op.op) &&
            expression.starts_with(op.glsl.substr(0, op.glsl.find('(') + 1)))
            return true;
    }
    return false;
}

}  // namespace

std::string local_used_once(std::string_view glsl, const std::set<std::string>& known) {
    const std::string body = last_function(glsl);
    const bool diverges = body.find(" discard;") != body.npos || body.find("sg_parallax_") != body.npos;
    static const std::regex kDeclaration("[;{] (\\w+) (\\w+)( = ([^;]*))?;");
    for (std::sregex_iterator it(body.begin(), body.end(), kDeclaration), end; it != end; ++it) {
        const std::string name = (*it)[2], value = (*it)[4];
        if ((*it)[1] == "return") continue;
        const std::size_t uses = times(body, name) - 1;
        if (uses > 1 || is_known(name, known) || (diverges && takes_derivatives(value))) continue;
        return fmt::format("'{}' is used {} times", name, uses);
    }
    return "";
}

std::string computed_twice(std::string_view glsl) {
    const std::string body = last_function(glsl);
    std::set<std::string> seen;
    for (std::size_t at = body.find('('); at != body.npos; at = body.find('(', at + 1)) {
        std::size_t begin = at, end = at + 1;
        while (begin > 0 && is_letter(body[begin - 1])) --begin;
        for (int open = 1; open > 0 && end < body.size(); ++end)
            open += body[end] == '(' ? 1 : body[end] == ')' ? -1 : 0;
        std::string call = body.substr(begin, end - begin);
        const bool works =
            call.starts_with("sg_") && !call.ends_with("()") && !call.starts_with("sg_texture_size(");
        if (works && !seen.insert(call).second) return fmt::format("'{}' is computed twice", call);
    }
    return "";
}

std::string comment_twice(std::string_view glsl) {
    std::set<std::string_view> seen;
    for (std::string_view line : lines_of(glsl)) {
        if (!line.starts_with("    // ")) continue;
        if (!seen.insert(line).second) return fmt::format("'{}' stands there twice", line);
    }
    return "";
}

std::string scattered_layer(std::string_view glsl, const std::set<std::string>& layers,
                            const std::set<std::string>& nodes) {
    std::string here;  // the layer whose lines these are
    for (std::string_view line : lines_of(glsl)) {
        if (line.empty()) here.clear();
        if (line.starts_with("    // "))
            here = emit::Names().unique("m_", line.substr(7, line.rfind(':') - 7));
        static const std::regex kDeclaration("    \\w+ (m_\\w+) =.*");
        std::cmatch found;
        if (!std::regex_match(line.begin(), line.end(), found, kDeclaration)) continue;
        const std::string name = found[1];
        std::string owner;  // of the longest name that fits
        for (const std::string& layer : layers) {
            if ((name == layer || name.starts_with(layer + "_")) && layer.size() > owner.size())
                owner = layer;
        }
        if (!owner.empty() && owner != here && !is_known(name, nodes))
            return fmt::format("'{}' stands outside of its layer", name);
    }
    return "";
}

std::string stuttering_name(std::string_view glsl) {
    static const std::regex kTwice("\\bm_(\\w+)_\\1_\\w+");
    const std::string body = last_function(glsl);
    std::smatch found;
    return std::regex_search(body, found, kTwice) ? fmt::format("'{}'", found.str()) : "";
}

std::string unnamed_layer(std::string_view glsl, const std::set<std::string>& layers) {
    const std::vector<std::string_view> lines = lines_of(glsl);
    for (const std::string& layer : layers) {
        if (std::find(lines.begin(), lines.end(), "    // " + layer) == lines.end())
            return fmt::format("'{}' is not named", layer);
    }
    return "";
}

std::string long_line(std::string_view glsl) {
    for (std::string_view line : lines_of(glsl)) {
        if (line.size() > 120) return fmt::format("{} letters: '{}'", line.size(), line);
    }
    return "";
}

std::string idle_arithmetic(std::string_view glsl) {
    static const std::string kZero = "(0\\.0|vec[234]\\(0\\.0\\))", kOne = "(1\\.0|vec[234]\\(1\\.0\\))";
    static const std::string kArgument = "(?:\\w+|\\w+\\(\\w*\\))";
    static const std::regex kIdle[] = {
        std::regex("[ (]" + kZero + " [-+*] |[ (]" + kOne + " \\* | [-+*] " + kZero + "[ ,;)]| \\* " + kOne +
                   "[ ,;)]"),
        std::regex("-0\\.0[ ,;)]|[ (]-1\\.0 \\* | \\* -1\\.0[ ,;)]| [-+] -"),
        std::regex("[ (]mix\\((?:[^()]|\\([^()]*\\))*, [01]\\.0\\)"),
        std::regex("sg_(uv|volume)_scale\\(" + kArgument + ", " + kOne + "\\)"),
        std::regex("sg_frame_resolved\\(sg_stage_frame\\(\\w+, (" + kArgument + ")\\), \\1\\)"),
    };
    const std::string body = last_function(glsl);
    std::smatch found;
    for (const std::regex& idle : kIdle) {
        if (std::regex_search(body, found, idle)) return fmt::format("'{}'", found.str());
    }
    return "";
}

}  // namespace sg::test
