#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <charconv>

#include "ir/lighting.hpp"
#include "ir/text.hpp"

namespace sg::ir {
namespace {

struct LineReader {
    std::string_view rest;
    std::string fault;

    void fail(std::string what) {
        if (fault.empty()) fault = std::move(what);
    }

    void skip_blanks() {
        while (!rest.empty() && (rest.front() == ' ' || rest.front() == '\t')) rest.remove_prefix(1);
        if (!rest.empty() && rest.front() == '#') rest = {};
    }

    bool at_end() {
        skip_blanks();
        return rest.empty();
    }

    bool accept(char c) {
        skip_blanks();
        if (rest.empty() || rest.front() != c) return false;
        rest.remove_prefix(1);
        return true;
    }

    void expect(char c) {
        if (!accept(c)) fail(fmt::format("expected '{}' before '{}'", c, rest));
    }

    std::string_view word() {
        skip_blanks();
        std::size_t n = 0;
        while (n < rest.size() && (std::isalnum(static_cast<unsigned char>(rest[n])) || rest[n] == '_')) ++n;
        std::string_view out = rest.substr(0, n);
        rest.remove_prefix(n);
        if (out.empty()) fail(fmt::format("expected a word before '{}'", rest));
        return out;
    }

    template <class T>
    T number() {
        skip_blanks();
        T out{};
        auto [end, ec] = std::from_chars(rest.data(), rest.data() + rest.size(), out);
        if (ec != std::errc{}) {
            fail(fmt::format("expected a number before '{}'", rest));
            return out;
        }
        rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
        return out;
    }

    ValueId value_id() {
        expect('%');
        return {number<std::uint32_t>()};
    }

    std::string quoted(char quote) {
        expect(quote);
        std::string out;
        while (!rest.empty() && rest.front() != quote) {
            if (rest.front() == '\\' && rest.size() >= 4 && rest[1] == 'x') {
                int code = 0;
                std::from_chars(rest.data() + 2, rest.data() + 4, code, 16);
                out += static_cast<char>(code);
                rest.remove_prefix(4);
                continue;
            }
            if (rest.front() == '\\' && rest.size() >= 2) rest.remove_prefix(1);
            out += rest.front();
            rest.remove_prefix(1);
        }
        expect(quote);
        return out;
    }
};

template <class Table, class Name>
std::optional<std::size_t> index_of(const Table& table, std::string_view word, Name name) {
    for (std::size_t i = 0; i < table.size(); ++i) {
        if (name(table[i]) == word) return i;
    }
    return std::nullopt;
}

class Parser {
public:
    bool line(std::string_view text, std::string& fault) {
        LineReader in{text, ""};
        if (!in.at_end()) {
            if (in.rest.front() == '%') {
                value(in, module.values, layer_);
            } else {
                statement(in);
            }
            if (!in.at_end()) in.fail(fmt::format("unexpected '{}'", in.rest));
        }
        fault = in.fault;
        return fault.empty();
    }
    Module module;

private:
    Type type(LineReader& in) {
        std::string_view word = in.word();
        auto i = index_of(all_types(), word, [](const TypeInfo& t) { return t.name; });
        if (!i) in.fail(fmt::format("unknown type '{}'", word));
        return i ? static_cast<Type>(*i) : Type::Any;
    }

