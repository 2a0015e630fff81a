#include "runtime/proof/figure.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "json/json.hpp"

namespace sg::proof {
namespace {

using json::Kind;
using json::Value;

// An object that is being read: which keys it may have, and every fault with its place.
class Reader {
public:
    Reader(const SourcePtr& source, const Value& object, std::string what, Diags& diags)
        : source_(source), object_(object), what_(std::move(what)), diags_(diags) {
        if (object.kind != Kind::object) wrong(object, "an object");
    }

    // Null where the key is absent; an error where it must be there, or has another kind.
    const Value* get(std::string_view key, Kind kind, bool required = false) {
        known_.push_back(key);
        const Value* value = object_.kind == Kind::object ? object_.find(key) : nullptr;
        if (!value && required && object_.kind == Kind::object)
            diags_.error(Code::missing_key, place(object_), fmt::format("{} needs the key '{}'", what_, key));
        if (value && value->kind != kind) {
            wrong(*value, std::string(json::kind_name(kind)));
            return nullptr;
        }
        return value;
    }
    bool flag(std::string_view key) {
        const Value* value = get(key, Kind::boolean);
        return value && value->boolean;
    }
    std::string text(std::string_view key, bool required = false) {
        const Value* value = get(key, Kind::string, required);
        return value ? value->string : "";
    }
    double number(std::string_view key, double fallback, double least, double most) {
        const Value* value = get(key, Kind::number);
        if (!value) return fallback;
        if (!(value->number >= least && value->number <= most))
            diags_.error(
                Code::out_of_range, place(*value),
                fmt::format("'{}' must be from {:g} to {:g}, not {:g}", key, least, most, value->number));
        return value->number;
    }
    std::vector<double> numbers(std::string_view key, std::size_t count, bool required = false) {
        const Value* value = get(key, Kind::array, required);
        std::vector<double> out;
        if (!value) return out;
        for (const Value& item : value->items) out.push_back(item.kind == Kind::number ? item.number : NAN);
        if (out.size() == count &&
            std::none_of(out.begin(), out.end(), [](double x) { return std::isnan(x); }))
            return out;
        wrong(*value, fmt::format("{} numbers", count));
        return {};
    }
    std::optional<glm::dvec3> vector(std::string_view key, bool required = false) {
        const std::vector<double> n = numbers(key, 3, required);
        if (n.empty()) return std::nullopt;
        return glm::dvec3(n[0], n[1], n[2]);
    }
    std::vector<std::string> texts(std::string_view key) {
        const Value* value = get(key, Kind::array);
        std::vector<std::string> out;
        if (!value) return out;
        for (const Value& item : value->items) {
            if (item.kind == Kind::string) out.push_back(item.string);
            if (item.kind != Kind::string) wrong(item, "a string");
        }
        return out;
    }
    Place place(const Value& value) const { return {source_, value.span}; }
    void finish() {
        for (const json::Member& member : object_.members) {
            if (std::find(known_.begin(), known_.end(), member.key) != known_.end()) continue;
            diags_.error(Code::unknown_key, Place{source_, member.key_span},
                         fmt::format("unknown key '{}' in {}{}", printable(member.key), what_,
                                     did_you_mean(member.key, known_)));
        }
    }

private:
    void wrong(const Value& value, const std::string& expected) {
        diags_.error(Code::wrong_type, place(value),
                     fmt::format("expected {}, not {}", expected, json::kind_name(value.kind)));
    }

