// Materials that benchmarks make up.
#pragma once

#include <fmt/format.h>

#include <string>

namespace sg::bench {

// They hang on the vertex colour, for what hangs on parameters alone leaves the shader.

// A graph of `count` nodes, each of which refers to the two before it: read as a tree it would be
// exponential.
inline std::string shared_graph(std::size_t count) {
    std::string out =
        R"({ "version": 1, "parameters": { "p": { "type": "float", "default": 0.5 } }, "nodes": {)";
    out +=
        R"("v": { "op": "vertex_color", "channel": "r" }, "n0": { "op": "multiply", "a": "@v", "b": 0.5 }, "n1": { "op": "add", "a": "$p", "b": "@n0" })";
    constexpr std::string_view kOps[] = {"add", "multiply", "min", "max", "subtract"};
    for (std::size_t i = 2; i < count; ++i) {
        out += fmt::format(R"(,
"n{}": {{ "op": "{}", "a": "@n{}", "b": "@n{}" }})",
                           i, kOps[i % 5], i - 1, i - 2);
    }
    return out + fmt::format(R"(}}, "surface": {{ "roughness": "@n{}" }} }})", count - 1);
}

// The same with nodes written in place, so that none has a name: each entry of a sum that leans to the left,
// as deep as JSON may nest, many times over.
inline std::string nameless_graph(std::size_t count) {
    constexpr std::size_t kDepth = 50;
    std::string out =
        R"({ "version": 1, "parameters": { "p": { "type": "float", "default": 0.5 } }, "nodes": { "v": { "op": "vertex_color", "channel": "r" },)";
    std::string before = "\"@v\"";
    for (std::size_t made = 0, group = 0; made < count; made += kDepth, ++group) {
        std::string node = before;
        for (std::size_t k = 0; k < kDepth; ++k)
            node = fmt::format(R"({{ "op": "multiply", "a": {}, "b": "$p" }})", node);
        out += fmt::format("{}\n\"g{}\": {}", group > 0 ? "," : "", group, node);
        before = fmt::format("\"@g{}\"", group);
    }
    return out + fmt::format(R"(}}, "surface": {{ "roughness": {} }} }})", before);
}

}  // namespace sg::bench