    void statement(LineReader& in) {
        std::string_view word = in.word();
        if (word == "module") {
            module.name = in.quoted('"');
        } else if (word == "lighting") {
            std::string_view name = in.word();
            auto model = find_lighting_model(name);
            if (!model) in.fail(fmt::format("unknown lighting model '{}'", name));
            module.lighting = model.value_or(0);
        } else if (word == "texture") {
            texture(in);
        } else if (word == "parameter") {
            if (in.number<std::size_t>() != module.parameters.size())
                in.fail("parameters must be numbered in order");
            std::string name = in.quoted('"');
            in.expect(':');
            module.parameters.push_back({std::move(name), type(in)});
            if (!in.at_end()) {
                const auto lowest = in.number<double>();
                module.parameters.back().range = {lowest, in.number<double>()};
            }
        } else if (word == "host") {
            value(in, module.host, {});
        } else if (word == "derived") {
            derived(in);
        } else if (word == "shader") {
            if (in.number<std::size_t>() != module.shaders.size())
                in.fail("shaders must be numbered in order");
            module.shaders.push_back({in.quoted('"'), "", {}});
        } else if (word == "function") {
            function(in);
        } else if (word == "layer") {
            layer(in);
        } else if (word == "output") {
            output(in);
        } else {
            in.fail(fmt::format("unknown statement '{}'", word));
        }
    }

    void texture(LineReader& in) {
        if (in.number<std::size_t>() != module.textures.size()) in.fail("textures must be numbered in order");
        std::string name = in.quoted('"');
        std::string_view encoding = in.word();
        auto i = index_of(encoding_names(), encoding, [](std::string_view n) { return n; });
        if (!i) in.fail(fmt::format("unknown encoding '{}'", encoding));
        module.textures.push_back({std::move(name), static_cast<TextureEncoding>(i.value_or(0))});
    }

    void derived(LineReader& in) {
        if (in.number<std::size_t>() != module.derived.size()) in.fail("derived must be numbered in order");
        Derived found{in.quoted('"'), Type::Any, {}};
        in.expect(':');
        found.type = type(in);
        in.expect('=');
        found.host = in.value_id();
        if (!in.at_end()) {
            found.positive = in.word() == "positive";
            if (!found.positive) in.fail("expected 'positive' or nothing");
        }
        module.derived.push_back(std::move(found));
    }

    void function(LineReader& in) {
        if (in.number<std::size_t>() != module.functions.size())
            in.fail("functions must be numbered in order");
        Function found{.name = in.quoted('"'), .shader = in.number<std::uint32_t>(), .arguments = {}};
        while (in.fault.empty() && !in.at_end()) {
            if (in.rest.starts_with("texture ")) {
                in.word();
                found.arguments.push_back({Type::Any, {in.number<std::uint32_t>()}});
            } else {
                found.arguments.push_back({type(in), {}});
            }
        }
        module.functions.push_back(std::move(found));
    }

    void layer(LineReader& in) {
        in.skip_blanks();
        if (!in.rest.starts_with('"')) {
            if (in.word() != "none") in.fail("expected a quoted id or 'none'");
            layer_ = {};
            return;
        }
        layer_ = named_layer(in);
    }

    LayerId named_layer(LineReader& in) {
        Layer found{in.quoted('"'), std::string(in.word())};
        in.skip_blanks();
        if (in.rest.starts_with("in ")) {
            in.word();
            in.skip_blanks();
            found.group = in.quoted('"');
        }
        auto i = index_of(module.layers, found.id, [](const Layer& l) { return std::string_view(l.id); });
        if (!i) module.layers.push_back(found);
        return {static_cast<std::uint32_t>(i.value_or(module.layers.size() - 1))};
    }

    void output(LineReader& in) {
        std::string_view word = in.word();
        auto i = index_of(all_outputs(), word, [](Output o) { return output_name(o); });
        if (!i) return in.fail(fmt::format("unknown output '{}'", word));
        OutputBinding binding{.output = all_outputs()[*i]};
        if (binding.output == Output::layer) {
            binding.set = named_layer(in).index;
        } else if (is_numbered(binding.output)) {
            binding.set = in.number<std::uint32_t>();
        }
        in.expect('=');
        binding.value = in.value_id();
        module.outputs.push_back(binding);
    }

    void attribute(LineReader& in, Value& value, Attribute kind) {
        if (is_index(kind)) {
            value.index = in.number<std::uint32_t>();
        } else if (kind == Attribute::Zero) {
            value.number[0] = in.number<double>();
        } else if (kind == Attribute::Number) {
            for (std::size_t i = 0; !in.at_end() && in.rest.front() != ':'; ++i) {
                if (i == value.number.size()) return in.fail("a constant has at most 4 numbers");
                value.number[i] = in.number<double>();
                if (!in.fault.empty()) return;
            }
        }
    }