    const SourcePtr& source_;
    const Value& object_;
    std::string what_;
    Diags& diags_;
    std::vector<std::string_view> known_;
};

std::optional<runtime::Camera> read_camera(const SourcePtr& source, const Value& value, Diags& diags) {
    Reader reader(source, value, "a camera", diags);
    runtime::Camera out;
    out.position = reader.vector("position", true).value_or(out.position);
    out.target = reader.vector("target", true).value_or(out.target);
    out.fov_degrees = reader.number("fov", 30, 0.1, 170);
    out.ortho_height = reader.number("ortho", 0, 0, 1e6);
    reader.finish();
    return out;
}

FigurePicture read_picture(const SourcePtr& source, const Value& value, Diags& diags) {
    Reader reader(source, value, "a picture", diags);
    FigurePicture out{reader.text("id", true), reader.text("material", true), reader.text("label", true),
                      reader.texts("parameters")};
    reader.finish();
    return out;
}

void check_word(Reader& reader, const SourcePtr& source, const Value& object, std::string_view key,
                const std::vector<std::string_view>& words, Diags& diags) {
    const Value* value = reader.get(key, Kind::string);
    if (!value || std::find(words.begin(), words.end(), value->string) != words.end()) return;
    static_cast<void>(object);
    diags.error(Code::unknown_choice, Place{source, value->span},
                fmt::format("unknown {} '{}', expected {}{}", key, printable(value->string), one_of(words),
                            did_you_mean(value->string, words)));
}

Claim read_claim(const SourcePtr& source, const Value& value, const Figure& figure, Diags& diags) {
    static constexpr std::array<std::string_view, 4> kKinds = {"below", "above", "times", "apart"};
    Reader reader(source, value, "a claim", diags);
    Claim out;
    out.place = reader.place(value);
    out.text = reader.text("text", true);
    out.picture = reader.text("picture", true);
    if (const std::string number = reader.text("number"); !number.empty()) out.number = number;
    out.held = reader.flag("held");
    if (out.held && !figure.held)
        diags.error(Code::missing_key, out.place,
                    "a claim about held weights needs \"held\": true in 'truth'");
    out.beyond = reader.flag("beyond");
    out.tilted = reader.number("tilted", 0, 0, 90);
    if ((out.beyond || out.tilted > 0) && figure.truth.empty())
        diags.error(Code::missing_key, out.place, "a claim about single pixels needs the key 'truth'");
    std::size_t kinds = 0;
    for (std::size_t i = 0; i < kKinds.size(); ++i) {
        const Value* limit = reader.get(kKinds[i], Kind::number);
        if (!limit) continue;
        ++kinds;
        out.kind = static_cast<Claim::Kind>(i);
        out.value = limit->number;
    }
    const bool pair = out.kind == Claim::Kind::times || out.kind == Claim::Kind::apart;
    out.other = reader.text(out.kind == Claim::Kind::apart ? "from" : "than", pair);
    std::vector<std::string_view> ids;
    for (const FigurePicture& picture : figure.pictures) ids.push_back(picture.id);
    check_word(reader, source, value, "picture", ids, diags);
    if (pair) check_word(reader, source, value, out.kind == Claim::Kind::apart ? "from" : "than", ids, diags);
    check_word(reader, source, value, "number", {"median", "p95", "p99", "max"}, diags);
    if (kinds != 1)
        diags.error(Code::missing_key, out.place,
                    "a claim needs exactly one of 'below', 'above', 'times' and 'apart'");
    reader.finish();
    return out;
}

void read_truth(const SourcePtr& source, const Value& value, Figure& out, Diags& diags) {
    Reader reader(source, value, "the truth", diags);
    out.truth = reader.text("material", true);
    out.heights = reader.texts("heights");
    out.truth_parameters = reader.texts("parameters");
    out.held = reader.flag("held");
    reader.finish();
}

}  // namespace

std::optional<Figure> read_figure(const std::filesystem::path& file, Files& files, Diags& diags) {
    auto text = read_or_report(files, file, diags);
    if (!text) return std::nullopt;
    const auto document =
        json::parse(std::make_shared<Source>(Source{file.string(), std::move(*text)}), diags);
    if (!document) return std::nullopt;
    const SourcePtr& source = document->source;
    const std::size_t before = diags.error_count();
    Reader reader(source, document->root, "a figure", diags);
    Figure out;
    out.name = file.stem().stem().string();
    out.folder = file.parent_path();
    out.title = reader.text("title", true);
    out.source = reader.text("source");
    out.text = reader.text("text", true);
    out.mesh = reader.text("mesh", true);
    out.detail = static_cast<std::uint32_t>(reader.number("detail", 1, 1, 16));
    if (const auto size = reader.numbers("size", 2); !size.empty()) {
        out.width = static_cast<std::uint32_t>(std::clamp(size[0], 1.0, 4096.0));
        out.height = static_cast<std::uint32_t>(std::clamp(size[1], 1.0, 4096.0));
    }
    out.light = reader.vector("light");
    if (const Value* camera = reader.get("camera", Kind::object))
        out.camera = read_camera(source, *camera, diags);
    out.materials = out.folder / reader.text("materials");
    if (const Value* truth = reader.get("truth", Kind::object)) read_truth(source, *truth, out, diags);
    if (const Value* pictures = reader.get("pictures", Kind::array, true)) {
        for (const Value& picture : pictures->items)
            out.pictures.push_back(read_picture(source, picture, diags));
    }
    if (const Value* claims = reader.get("claims", Kind::array)) {
        for (const Value& claim : claims->items) out.claims.push_back(read_claim(source, claim, out, diags));
    }
    reader.finish();
    if (diags.error_count() > before) return std::nullopt;
    return out;
}

}  // namespace sg::proof
