// surfgrad-bench-library: the GPU instructions of every function of shader_lib/surfgrad, as RADV compiles
// them for an AMD GPU that need not be there. Prints the lines of tests/shader_lib/costs.txt, which the
// library's README shows.
//
// A function's cost is the difference of two shaders that read the same inputs and write as many outputs: one
// calls it.
#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <map>
#include <sstream>

#include "gpu_statistics.hpp"
#include "tests/shader_lib/glsl.hpp"
#include "tests/shader_lib/library_index.hpp"

namespace sg::bench {
namespace {

using Fields = std::vector<std::pair<std::string, std::string>>;  // type, name
using Structs = std::map<std::string, Fields>;

std::string without_comments(const std::string& text) {
    std::istringstream lines(text);
    std::string out;
    for (std::string line; std::getline(lines, line);) out += line.substr(0, line.find("//")) + "\n";
    return out;
}

// "vec3 a, b; float c;" or "vec3 a, float c" -> one pair each.
Fields fields_of(std::string text) {
    for (char& c : text) c = c == ',' || c == ';' || c == '\n' ? ' ' : c;
    static const std::string kNumbers = "float int uint bool vec2 vec3 vec4 mat2 mat3 mat4 texture2D sampler";
    std::istringstream words(text);
    std::string type;
    Fields out;
    for (std::string word; words >> word;) {
        if (word == "in" || word == "const") continue;
        const bool is_type =
            word.starts_with("Sg") || (" " + kNumbers + " ").find(" " + word + " ") != std::string::npos;
        if (is_type) {
            type = word;
        } else {
            out.emplace_back(type, word);
        }
    }
    return out;
}

Structs structs_of_library() {
    Structs out;
    for (const std::string& file : proof::library_files()) {
        const std::string text = without_comments(proof::library_text(file));
        for (std::size_t at = text.find("struct "); at != std::string::npos;
             at = text.find("struct ", at + 1)) {
            const std::size_t open = text.find('{', at), close = text.find('}', at);
            std::string name = text.substr(at + 7, open - at - 8);
            out[name] = fields_of(text.substr(open + 1, close - open - 1));
        }
    }
    return out;
}

int components(const std::string& type) {
    static const std::map<std::string, int> kCounts = {{"vec2", 2}, {"vec3", 3}, {"vec4", 4},
                                                       {"mat2", 4}, {"mat3", 9}, {"mat4", 16}};
    auto found = kCounts.find(type);
    return found == kCounts.end() ? 1 : found->second;
}

// An expression of the type, made of inputs from position `at` on.
std::string read_value(const std::string& type, const Structs& structs, int& at) {
    if (type == "texture2D") return "bench_image";
    if (type == "sampler") return "bench_sampler";
    std::string out;
    if (auto found = structs.find(type); found != structs.end()) {
        for (const auto& [field, name] : found->second) {
            out += (out.empty() ? "" : ", ") + read_value(field, structs, at);
        }
    } else {
        for (int k = 0; k < components(type); ++k) out += fmt::format("{}x[{}]", k > 0 ? ", " : "", at++);
    }
    return type + "(" + out + ")";
}

// Statements that write a value of the type to the outputs from position `at` on.
std::string write_value(const std::string& value, const std::string& type, const Structs& structs, int& at) {
    std::string out;
    if (auto found = structs.find(type); found != structs.end()) {
        for (const auto& [field, name] : found->second)
            out += write_value(value + "." + name, field, structs, at);
    } else if (components(type) == 1) {
        out = fmt::format("put({}, float({}));\n", at++, value);
    } else {
        const int rows = type.starts_with("mat") ? type[3] - '0' : 1;
        for (int k = 0; k < components(type); ++k) {
            const std::string element =
                rows == 1 ? fmt::format("[{}]", k) : fmt::format("[{}][{}]", k / rows, k % rows);
            out += fmt::format("put({}, {}{});\n", at++, value, element);
        }
    }
    return out;
}

struct Signature {
    std::string result;
    Fields parameters;
};
Signature signature_of(const std::string& file, const std::string& function) {
    const std::string text = without_comments(proof::library_text(file));
    const std::size_t name = text.find(" " + function + "("), line = text.rfind('\n', name) + 1;
    const std::size_t open = text.find('(', name), close = text.find(')', name);
    return {text.substr(line, name - line), fields_of(text.substr(open + 1, close - open - 1))};
}

std::string shader(const std::string& file, int inputs, const std::string& statements) {
    return fmt::format(R"(#include "{}"
layout(local_size_x = 64) in;
layout(set = 0, binding = 0, std430) readonly buffer Inputs {{ float bench_in[]; }};
layout(set = 0, binding = 1, std430) writeonly buffer Outputs {{ float bench_out[]; }};
layout(set = 0, binding = 2, std140) uniform Control {{ uint bench_count; }};
layout(set = 0, binding = 3) uniform texture2D bench_image;
layout(set = 0, binding = 4) uniform sampler bench_sampler;
void put(int k, float x) {{ bench_out[gl_GlobalInvocationID.x * 128u + k] = x; }}
void main() {{
    float x[{}];
    for (int k = 0; k < {}; ++k) {{
        x[k] = bench_in[gl_GlobalInvocationID.x * 64u + k];
        put(64 + k, x[k]);
    }}
{}}}
)",
                       file, inputs, inputs, statements);
}

std::optional<std::uint64_t> instructions(const std::string& text) {
    const proof::Compiled compiled = proof::compile_glsl(text);
    if (compiled.words.empty()) std::cerr << compiled.log << text;
    const auto statistics = compiled.words.empty() ? std::nullopt : gpu_statistics(compiled.words);
    return statistics ? std::optional(statistics->instructions) : std::nullopt;
}

// Empty when the driver is missing or the call does not compile.
std::optional<std::uint64_t> cost_of(const std::string& file, const std::string& function,
                                     const Structs& structs) {
    const Signature signature = signature_of(file, function);
    int inputs = 0, outputs = 0;
    std::string arguments;
    for (const auto& [type, name] : signature.parameters) {
        arguments += (arguments.empty() ? "" : ", ") + read_value(type, structs, inputs);
    }
    inputs = std::max(inputs, 1);  // a function of nothing, or of a texture alone
    const std::string call = fmt::format("    {} result = {}({});\n", signature.result, function, arguments);
    const std::string writes = write_value("result", signature.result, structs, outputs);
    std::string nothing;
    for (int k = 0; k < outputs; ++k) nothing += fmt::format("put({}, x[{}]);\n", k, k % inputs);
    const auto with = instructions(shader(file, inputs, call + writes));
    const auto without = instructions(shader(file, inputs, nothing));
    if (!with || !without) return std::nullopt;
    return *with > *without ? *with - *without : 0;
}

int run() {
    const Structs structs = structs_of_library();
    std::string lines = fmt::format("RADV {}\n", gpu_driver_version());
    for (const auto& [function, file] : proof::library_functions()) {
        const auto cost = cost_of(file, function, structs);
        if (!cost) {
            std::cerr << fmt::format("no instructions for {}; run: env {} surfgrad-bench-library\n", function,
                                     kGpuEnvironment);
            return 1;
        }
        lines += fmt::format("{} {}\n", function, *cost);
    }
    std::cout << lines;
    return 0;
}

}  // namespace
}  // namespace sg::bench

int main() {
    return sg::bench::run();
}
