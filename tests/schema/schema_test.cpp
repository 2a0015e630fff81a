// What `surfgradc schema` prints, judged by a third party's validator: every sample passes, and what the
// compiler refuses the schema refuses too, wherever a schema can say it.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include <fmt/core.h>

#include "compile.hpp"
#include "schema.hpp"
#include "tests/schema/verdicts.hpp"
#include "tests/support/golden.hpp"
#include "validator.hpp"

namespace sg {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using test::SchemaValidator;

const SchemaValidator& validator() {
    static const SchemaValidator out(schema_text());
    return out;
}

std::vector<fs::path> json_files(const char* folder) {
    std::vector<fs::path> out;
    for (const auto& entry : fs::directory_iterator(test::source_dir() / folder)) {
        if (entry.path().extension() == ".json" && entry.path().stem().extension() != ".figure")
            out.push_back(entry.path());
    }
    std::sort(out.begin(), out.end());
    return out;
}

std::vector<fs::path> samples() {
    std::vector<fs::path> out = json_files("materials");
    for (const fs::path& path : json_files("materials/figures")) out.push_back(path);
    return out;
}

// Codes and messages.
using Errors = std::set<std::pair<int, std::string>>;

// The errors in a whole text of messages.
Errors errors_of(const std::string& text) {
    Errors out;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        std::size_t at = line.rfind("[SG");
        if (line.ends_with(']') && at != std::string::npos && line.find(": error: ") < at)
            out.emplace(std::stoi(line.substr(at + 3)), line);
    }
    return out;
}

std::set<int> codes_of(const Errors& errors) {
    std::set<int> out;
    for (const auto& [code, message] : errors) out.insert(code);
    return out;
}

// One of them can be said by a schema.
bool sayable(const Errors& errors) {
    return std::any_of(errors.begin(), errors.end(), [](const auto& error) {
        const test::Verdict* row = test::find_verdict(static_cast<Code>(error.first));
        return row && row->beyond.empty() && !test::find_beyond_message(error.first, error.second);
    });
}

TEST(Schema, AcceptsEverySample) {
    std::vector<fs::path> all = samples();
    EXPECT_GE(all.size(), 40u);
    for (const fs::path& path : all)
        EXPECT_EQ(validator().refusal(test::read_file(path)), "") << path.filename();
}

// Every code is in one of the two lists, once.
TEST(Schema, EveryCodeIsPlaced) {
    std::map<Code, int> rows;
    for (const test::Verdict& row : test::verdicts()) ++rows[row.code];
    for (const CodeInfo& info : all_codes()) {
        EXPECT_EQ(rows[info.code], 1) << "SG" << static_cast<int>(info.code) << " (" << info.identifier
                                      << "): tests/schema/verdicts.cpp must say whether a schema can tell";
    }
}

// A case that is no JSON never reaches a schema. Of the others: one with a fault that a schema can say is
// refused; and each code that it cannot say has a case that passes, or the reason given for it would be
// wrong.
TEST(Schema, RefusesEachErrorThatASchemaCanSay) {
    std::set<int> refused, passed, met;
    for (const fs::path& path : json_files("tests/errors/cases")) {
        std::string name = path.stem().string(), text = test::read_file(path);
        const Errors errors =
            errors_of(test::read_file(test::source_dir() / "tests/errors/cases" / (name + ".txt")));
        const std::set<int> codes = codes_of(errors);
        EXPECT_FALSE(codes.empty()) << name;
        if (!Json::accept(text)) {
            EXPECT_FALSE(sayable(errors)) << name;
            continue;
        }
        met.insert(codes.begin(), codes.end());
        bool said = sayable(errors) && test::find_beyond_case(name) == nullptr;
        bool good = validator().refusal(text).empty();
        if (said) {
            EXPECT_FALSE(good) << name << ": the schema lets it pass";
        }
        if (test::find_beyond_case(name)) {
            EXPECT_TRUE(good) << name << ": the schema can say it after all";
        }
        (good ? passed : refused).insert(codes.begin(), codes.end());
    }
    for (const test::Verdict& row : test::verdicts()) {
        int code = static_cast<int>(row.code);
        if (row.beyond.empty()) {
            EXPECT_TRUE(refused.count(code)) << "no case of SG" << code << " is refused";
        }
        if (!row.beyond.empty() && met.count(code)) {
            EXPECT_TRUE(passed.count(code)) << "SG" << code;
        }
    }
    for (const test::BeyondCase& row : test::beyond_cases())
        EXPECT_TRUE(
            fs::exists(test::source_dir() / "tests/errors/cases" / (std::string(row.name) + ".json")));
}

