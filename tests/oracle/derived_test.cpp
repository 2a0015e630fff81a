// What the host computes from parameters: the manifest's bytes, its expressions and the interpreter agree,
// and so do pictures, whatever the parameters are set to.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "ir/evaluate.hpp"
#include "ir/host.hpp"
#include "ir/text.hpp"
#include "layers/kind.hpp"
#include "runtime/mesh/shapes.hpp"
#include "runtime/parameters.hpp"
#include "runtime/scene.hpp"
#include "tests/oracle/random_module.hpp"
#include "tests/render/workshop.hpp"

namespace sg::oracle {
namespace {

using Json = nlohmann::ordered_json;
using runtime::Artefact;

// ---- random materials whose surface hangs on parameters alone ----

constexpr const char* kParameters = R"({
  "a": { "type": "float", "default": 0.75, "range": [-2, 2] },
  "b": { "type": "float", "default": -1.25, "range": [-2, 2] },
  "on": { "type": "bool", "default": true },
  "n": { "type": "int", "default": 2, "range": [0, 3] },
  "tint": { "type": "color", "default": [0.9, 0.5, 0.1], "range": [0, 1] },
  "three": { "type": "vec3", "default": [0.2, 0.3, 0.7], "range": [0, 1] } })";

class Generator {
public:
    explicit Generator(std::mt19937_64& random) : random_(random) {}

    std::string make() {
        Json nodes = Json::object();
        for (int i = 0; i < 12; ++i) {
            const layers::NodeKind& kind = pick_kind();
            Json node = {{"op", kind.name}};
            for (const layers::Field& field : kind.fields) {
                node[std::string(field.name)] =
                    field.kind == layers::FieldKind::range ? Json{-1, 2.5} : operand(field);
            }
            const std::string name = fmt::format("n{}", i);
            nodes[name] = node;
            (kind.result == ir::Type::Color ? colors_ : numbers_).push_back("@" + name);
            if (kind.name == "constant" && is_checked(node["value"])) checked_names_.insert("@" + name);
        }
        const std::string last = last_unchecked();
        Json out = {{"version", 1}, {"parameters", Json::parse(kParameters)}, {"nodes", nodes}};
        Json seen = {{"op", "multiply"}, {"a", {{"op", "height"}}}, {"b", last}};
        out["surface"] = {{"roughness", last}, {"metallic", seen}, {"base_color", colors_.back()}};
        return out.dump();
    }

private:
    std::size_t below(std::size_t count) {
        return std::uniform_int_distribution<std::size_t>(0, count - 1)(random_);
    }
    // Those that take numbers and colours alone.
    const layers::NodeKind& pick_kind() {
        for (;;) {
            const layers::NodeKind& kind = layers::all_node_kinds()[below(layers::all_node_kinds().size())];
            bool plain = !kind.fields.empty();
            for (const layers::Field& f : kind.fields) {
                plain = plain && f.required &&
                        (f.kind == layers::FieldKind::number || f.kind == layers::FieldKind::color ||
                         f.kind == layers::FieldKind::range);
            }
            if (plain) return kind;
        }
    }
    // Numbers and parameters' ranges are checked where they are used, also through `constant` nodes.
    bool is_checked(const Json& value) const {
        if (value.is_number()) return true;
        const std::string& text = value.get_ref<const std::string&>();
        return text[0] == '$' || checked_names_.contains(text);
    }
    std::string last_unchecked() const {
        const auto last = std::ranges::find_if(numbers_.rbegin(), numbers_.rend(),
                                               [&](const std::string& one) { return !is_checked(one); });
        return last == numbers_.rend() ? "$on" : *last;
    }
    // What a field takes from 0 to 1 alone may be a node of any value, but no such number or parameter.
    Json operand(const layers::Field& field) {
        const bool color = field.kind == layers::FieldKind::color,
                   wide = field.minimum <= -2 && field.maximum >= 3;
        const auto& from = color ? colors_ : numbers_;
        const std::string& picked = from[from.size() - 1 - below(std::min<std::size_t>(from.size(), 6))];
        if (below(4) != 0 && (color || wide || !is_checked(picked))) return picked;
        return color ? Json{0.5, 0.25, 1} : Json(0.1 * static_cast<double>(below(wide ? 20 : 10)));
    }