    void value(LineReader& in, std::vector<Value>& list, LayerId in_layer) {
        if (in.value_id().index != list.size()) in.fail("values must be numbered in order");
        in.expect('=');
        std::string_view word = in.word();
        auto op = index_of(all_ops(), word, [](const OpInfo& o) { return o.name; });
        if (!op) return in.fail(fmt::format("unknown operation '{}'", word));
        Value value{.op = static_cast<Op>(*op), .layer = in_layer};
        attribute(in, value, info(value.op).attribute);
        while (in.fault.empty() && !in.at_end() && in.rest.front() == '%')
            value.operands.push_back(in.value_id());
        in.expect(':');
        value.type = type(in);
        value.is_node = !in.at_end() && in.rest.front() == '"';
        if (value.is_node) value.name = in.quoted('"');
        if (!in.at_end() && in.rest.front() == '\'') value.name = in.quoted('\'');
        list.push_back(std::move(value));
    }

    LayerId layer_;
};

// The statements of a text, one line at a time.
struct Lines {
    std::string_view text;
    Span line;
    std::size_t number = 0;
    std::size_t next = 0;

    bool advance() {
        if (next >= text.size()) return false;
        const std::size_t begin = next, end = std::min(text.find('\n', begin), text.size());
        next = end + 1;
        ++number;
        line = {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)};
        return true;
    }
    [[nodiscard]] std::string_view statement() const {
        return text.substr(line.begin, line.end - line.begin);
    }
};

// Where the statements stand that faults may be of.
struct Places {
    std::vector<Span> values, host, derived, outputs;

    void note(const Module& module, Span line) {
        values.resize(module.values.size(), line);
        host.resize(module.host.size(), line);
        derived.resize(module.derived.size(), line);
        outputs.resize(module.outputs.size(), line);
    }
    [[nodiscard]] Span of(ModuleFault::Where where) const {
        const std::vector<Span>* lists[] = {&values, &host, &derived, &outputs};
        return (*lists[static_cast<std::size_t>(where.of)])[where.index];
    }
};

// What an error underlines: the line without the blanks around it.
Span shown(std::string_view text, Span line) {
    while (line.begin < line.end && text[line.begin] == ' ') ++line.begin;
    while (line.end > line.begin && (text[line.end - 1] == ' ' || text[line.end - 1] == '\r')) --line.end;
    return line;
}

}  // namespace

std::optional<Module> parse(std::string_view text, std::string& fault) {
    Parser parser;
    for (Lines lines{text}; lines.advance();) {
        std::string why;
        if (parser.line(lines.statement(), why)) continue;
        fault = fmt::format("line {}: {}", lines.number, why);
        return std::nullopt;
    }
    return std::move(parser.module);
}

std::optional<Module> read(const SourcePtr& source, Diags& diags) {
    auto error = [&](Span line, std::string what) {
        auto control = [](char c) { return static_cast<unsigned char>(c) < 0x20u || c == '\x7F'; };
        std::replace_if(what.begin(), what.end(), control, '?');
        diags.error(Code::module_fault, {source, shown(source->text, line), ""}, std::move(what));
    };
    Parser parser;
    Places places;
    for (Lines lines{source->text}; lines.advance();) {
        std::string why;
        if (!parser.line(lines.statement(), why)) {
            error(lines.line, why);
            return std::nullopt;
        }
        places.note(parser.module, lines.line);
    }
    const std::vector<ModuleFault> faults = faults_of(parser.module);
    for (const ModuleFault& fault : faults) error(places.of(fault.where), fault.what);
    if (!faults.empty()) return std::nullopt;
    return std::move(parser.module);
}

}  // namespace sg::ir