// Drops `keyword` wherever the schema has it; a property of that name is an object or a schema of its own and
// stays.
std::size_t forget(Json& schema, const std::string& keyword, bool properties = false) {
    std::size_t count = 0;
    if (schema.is_object() && !properties) count += schema.erase(keyword);
    if (schema.is_structured()) {
        for (auto& [key, value] : schema.items()) {
            if (key == "if" || key == "not") continue;  // less of these is not weaker
            bool names = schema.is_object() && !properties && (key == "properties" || key == "definitions");
            count += forget(value, keyword, names);
        }
    }
    return count;
}

// What one change makes of a document.
struct Changed {
    std::string what;
    Json document;
};

void add_changes_of(const Json& document, const Json::json_pointer& at, std::vector<Changed>& out) {
    const Json& value = document.at(at);
    auto put = [&](const Json& other) {
        Changed changed{at.to_string() + " = " + other.dump(), document};
        changed.document[at] = other;
        out.push_back(std::move(changed));
    };
    if (value.is_object()) {
        Json longer = value;
        longer["zzz"] = 1;
        put(longer);
        Json renamed = value;
        renamed[std::string(65, 'z')] = value.empty() ? Json() : value.back();
        put(renamed);
        for (const auto& [key, item] : value.items()) {
            Json shorter = value;
            shorter.erase(key);
            put(shorter);
        }
        put(Json::array());
    } else if (value.is_array()) {
        Json shorter = value;
        if (!value.empty()) shorter.erase(value.size() - 1);
        put(shorter);
        put(Json::object());
    } else if (value.is_number()) {
        for (Json other : {Json(-1e9), Json(1e9), Json(1.5), Json(true), Json("word")}) put(other);
    } else {
        for (Json other :
             {Json(7), Json(""), Json("zzz"), Json("$zzz"), Json("@zzz"), Json(std::string(65, 'z'))})
            put(other);
    }
    if (!value.is_structured()) return;
    for (const auto& [key, item] : value.items()) {
        Json::json_pointer below = at;
        if (value.is_array())
            below /= static_cast<std::size_t>(std::stoul(key));
        else
            below /= key;
        add_changes_of(document, below, out);
    }
}

std::vector<Changed> changes_of(const Json& document) {
    std::vector<Changed> out;
    add_changes_of(document, Json::json_pointer(), out);
    return out;
}

// Properties without a description, by their places; what "if" and "then" ask beside it counts as no
// property.
void undescribed(const Json& schema, const std::string& at, bool names, std::size_t& count,
                 std::vector<std::string>& out) {
    if (!schema.is_structured()) return;
    for (const auto& [key, value] : schema.items()) {
        if (!names && (key == "if" || key == "then" || key == "not")) continue;
        const std::string here = at + "/" + key;
        if (names && at.ends_with("/properties")) {
            ++count;
            const auto text = value.find("description");
            if (text == value.end() || !text->is_string() || text->template get<std::string>().empty())
                out.push_back(here);
        }
        undescribed(value, here, schema.is_object() && !names && key == "properties", count, out);
    }
}

TEST(Schema, EveryPropertyIsDescribed) {
    const Json schema = Json::parse(schema_text());
    std::vector<std::string> without;
    std::size_t count = 0;
    for (const char* part : {"then", "else", "definitions"})
        undescribed(schema[part], std::string("/") + part, false, count, without);
    for (const std::string& place : without) ADD_FAILURE() << place;
    EXPECT_GT(count, 300u);
    Json bare = schema["else"];  // the walk can fail
    bare["properties"]["textures"]["additionalProperties"]["properties"]["file"].erase("description");
    undescribed(bare, "", false, count, without);
    EXPECT_EQ(without.size(), 1u);
}

// The proof can fail: without any one of its keywords the schema lets something through.
TEST(Schema, EveryKeywordIsNeeded) {
    std::vector<std::string> refused;
    for (const fs::path& path : json_files("tests/errors/cases")) refused.push_back(test::read_file(path));
    for (const char* name : {"packed", "mossy_rock"}) {
        std::string text = test::read_file(test::source_dir() / "materials" / (std::string(name) + ".json"));
        for (const Changed& changed : changes_of(Json::parse(text)))
            refused.push_back(changed.document.dump());
    }
    std::erase_if(refused, [](const std::string& text) {
        return !Json::accept(text) || validator().refusal(text).empty();
    });
    for (const char* keyword : {"additionalProperties", "additionalItems", "not", "then", "propertyNames",
                                "required", "type", "enum", "const", "minimum", "maximum", "minItems",
                                "maxItems", "minLength", "maxLength", "pattern"}) {
        Json schema = Json::parse(schema_text());
        ASSERT_GT(forget(schema, keyword), 0u) << keyword;
        SchemaValidator weak(schema.dump());
        bool passes = std::any_of(refused.begin(), refused.end(),
                                  [&](const std::string& text) { return weak.refusal(text).empty(); });
        EXPECT_TRUE(passes) << "nothing needs '" << keyword << "'";
    }
}