    std::mt19937_64& random_;
    std::vector<std::string> numbers_{"$a", "$b", "$on", "$n"}, colors_{"$tint", "$three"};
    std::set<std::string> checked_names_;
};

struct Subject {
    Compiled compiled;
    Json manifest;
    Artefact artefact;
    ir::Module lowered, optimised;
};

Subject compile(const std::string& json, const std::map<std::string, std::string>& named = {}) {
    static const target::ShaderLibrary kLibrary = target::embedded_library();
    MemoryFiles files;
    for (const auto& [path, content] : named) files.contents["in/" + path] = content;
    CompileRequest request{.source = std::make_shared<Source>(Source{"case.json", json})};
    request.stem = "case";
    request.roots = {"in"};
    request.entries = {"depth"};
    Diags diags;
    auto compiled = compile_material(request, files, kLibrary, diags);
    if (!compiled) throw std::runtime_error(json + "\n" + render(diags));
    Subject out{.compiled = std::move(*compiled)};
    const std::string& manifest = out.compiled.files.back().second;
    out.manifest = Json::parse(manifest);
    auto artefact = runtime::read_manifest(manifest, "case.json", diags);
    std::string fault;
    auto lowered = ir::parse(out.compiled.ir, fault), optimised = ir::parse(out.compiled.optimised_ir, fault);
    if (!artefact || !lowered || !optimised) throw std::runtime_error(render(diags) + fault);
    out.artefact = std::move(*artefact);
    out.lowered = std::move(*lowered);
    out.optimised = std::move(*optimised);
    return out;
}

std::vector<std::byte> packed(const Artefact& artefact, const std::vector<std::string>& settings = {}) {
    Diags diags;
    auto out = runtime::pack_parameters(artefact, settings, diags);
    if (!out) throw std::runtime_error(render(diags));
    return *out;
}

std::vector<std::byte> bytes_of(const std::string& hexadecimal) {
    std::vector<std::byte> out;
    for (std::size_t i = 0; i + 1 < hexadecimal.size(); i += 2)
        out.push_back(static_cast<std::byte>(std::stoi(hexadecimal.substr(i, 2), nullptr, 16)));
    return out;
}

float float_at(const std::vector<std::byte>& block, std::size_t at) {
    float out = 0;
    std::memcpy(&out, block.data() + at, sizeof(float));
    return out;
}

// The parameters as the block holds them.
ir::Bindings bindings_of(const Subject& subject, const std::vector<std::byte>& block) {
    ir::Bindings out;
    for (std::size_t i = 0; i < subject.lowered.parameters.size(); ++i) {
        const runtime::Parameter& p = subject.artefact.parameters->parameters[i];
        std::array<double, 16> numbers{};
        for (std::size_t k = 0; k < p.initial.size(); ++k) numbers[k] = float_at(block, p.offset + 4 * k);
        out.parameters.push_back(ir::datum_of(subject.lowered.parameters[i].type, numbers));
    }
    return out;
}

std::vector<std::string> random_settings(std::mt19937_64& random) {
    auto real = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    return {fmt::format("a={}", real(-2, 2)),
            fmt::format("b={}", real(-2, 2)),
            fmt::format("on={}", random() % 2),
            fmt::format("n={}", random() % 4),
            fmt::format("tint={},{},{}", real(0, 1), real(0, 1), real(0, 1)),
            fmt::format("three={},{},{}", real(0, 1), real(0, 1), real(0, 1))};
}

constexpr std::uint64_t kMaterials = 150;
Subject subject(std::uint64_t index, std::mt19937_64& random) {
    std::seed_seq sequence{run_seed(), run_seed() >> 32U, index};
    random.seed(sequence);
    return compile(Generator(random).make());
}

