#include "json/json.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <random>

#include "tests/support/golden.hpp"

namespace sg::json {
namespace {

namespace fs = std::filesystem;

SourcePtr source(std::string text) {
    return std::make_shared<Source>(Source{"a.json", std::move(text)});
}

std::string_view text_of(const Document& document, const Value& value) {
    return std::string_view(document.source->text)
        .substr(value.span.begin, value.span.end - value.span.begin);
}

TEST(Json, EveryValueKnowsItsBytes) {
    Diags diags;
    auto document = parse(source(R"( {"a" : [1, -2.5e+3,"x\"]"], "b":{ "c":null},"d" :true } )"), diags);
    ASSERT_TRUE(document);
    const Value& root = document->root;
    EXPECT_EQ(text_of(*document, root), R"({"a" : [1, -2.5e+3,"x\"]"], "b":{ "c":null},"d" :true })");
    EXPECT_EQ(text_of(*document, *root.find("a")), R"([1, -2.5e+3,"x\"]"])");
    EXPECT_EQ(text_of(*document, root.find("a")->items[1]), "-2.5e+3");
    EXPECT_EQ(text_of(*document, root.find("a")->items[2]), R"("x\"]")");
    EXPECT_EQ(root.find("a")->items[2].string, "x\"]");
    EXPECT_EQ(text_of(*document, *root.find("b")->find("c")), "null");
    EXPECT_EQ(text_of(*document, *root.find("d")), "true");
    Span key = root.members[0].key_span;
    EXPECT_EQ(document->source->text.substr(key.begin, key.end - key.begin), "\"a\"");
}

// Random documents: each scalar carries its own text, so the span can be checked without a second parser.
class RandomJson {
public:
    explicit RandomJson(unsigned seed) : random_(seed) {}
    std::string value(int depth) {
        switch (pick(depth > 4 ? 3 : 5)) {
            case 0:
                return std::to_string(static_cast<int>(pick(2000)) - 1000);
            case 1:
                return "\"" + std::string(pick(4), 'q') + (pick(2) ? "\\\\" : "\\u00e9") + "\"";
            case 2:
                return pick(2) ? "true" : "null";
            case 3:
                return list("[", "]", [&] { return value(depth + 1); });
            default:
                return list("{", "}", [&] {
                    return "\"k" + std::to_string(keys_++) + "\"" + blank() + ":" + blank() +
                           value(depth + 1);
                });
        }
    }

private:
    std::size_t pick(std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random_); }
    std::string blank() { return std::string(pick(3), pick(2) ? ' ' : '\n'); }
    template <class Item>
    std::string list(std::string open, std::string close, Item item) {
        std::string out = open + blank();
        for (std::size_t i = 0, n = pick(4); i < n; ++i) out += (i ? "," + blank() : "") + item() + blank();
        return out + close;
    }
    std::mt19937 random_;
    int keys_ = 0;
};

void check_spans(const Document& document, const Value& value) {
    std::string_view text = text_of(document, value);
    Diags diags;
    auto again = parse(source(std::string(text)), diags);
    ASSERT_TRUE(again) << text;
    EXPECT_EQ(again->root.span, (Span{0, static_cast<std::uint32_t>(text.size())})) << text;
    EXPECT_EQ(again->root.kind, value.kind) << text;
    EXPECT_EQ(again->root.items.size(), value.items.size());
    for (const Value& item : value.items) check_spans(document, item);
    for (const Member& member : value.members) check_spans(document, member.value);
}

TEST(Json, RandomDocumentsKeepTheirPlaces) {
    unsigned seed = std::random_device{}();
    SCOPED_TRACE("seed " + std::to_string(seed));
    for (unsigned i = 0; i < 200; ++i) {
        Diags diags;
        auto document = parse(source(RandomJson(seed + i).value(0)), diags);
        ASSERT_TRUE(document) << render(diags);
        check_spans(*document, document->root);
    }
}

TEST(Json, DepthIsLimitedNotTheStack) {
    Diags diags;
    EXPECT_FALSE(parse(source(std::string(1000000, '[')), diags));
    EXPECT_EQ(diags.all()[0].message, "nested deeper than 128 levels");
    EXPECT_EQ(diags.all()[0].place.span, (Span{128, 129}));
    EXPECT_EQ(diags.all()[0].code, Code::json_limit);
}

TEST(Json, PointerStepsEscape) {
    EXPECT_EQ(pointer_step("a/b~c"), "/a~1b~0c");
}

// The conformance suite: y_ must parse, n_ must be refused with a place; nothing crashes.
TEST(Json, ConformanceSuite) {
    fs::path dir = test::source_dir() / "../shared/data/json/JSONTestSuite";
    if (!fs::exists(dir)) GTEST_SKIP() << "the JSON conformance suite is not on this machine";
    int accepted = 0, refused = 0;
    for (const auto& entry : fs::recursive_directory_iterator(dir)) {
        std::string name = entry.path().filename().string();
        if (entry.path().extension() != ".json") continue;
        Diags diags;
        auto document = parse(source(test::read_file(entry.path())), diags);
        EXPECT_EQ(document.has_value(), !diags.has_errors()) << name;
        // A repeated key is valid JSON of no defined meaning; a material must not have one.
        bool duplicate = diags.has_errors() && diags.all()[0].code == Code::json_duplicate_key;
        if (name.starts_with("y_")) {
            EXPECT_TRUE(document || duplicate) << name << "\n" << render(diags);
            ++accepted;
        } else if (name.starts_with("n_")) {
            EXPECT_FALSE(document) << name;
            EXPECT_TRUE(document || diags.all()[0].place.source) << name;
            ++refused;
        }
    }
    EXPECT_GT(accepted, 50);
    EXPECT_GT(refused, 100);
}

}  // namespace
}  // namespace sg::json