class Checker {
public:
    Checker() {
        for (const auto& entry : fs::recursive_directory_iterator(test::source_dir() / "materials")) {
            std::string extension = entry.path().extension().string();
            if (!entry.is_regular_file()) continue;
            bool text = extension == ".json" || extension == ".glsl";
            files_.contents[entry.path().string()] = text ? test::read_file(entry.path()) : "a picture";
        }
    }
    Errors errors(const fs::path& path, const std::string& text) {
        CompileRequest request{.source = std::make_shared<Source>(Source{path.string(), text})};
        request.stem = "case";
        request.roots = {path.parent_path(), test::source_dir() / "materials"};
        Diags diags;
        check_material(request, files_, library_, diags);
        Errors out;
        for (const Diagnostic& d : diags.all()) {
            if (d.severity == Severity::error) out.emplace(static_cast<int>(d.code), d.message);
        }
        return out;
    }

private:
    MemoryFiles files_;
    target::ShaderLibrary library_ = target::embedded_library();
};

// What no keyword compares: a parameter's default with its range, both with the fields that use it; and the
// values of an instance with the types that the material it extends declares.
bool compares_declarations(const Json& document, const Changed& changed, const std::set<int>& codes) {
    if (!changed.what.starts_with("/parameters")) return false;
    return codes == std::set<int>{1104} || (document.contains("extends") && codes == std::set<int>{1103});
}

// Each sample with one value changed: the schema refuses nothing that the compiler takes, and where a schema
// can say what is wrong, it does.
TEST(Schema, AgreesWithTheCompiler) {
    Checker checker;
    std::size_t count = 0, good = 0, refused = 0;
    for (const fs::path& path : json_files("materials")) {
        Json document = Json::parse(test::read_file(path));
        for (const Changed& changed : changes_of(document)) {
            std::string text = changed.document.dump();
            const Errors errors = checker.errors(path, text);
            const std::set<int> codes = codes_of(errors);
            std::string refusal = validator().refusal(text), found;
            for (int code : codes) found += fmt::format(" SG{}", code);
            if (codes.empty()) {
                EXPECT_EQ(refusal, "") << path.filename() << " " << changed.what;
            }
            if (sayable(errors) && !compares_declarations(document, changed, codes)) {
                EXPECT_NE(refusal, "") << path.filename() << " " << changed.what << found;
            }
            ++count;
            good += codes.empty();
            refused += !refusal.empty();
        }
    }
    printf("%zu changed materials: %zu are good, the schema refuses %zu\n", count, good, refused);
    EXPECT_GT(good, count / 20);
    EXPECT_GT(refused, count / 4);
}

// What a user's function may be handed: of an argument's form both say the same.
TEST(Schema, AgreesOnArguments) {
    Checker checker;
    const fs::path path = test::source_dir() / "materials/custom.json";
    auto agreed = [&](const std::string& argument) {
        const std::string text = R"({ "version": 1,
  "textures": { "weave": { "file": "textures/weave_normal.png", "encoding": "color" } },
  "bump": [ { "layers": [ { "kind": "custom", "file": "shaders/custom.glsl", "function": "dents",
    "returns": "volume_gradient", "arguments": [ )" +
                                 argument + " ] } ] } ] }";
        const bool good = validator().refusal(text).empty();
        for (int code : codes_of(checker.errors(path, text))) {
            if (code < 1200) {
                EXPECT_FALSE(good) << argument << ": SG" << code;
            }
        }
        return good;
    };
    for (const char* argument :
         {R"("frame")", "1", "[1, 2]", R"({ "uv": 1 })", R"({ "texture": "weave" })",
          R"({ "texture": "weave", "channel": "r" })", R"({ "uv": 1, "texture": "weave" })",
          R"({ "texture": "weave", "channel": "g", "tiling": 2 })", R"({ "op": "vertex_rgb" })"})
        EXPECT_TRUE(agreed(argument)) << argument;
    for (const char* argument : {"{ }", "[1]", R"({ "uv": 1, "channel": "r" })", R"({ "channel": "r" })",
                                 R"({ "texture": "weave", "chanel": "r" })"})
        EXPECT_FALSE(agreed(argument)) << argument;
}

}  // namespace
}  // namespace sg