// The runtime shares no code with the compiler's interpreter, but both compute in double what the expressions
// say, and round once to float: equal to the last bit, unless std::pow is asked for the same number in two
// ways.
TEST(Derived, BytesExpressionsAndInterpreterAgree) {
    std::size_t derived = 0, steps = 0;
    for (std::uint64_t i = 0; i < kMaterials; ++i) {
        std::mt19937_64 random;
        const Subject s = subject(i, random);
        SCOPED_TRACE(fmt::format("material {}, SG_SEED={}", i, run_seed()));
        const Json& block = s.manifest.at("parameter_block");
        EXPECT_EQ(bytes_of(block.at("default_bytes")), packed(s.artefact));
        EXPECT_EQ(s.artefact.parameters->derived.size(), s.optimised.derived.size());
        derived += s.optimised.derived.size();
        steps += s.artefact.parameters->steps.size();
        for (int round = 0; round < 3; ++round) {
            const auto bytes = packed(s.artefact, random_settings(random));
            const ir::Bindings bindings = bindings_of(s, bytes);
            const auto values = ir::derived_values(ir::with_stored_numbers(s.optimised), bindings);
            for (std::size_t k = 0; k < values.size(); ++k) {
                const auto numbers = ir::components(values[k]);
                for (std::size_t c = 0; c < numbers.size(); ++c) {
                    EXPECT_EQ(float_at(bytes, s.artefact.parameters->derived[k].offset + 4 * c),
                              runtime::stored(numbers[c]));
                }
            }
        }
    }
    fmt::print("{} materials, {} derived parameters, {} steps\n", kMaterials, derived, steps);
    EXPECT_GT(derived, kMaterials);
    EXPECT_GT(steps, kMaterials / 4);
}

// The module as lowered, where the shader computes all, gives what the optimised one gives.
TEST(Derived, SurfaceIsThatOfTheMaterialAsWritten) {
    for (std::uint64_t i = 0; i < kMaterials; ++i) {
        std::mt19937_64 random;
        const Subject s = subject(i, random);
        const ir::PixelInputs pixel = random_pixel(random);
        ir::Bindings bindings = bindings_of(s, packed(s.artefact, random_settings(random)));
        ir::Evaluator before(s.lowered, bindings), after(s.optimised, bindings);
        before.run(pixel);
        after.run(pixel);
        for (ir::Output output : {ir::Output::roughness, ir::Output::metallic, ir::Output::base_color}) {
            const auto a = ir::components(before.output(output)), b = ir::components(after.output(output));
            for (std::size_t c = 0; c < a.size(); ++c)
                EXPECT_LE(std::abs(a[c] - b[c]), 1e-12 * std::max(1.0, std::abs(a[c])))
                    << "material " << i << ", SG_SEED=" << run_seed();
        }
    }
}

// A wrong word in the manifest is noticed by the bytes beside it.
TEST(Derived, WrongExpressionsAreNoticed) {
    std::map<std::string, int> tried, noticed;
    for (std::uint64_t i = 0; i < kMaterials; ++i) {
        std::mt19937_64 random;
        const Subject s = subject(i, random);
        const std::string text = s.compiled.files.back().second;
        for (const runtime::ExpressionWord& word : runtime::expression_words()) {
            const bool two = word.operands == 2;
            const std::string instead =
                two ? (word.word == "add" ? "multiply" : "add") : (word.word == "mix" ? "clamp" : "mix");
            const std::string wrong = std::regex_replace(text, std::regex(fmt::format("\"{}\",", word.word)),
                                                         fmt::format("\"{}\",", instead));
            if (wrong == text) continue;
            Diags diags;
            auto artefact = runtime::read_manifest(wrong, "wrong.json", diags);
            if (!artefact) continue;  // an operand that only a colour takes
            ++tried[std::string(word.word)];
            noticed[std::string(word.word)] += packed(*artefact) != packed(s.artefact);
        }
    }
    for (const runtime::ExpressionWord& word : runtime::expression_words()) {
        const std::string name(word.word);
        fmt::print("  {:12} wrong in {} materials, noticed in {}\n", name, tried[name], noticed[name]);
        EXPECT_GE(noticed[name], 3) << name;
    }
}

// The shader compares two floats: 0.7 is not below a parameter of 0.7, though the number 0.7 is above that.
TEST(Derived, NumbersAreThoseOfTheShader) {
    const Subject s = compile(R"({
      "version": 1,
      "parameters": { "wet": { "type": "float", "default": 0.7, "range": [0, 1] } },
      "surface": { "metallic": { "op": "smoothstep", "low": 0.7, "high": 0.7, "x": "$wet" } } })");
    const Json& derived = s.manifest.at("parameter_block").at("derived")[0];
    EXPECT_EQ(derived.at("expression").dump(), R"(["smoothstep",0.7,0.7,"$wet"])");
    EXPECT_EQ(derived.at("default").dump(), "[1.0]");
    const std::size_t at = s.artefact.parameters->derived[0].offset;
    EXPECT_EQ(float_at(packed(s.artefact), at), 1.0f);
    EXPECT_EQ(float_at(packed(s.artefact, {"wet=0.7"}), at), 1.0f);
    EXPECT_EQ(float_at(packed(s.artefact, {"wet=0.6999999"}), at), 0.0f);
}

