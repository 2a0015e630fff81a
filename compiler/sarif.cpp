#include "sarif.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "artefact.hpp"

namespace sg {
namespace {

using Json = nlohmann::ordered_json;

// A file's name as part of a URI: RFC 3986 leaves these characters as they are.
std::string uri(std::string_view name) {
    std::string out;
    for (char c : name) {
        bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                     std::string_view("-._~/").find(c) != std::string_view::npos;
        out += plain ? std::string(1, c)
                     : fmt::format("%{:02X}", static_cast<unsigned>(static_cast<unsigned char>(c)));
    }
    return out;
}

Json location(const Place& place) {
    LineColumn at = line_column(place.source->text, place.span.begin);
    LineColumn end = line_column(place.source->text, place.span.end);
    Json out;
    out["physicalLocation"] = {{"artifactLocation", {{"uri", uri(place.source->name)}}},
                               {"region",
                                {{"startLine", at.line},
                                 {"startColumn", at.column},
                                 {"endLine", end.line},
                                 {"endColumn", end.column},
                                 {"byteOffset", place.span.begin},
                                 {"byteLength", place.span.end - place.span.begin}}}};
    if (!place.pointer.empty())
        out["logicalLocations"] =
            Json::array({{{"fullyQualifiedName", place.pointer}, {"kind", "jsonPointer"}}});
    return out;
}

Json result(const Diagnostic& d, std::size_t rule) {
    Json out = {{"ruleId", fmt::format("SG{}", static_cast<int>(d.code))},
                {"ruleIndex", rule},
                {"level", d.severity == Severity::error ? "error" : "warning"},
                {"message", {{"text", d.message}}}};
    if (d.place.source) out["locations"] = Json::array({location(d.place)});
    for (const Note& note : d.notes) {
        Json related = note.place.source ? location(note.place) : Json::object();
        related["message"] = {{"text", note.text}};
        out["relatedLocations"].push_back(std::move(related));
    }
    return out;
}

}  // namespace

std::string sarif(const Diags& diags) {
    std::vector<Code> codes;
    Json rules = Json::array(), results = Json::array();
    for (const Diagnostic& d : diags.all()) {
        auto rule = std::find(codes.begin(), codes.end(), d.code);
        results.push_back(result(d, static_cast<std::size_t>(rule - codes.begin())));
        if (rule != codes.end()) continue;
        codes.push_back(d.code);
        const CodeInfo& info = code_info(d.code);
        rules.push_back({{"id", fmt::format("SG{}", static_cast<int>(d.code))},
                         {"name", info.identifier},
                         {"shortDescription", {{"text", info.cause}}},
                         {"help", {{"text", info.mend}}}});
    }
    const std::string_view generator = generator_name();  // "surfgrad 1.2.3"
    Json driver = {{"name", "surfgradc"},
                   {"version", generator.substr(generator.find(' ') + 1)},
                   {"rules", std::move(rules)}};
    Json log = {{"$schema", "https://json.schemastore.org/sarif-2.1.0.json"},
                {"version", "2.1.0"},
                {"runs", Json::array({{{"tool", {{"driver", std::move(driver)}}},
                                       {"columnKind", "unicodeCodePoints"},
                                       {"results", std::move(results)}}})}};
    return log.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace sg
