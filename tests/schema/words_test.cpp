// Every word of the language is shown by a sample of materials/: every key and every word that a value may
// be, as the schema lists them, which is made from the compiler's tables. A word that holds where its key is
// left out need not be written.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "schema.hpp"
#include "tests/support/golden.hpp"

namespace sg {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

struct Words {
    std::set<std::string> keys;
    std::set<std::string> values;    // "kind": "noise"; of a list "": "frame"
    std::set<std::string> asked;     // of `enum` and `const`, also by what fields ask of each other
    std::set<std::string> defaults;  // which nobody has to write
};

std::string pair_of(const std::string& key, const Json& value) {
    // 0 is 0.0.
    return "\"" + key + "\": " + (value.is_number() ? Json(value.get<double>()) : value).dump();
}

// `key`: that what is looked at is the value of.
void list_words(const Json& schema, const std::string& key, Words& out) {
    if (schema.is_array()) {
        for (const Json& part : schema) list_words(part, key, out);
        return;
    }
    if (!schema.is_object()) return;
    for (const Json& word : schema.value("enum", Json::array())) {
        out.asked.insert(pair_of(key, word));
    }
    if (schema.contains("const")) out.asked.insert(pair_of(key, schema["const"]));
    if (schema.contains("default")) out.defaults.insert(pair_of(key, schema["default"]));
    for (const auto& [name, part] : schema.items()) {
        if (name == "properties" || name == "definitions") {
            for (const auto& [inner, value] : part.items()) {
                if (name == "properties") out.keys.insert(inner);
                list_words(value, name == "properties" ? inner : "", out);
            }
        } else if (name != "enum" && name != "default" && name != "const") {
            list_words(part, key, out);
        }
    }
}

void list_used(const Json& written, Words& out) {
    for (const auto& [key, value] : written.items()) {
        if (written.is_object()) out.keys.insert(key);
        if (value.is_primitive()) out.values.insert(pair_of(written.is_object() ? key : "", value));
        if (value.is_structured()) list_used(value, out);
    }
}

Words words_of_the_language() {
    Words out;
    list_words(Json::parse(schema_text()), "", out);
    std::set_difference(out.asked.begin(), out.asked.end(), out.defaults.begin(), out.defaults.end(),
                        std::inserter(out.values, out.values.end()));
    return out;
}

// Of the samples themselves, without `but`.
Words words_of_the_samples(const std::string& but = "") {
    Words out;
    for (const auto& entry : fs::directory_iterator(test::source_dir() / "materials")) {
        if (entry.path().extension() != ".json" || entry.path().filename() == but) continue;
        list_used(Json::parse(test::read_file(entry.path())), out);
    }
    return out;
}

std::set<std::string> missing(const std::set<std::string>& all, const std::set<std::string>& used) {
    std::set<std::string> out;
    std::set_difference(all.begin(), all.end(), used.begin(), used.end(), std::inserter(out, out.end()));
    return out;
}

TEST(Words, EveryOneIsShownByASample) {
    const Words all = words_of_the_language(), used = words_of_the_samples();
    EXPECT_GE(all.keys.size(), 100u);
    EXPECT_GE(all.values.size(), 90u);
    for (const std::string& key : missing(all.keys, used.keys))
        ADD_FAILURE() << "no sample has '" << key << "'";
    for (const std::string& word : missing(all.values, used.values))
        ADD_FAILURE() << "no sample says " << word;
}

// What the list above holds of each part of the language, so that a schema that is written otherwise does not
// make it empty.
TEST(Words, EachPartOfTheLanguageIsListed) {
    const Words all = words_of_the_language();
    for (const char* word :
         {R"("kind": "noise")", R"("kind": "occlusion")", R"("op": "smoothstep")",
          R"("encoding": "world_normal")", R"("function": "turbulence")", R"("shape": "wedge")",
          R"("method": "rnm")", R"("type": "vec4")", R"("wrap": "mirror")", R"("filter": "nearest")",
          R"("two_sided": "flip")", R"("lighting": "phong")", R"("returns": "surface_gradient")"})
        EXPECT_TRUE(all.values.contains(word)) << word;
    for (const char* key : {"set", "scale", "rotation", "offset", "speed", "extends", "$schema", "budget"})
        EXPECT_TRUE(all.keys.contains(key)) << key;
}

TEST(Words, OneThatNoSampleShowsIsNoticed) {
    const Words all = words_of_the_language(), fewer = words_of_the_samples("weathered_globe.json");
    EXPECT_TRUE(missing(all.values, fewer.values).contains(R"("encoding": "world_normal")"));
    EXPECT_TRUE(missing(all.keys, fewer.keys).contains("mip_filter"));
}

}  // namespace
}  // namespace sg
