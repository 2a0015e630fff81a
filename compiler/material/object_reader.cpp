#include "material/object_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace sg::material {

using json::Kind;
using json::Value;

ObjectReader::ObjectReader(SourcePtr source, const Value& value, std::string pointer, std::string what,
                           std::vector<std::string_view> keys, Diags& diags)
    : source_(std::move(source)), at_{value.span, std::move(pointer)}, what_(std::move(what)), diags_(diags) {
    if (value.kind != Kind::object) {
        error(Code::wrong_type, at_,
              fmt::format("expected an object for {}, found {}", what_, kind_name(value.kind)));
        return;
    }
    object_ = &value;
    for (const json::Member& member : value.members) {
        by_key_.emplace(member.key, &member.value);
        if (keys.empty() || std::find(keys.begin(), keys.end(), member.key) != keys.end()) continue;
        std::string hint = did_you_mean(member.key, keys);
        if (hint.empty()) hint = fmt::format(", expected {}", one_of(keys));
        error(Code::unknown_key, {member.key_span, at_.pointer + json::pointer_step(member.key)},
              fmt::format("unknown key '{}' in {}{}", printable(member.key), what_, hint));
    }
}

At ObjectReader::at(std::string_view key, const Value& value) const {
    return {value.span, at_.pointer + json::pointer_step(key)};
}

const Value* ObjectReader::get(std::string_view key, bool required) {
    if (!object_) return nullptr;
    const auto found = by_key_.find(key);
    const Value* value = found == by_key_.end() ? nullptr : found->second;
    if (!value && required) {
        Span brace{at_.span.begin, at_.span.begin + 1};
        error(Code::missing_key, {brace, at_.pointer}, fmt::format("{} needs the key '{}'", what_, key));
    }
    return value;
}

namespace {

// What was found; of a reference that may not stand there, that it may not.
std::string found_there(const Value& value, bool parameters = false, bool nodes = false) {
    const bool text = value.kind == Kind::string;
    if (text && !parameters && value.string.starts_with('$'))
        return fmt::format("\"{}\" (this takes no parameter)", printable(value.string));
    if (text && !nodes && value.string.starts_with('@'))
        return fmt::format("\"{}\" (this takes no node)", printable(value.string));
    return std::string(kind_name(value.kind));
}

}  // namespace

const Value* ObjectReader::expect(std::string_view key, Kind kind, bool required) {
    const Value* value = get(key, required);
    if (!value || value->kind == kind) return value;
    error(Code::wrong_type, at(key, *value),
          fmt::format("expected {} for '{}', found {}", kind_name(kind), key, found_there(*value)));
    return nullptr;
}

std::optional<std::string> ObjectReader::string(std::string_view key, bool required) {
    const Value* value = expect(key, Kind::string, required);
    return value ? std::optional(value->string) : std::nullopt;
}

bool ObjectReader::check_name(const std::string& name, const At& at) {
    bool printable_text = std::none_of(
        name.begin(), name.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20u || c == 0x7F; });
    if (!name.empty() && name.size() <= 64 && printable_text) return true;
    error(Code::bad_name, at,
          name.empty() ? std::string("a name must not be empty")
                       : fmt::format("bad name '{}', expected 1 to 64 bytes without control characters",
                                     printable(name)));
    return false;
}

bool ObjectReader::check_own_name(const std::string& name, const At& at) {
    if (!check_name(name, at)) return false;
    if (name[0] != '$' && name[0] != '@') return true;
    error(Code::bad_name, at,
          fmt::format("bad name '{}', expected one that does not start with '$', which leads to a parameter, "
                      "or '@', which leads to a node",
                      printable(name)));
    return false;
}

Located<std::string> ObjectReader::id() {
    std::optional<std::string> text = string("id");
    if (!text) return {};
    At place = at("id", *get("id"));
    if (!check_own_name(*text, place)) return {};
    return {std::move(*text), std::move(place)};
}

std::optional<std::string> ObjectReader::name(std::string_view key, bool required) {
    std::optional<std::string> text = string(key, required);
    if (text && !check_name(*text, at(key, *object_->find(key)))) return std::nullopt;
    return text;
}

std::optional<std::string> ObjectReader::name_of_file(std::string_view key) {
    std::optional<std::string> text = string(key, true);
    if (!text || !text->empty()) return text;
    error(Code::file_missing, at(key, *object_->find(key)), "file '' does not exist, expected a path");
    return std::nullopt;
}

std::optional<bool> ObjectReader::boolean(std::string_view key) {
    const Value* value = expect(key, Kind::boolean, false);
    return value ? std::optional(value->boolean) : std::nullopt;
}

bool ObjectReader::in_range(std::string_view key, const Value& value, Range range) {
    if (value.number >= range.minimum && value.number <= range.maximum) return true;
    error(Code::out_of_range, at(key, value),
          fmt::format("'{}' is {}, expected {} to {}", key, value.number, range.minimum, range.maximum));
    return false;
}

std::optional<double> ObjectReader::number(std::string_view key, Range range, bool required) {
    const Value* value = expect(key, Kind::number, required);
    if (!value || !in_range(key, *value, range)) return std::nullopt;
    return value->number;
}