// ---- the rows of a matrix ----

constexpr const char* kThrown = R"({
  "version": 1,
  "parameters": { "place": { "type": "mat4", "default": [1.25, 0, 0, 0, 0, -0.8, 0.625, 0, 0, -1, -0.5, 0, -0.125, 1.4, 0.4, 1] } },
  "textures": { "ramp": { "file": "textures/ramp_normal.png", "encoding": "tangent_normal", "green": "down" } },
  "bump": [ { "layers": [ { "id": "sign", "kind": "decal", "texture": "ramp", "space": "world", "projector": "$place" } ] } ] })";

// The unit rows by hand, from the floats that the block holds.
glm::dvec3 unit_row(const std::vector<std::byte>& block, std::size_t row) {
    glm::dvec3 out;
    for (std::size_t c = 0; c < 3; ++c) out[static_cast<int>(c)] = float_at(block, 4 * (4 * c + row));
    const double length = std::hypot(out.x, out.y, out.z);
    return length > 0 ? out / length : out;
}

TEST(Derived, DirectionsOfADecalAreRowsOfItsMatrix) {
    const Subject s = compile(kThrown, truth::sample_files());
    const Json& block = s.manifest.at("parameter_block");
    EXPECT_EQ(block.at("derived")[0].at("expression").dump(), R"(["unit",["row","$place",0]])");
    EXPECT_EQ(block.at("derived")[1].at("expression").dump(), R"(["unit",["row","$place",1]])");
    EXPECT_EQ(bytes_of(block.at("default_bytes")), packed(s.artefact));
    std::seed_seq sequence{run_seed(), run_seed() >> 32U};
    std::mt19937_64 random(sequence);
    std::uniform_real_distribution<double> number(-3, 3);
    for (int round = 0; round < 200; ++round) {
        std::string setting = "place=";
        for (int i = 0; i < 16; ++i)
            setting += fmt::format("{}{}", i > 0 ? "," : "", round > 0 && i < 15 ? number(random) : i == 15);
        const auto bytes = packed(s.artefact, {setting});
        const auto values = ir::derived_values(ir::with_stored_numbers(s.optimised), bindings_of(s, bytes));
        ASSERT_EQ(values.size(), 2u);
        for (std::size_t k = 0; k < 2; ++k) {
            const glm::dvec3 expected = unit_row(bytes, k);
            const auto numbers = ir::components(values[k]);
            for (std::size_t c = 0; c < 3; ++c) {
                const float held = float_at(bytes, s.artefact.parameters->derived[k].offset + 4 * c);
                EXPECT_EQ(held, runtime::stored(numbers[c])) << setting;
                EXPECT_NEAR(numbers[c], expected[static_cast<int>(c)], 1e-15) << setting;
            }
        }
    }
}

// The words of both sides are the same.
TEST(Derived, TheGrammarIsOne) {
    std::set<std::string_view> compiler, renderer{"channel", "rgb", "row", "unit", ""};
    for (const ir::HostOp& op : ir::all_host_ops()) compiler.insert(op.word);
    for (const runtime::ExpressionWord& word : runtime::expression_words()) renderer.insert(word.word);
    EXPECT_EQ(compiler, renderer);
}

// A graph in which each node uses the one before it twice: its expressions are as long as the graph.
TEST(Derived, SharedGraphsStayShort) {
    Json nodes = {{"n0", {{"op", "multiply"}, {"a", "$a"}, {"b", 0.5}}}};
    for (int i = 1; i < 2000; ++i) {
        const std::string last = fmt::format("@n{}", i - 1);
        nodes[fmt::format("n{}", i)] = {{"op", "mix"}, {"a", last}, {"b", last}, {"t", 0.5}};
    }
    const Json material = {{"version", 1},
                           {"parameters", Json::parse(kParameters)},
                           {"nodes", nodes},
                           {"surface", {{"roughness", "@n1999"}}}};
    const Subject s = compile(material.dump());
    EXPECT_LT(s.manifest.at("parameter_block").dump().size(), 2000u * 60);
    EXPECT_EQ(bytes_of(s.manifest.at("parameter_block").at("default_bytes")), packed(s.artefact));
    // A chain that uses each value once is cut into steps, for readers of JSON have limits of depth.
    Json chain = {{"n0", {{"op", "add"}, {"a", "$a"}, {"b", 0.5}}}};
    for (int i = 1; i < 2000; ++i)
        chain[fmt::format("n{}", i)] = {{"op", "add"}, {"a", fmt::format("@n{}", i - 1)}, {"b", 0.001}};
    const Json deep = {{"version", 1},
                       {"parameters", Json::parse(kParameters)},
                       {"nodes", chain},
                       {"surface", {{"roughness", "@n1999"}}}};
    EXPECT_EQ(compile(deep.dump()).artefact.parameters->derived.size(), 1u);
}

