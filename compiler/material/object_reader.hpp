// Reads one JSON object against the list of its keys. Every fault is reported; a getter that fails gives
// nothing.
#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "base/diag.hpp"
#include "json/json.hpp"
#include "material/material.hpp"

namespace sg::material {

struct Range {
    double minimum;
    double maximum;
};

class ObjectReader {
public:
    // `what` names the object in messages: "a texture". `keys`: those that may stand in it; none for any. A
    // value that is no object is reported; then every getter gives nothing and reports no more.
    ObjectReader(SourcePtr source, const json::Value& value, std::string pointer, std::string what,
                 std::vector<std::string_view> keys, Diags& diags);

    [[nodiscard]] bool ok() const { return object_ != nullptr; }
    [[nodiscard]] At at() const { return at_; }
    [[nodiscard]] At at(std::string_view key, const json::Value& value) const;

    // The value of a key, or null; an absent required key is reported.
    const json::Value* get(std::string_view key, bool required = false);

    std::optional<std::string> string(std::string_view key, bool required = false);
    // A string of 1 to 64 printable characters.
    std::optional<std::string> name(std::string_view key, bool required = false);
    // What the key "id" gives this object as its name; empty without one.
    Located<std::string> id();
    // A path: any string but an empty one.
    std::optional<std::string> name_of_file(std::string_view key);
    std::optional<bool> boolean(std::string_view key);
    std::optional<double> number(std::string_view key, Range range, bool required = false);
    std::optional<std::uint32_t> integer(std::string_view key, Range range, bool required = false,
                                         std::string_view expected = "a number");
    // The index of the word among the choices.
    std::optional<std::size_t> choice(std::string_view key, std::initializer_list<std::string_view> choices,
                                      bool required = false);
    std::optional<std::size_t> choice(std::string_view key, std::span<const std::string_view> choices,
                                      bool required);
    // One of several numbers.
    std::optional<double> one_of_numbers(std::string_view key, std::initializer_list<double> choices);
    // `count` numbers, or where `spread` one number for all. `others`: what else may stand there, for the
    // message.
    std::optional<std::vector<double>> numbers(std::string_view key, std::size_t count, Range range,
                                               bool spread, std::string_view others);
    // The items of an array, each with its pointer.
    std::vector<std::pair<const json::Value*, std::string>> array(std::string_view key,
                                                                  bool required = false);
    // The members of an object of named things; bad names are reported.
    std::vector<std::pair<const json::Member*, std::string>> named(std::string_view key);

    void error(Code code, const At& at, std::string message) {
        diags_.error(code, {source_, at.span, at.pointer}, std::move(message));
    }
    bool check_name(const std::string& name, const At& at);
    // Of what the material declares: '$' and '@' lead to parameters and nodes.
    bool check_own_name(const std::string& name, const At& at);

private:
    const json::Value* expect(std::string_view key, json::Kind kind, bool required);
    bool in_range(std::string_view key, const json::Value& value, Range range);

    SourcePtr source_;
    const json::Value* object_ = nullptr;
    std::unordered_map<std::string_view, const json::Value*> by_key_;  // objects may have thousands
    At at_;
    std::string what_;
    Diags& diags_;
};

}  // namespace sg::material