std::optional<std::uint32_t> ObjectReader::integer(std::string_view key, Range range, bool required,
                                                   std::string_view expected) {
    const Value* value = get(key, required);
    if (!value) return std::nullopt;
    if (value->kind != Kind::number) {
        error(Code::wrong_type, at(key, *value),
              fmt::format("expected {} for '{}', found {}", expected, key, found_there(*value)));
        return std::nullopt;
    }
    if (value->number != std::floor(value->number)) {
        error(Code::wrong_type, at(key, *value),
              fmt::format("expected an integer for '{}', found {}", key, value->number));
        return std::nullopt;
    }
    if (!in_range(key, *value, range)) return std::nullopt;
    return static_cast<std::uint32_t>(value->number);
}

std::optional<std::size_t> ObjectReader::choice(std::string_view key,
                                                std::initializer_list<std::string_view> choices,
                                                bool required) {
    return choice(key, std::span(choices.begin(), choices.size()), required);
}

std::optional<std::size_t> ObjectReader::choice(std::string_view key,
                                                std::span<const std::string_view> choices, bool required) {
    const Value* value = get(key, required);
    if (!value) return std::nullopt;
    if (value->kind != Kind::string) {
        error(Code::wrong_type, at(key, *value),
              fmt::format("expected {} for '{}', found {}", one_of(choices), key, found_there(*value)));
        return std::nullopt;
    }
    auto it = std::find(choices.begin(), choices.end(), value->string);
    if (it != choices.end()) return static_cast<std::size_t>(it - choices.begin());
    error(Code::unknown_choice, at(key, *value),
          fmt::format("unknown value '{}' for '{}', expected {}{}", printable(value->string), key,
                      one_of(choices), did_you_mean(value->string, choices)));
    return std::nullopt;
}

std::optional<double> ObjectReader::one_of_numbers(std::string_view key,
                                                   std::initializer_list<double> choices) {
    const Value* value = expect(key, Kind::number, false);
    if (!value) return std::nullopt;
    if (std::find(choices.begin(), choices.end(), value->number) != choices.end()) return value->number;
    error(Code::out_of_range, at(key, *value),
          fmt::format("'{}' is {}, expected one of {}", key, value->number, fmt::join(choices, ", ")));
    return std::nullopt;
}

std::optional<std::vector<double>> ObjectReader::numbers(std::string_view key, std::size_t count, Range range,
                                                         bool spread, std::string_view others) {
    const Value* value = get(key);
    if (!value) return std::nullopt;
    if (value->kind == Kind::number && (spread || count == 1)) {
        if (!in_range(key, *value, range)) return std::nullopt;
        return std::vector<double>(count, value->number);
    }
    bool numeric = value->kind == Kind::array && value->items.size() == count && count > 1 &&
                   std::all_of(value->items.begin(), value->items.end(),
                               [](const Value& v) { return v.kind == Kind::number; });
    if (!numeric) {
        std::string expected = count == 1
                                   ? "a number"
                                   : fmt::format("{}an array of {} numbers",
                                                 !spread                                      ? ""
                                                 : others.find(',') == std::string_view::npos ? "a number or "
                                                                                              : "a number, ",
                                                 count);
        std::string found = value->kind == Kind::array && count > 1
                                ? fmt::format("an array of {} values", value->items.size())
                                : found_there(*value, others.find("$parameter") != others.npos,
                                              others.find("@node") != others.npos);
        if (value->kind == Kind::array && count > 1 && value->items.size() == count)
            found = "an array that holds other things";
        error(Code::wrong_type, at(key, *value),
              fmt::format("expected {}{}{} for '{}', found {}", expected,
                          others.empty()                               ? ""
                          : others.find(',') == std::string_view::npos ? " or "
                                                                       : ", ",
                          others, key, found));
        return std::nullopt;
    }
    bool good = true;
    std::vector<double> out;
    for (const Value& item : value->items) {
        good = in_range(key, item, range) && good;
        out.push_back(item.number);
    }
    return good ? std::optional(out) : std::nullopt;
}

std::vector<std::pair<const Value*, std::string>> ObjectReader::array(std::string_view key, bool required) {
    std::vector<std::pair<const Value*, std::string>> out;
    const Value* value = expect(key, Kind::array, required);
    for (std::size_t i = 0; value && i < value->items.size(); ++i) {
        out.emplace_back(&value->items[i], fmt::format("{}{}/{}", at_.pointer, json::pointer_step(key), i));
    }
    return out;
}

std::vector<std::pair<const json::Member*, std::string>> ObjectReader::named(std::string_view key) {
    std::vector<std::pair<const json::Member*, std::string>> out;
    const Value* value = expect(key, Kind::object, false);
    for (std::size_t i = 0; value && i < value->members.size(); ++i) {
        const json::Member& member = value->members[i];
        std::string pointer = at_.pointer + json::pointer_step(key) + json::pointer_step(member.key);
        if (check_own_name(member.key, {member.key_span, pointer}))
            out.emplace_back(&member, std::move(pointer));
    }
    return out;
}

}  // namespace sg::material