// ---- pictures ----

constexpr const char* kMaterial = R"({
  "version": 1,
  "parameters": { "wet": { "type": "float", "default": 0.2, "range": [0, 1] }, "depth": { "type": "float", "default": 0.1 },
                  "tint": { "type": "color", "default": [0.8, 0.4, 0.1] } },
  "nodes": { "dry": { "op": "one_minus", "x": "$wet" },
             "deep": { "op": "multiply", "a": "$depth", "b": { "op": "power", "a": "@dry", "b": 1.5 } } },
  "bump": [ { "layers": [ { "kind": "noise", "frequency": 4, "octaves": 2, "strength": "@deep", "mask": "@dry" } ] } ],
  "surface": { "roughness": { "op": "mix", "a": 0.15, "b": 0.8, "t": "@dry" },
               "base_color": { "op": "mix_color", "a": "$tint", "b": [0, 0, 0.2], "t": "$wet" } } })";

runtime::Scene scene() {
    runtime::Scene out;
    out.content.meshes.push_back(*runtime::make_shape("torus"));
    out.content.instances.push_back({"", 0, glm::mat4(1)});
    out.camera.position = glm::normalize(glm::dvec3(0.5, 0.9, 1)) * 5.6;
    out.camera.fov_degrees = 30;
    return out;
}

// The largest difference of any channel of any pixel, in units of the pixel's size.
double apart(const runtime::Picture& a, const runtime::Picture& b) {
    double out = 0;
    for (std::uint32_t y = 0; y < a.values.height; ++y) {
        for (std::uint32_t x = 0; x < a.values.width; ++x) {
            if (!truth::covered(a, x, y)) continue;
            const glm::dvec3 p = truth::rgb(a, x, y), q = truth::rgb(b, x, y);
            out = std::max(out, glm::length(p - q) / std::max(1.0, glm::length(p)));
        }
    }
    return out;
}

// Between a shader that computes all and one that leaves it to the host: their roundings differ by some 1e-7
// of a parameter, which a highlight of roughness 0.3 multiplies by less than a hundred.
TEST(Derived, PicturesAreThoseOfTheMaterialAsWritten) {
    const std::vector<std::string> settings = {"wet=0.65", "depth=0.07", "tint=0.3,0.9,0.5"};
    auto drawn = [&](bool host, const std::vector<std::string>& set, const std::string& word = "") {
        truth::Made made = truth::make({.json = kMaterial,
                                        .files = {},
                                        .entries = {"forward"},
                                        .skipped_rule = host ? "" : "parameters_on_host"});
        if (made.artefact.parameters->derived.size() != (host ? 3u : 0u))
            ADD_FAILURE() << made.artefact.parameters->derived.size() << " numbers of the host";
        for (runtime::DerivedParameter& d : made.artefact.parameters->derived) {
            if (word.empty() || d.expression.kind != runtime::Expression::Kind::word) continue;
            std::size_t& index = d.expression.index;
            if (runtime::expression_words()[index].word == word) index = index == 0 ? 2 : 0;
        }
        made.parameters = packed(made.artefact, set);
        return truth::draw(made, scene(), "lit", 64, 48);
    };
    const runtime::Picture written = drawn(false, settings), ours = drawn(true, settings);
    const double error = apart(written, ours);
    fmt::print("largest difference {:.1e}\n", error);
    EXPECT_LE(error, 1e-5);
    EXPECT_GT(apart(written, drawn(true, {})), 0.05);
    EXPECT_GT(apart(written, drawn(true, settings, "mix")), 0.01);
}

}  // namespace
}  // namespace sg::oracle
