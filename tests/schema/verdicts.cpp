#include "verdicts.hpp"

#include <algorithm>

namespace sg::test {
namespace {

constexpr std::string_view kSaid;
constexpr std::string_view kNoDocument = "the text is no JSON value that could be validated";
constexpr std::string_view kRepeated = "JSON's data model has no repeated keys";
constexpr std::string_view kDeclared = "a schema cannot look up what another part of the document declares";
constexpr std::string_view kTwoParts = "it depends on values in two places that no schema keyword compares";
constexpr std::string_view kGraph = "a schema cannot follow references";
constexpr std::string_view kFiles = "it is about files, which a schema does not see";
constexpr std::string_view kGlsl = "it is about text in another language";
constexpr std::string_view kOutput = "it is about what the compiler makes of a material";
constexpr std::string_view kOther = "it is about images, meshes, artefacts or devices, not about materials";

constexpr Verdict kVerdicts[] = {
    {Code::json_syntax, kNoDocument},
    {Code::json_limit, kNoDocument},
    {Code::json_duplicate_key, kRepeated},
    {Code::json_encoding, kNoDocument},
    {Code::unknown_key, kSaid},
    {Code::missing_key, kSaid},
    {Code::wrong_type, kSaid},
    {Code::out_of_range, kSaid},
    {Code::unknown_kind, kSaid},
    {Code::unknown_choice, kSaid},
    {Code::unsupported_version, kSaid},
    {Code::bad_name, kSaid},
    {Code::unknown_texture, kDeclared},
    {Code::unknown_parameter, kDeclared},
    {Code::duplicate_id, kTwoParts},
    {Code::wrong_encoding, kDeclared},
    {Code::parameter_type, kDeclared},
    {Code::srgb_data, kSaid},
    {Code::unused_setting, kSaid},
    {Code::too_many, kSaid},
    {Code::unknown_node, kDeclared},
    {Code::node_cycle, kGraph},
    {Code::node_type, kDeclared},
    {Code::extends_cycle, kGraph},
    {Code::parallax_place, kSaid},
    {Code::unknown_entry, kDeclared},
    {Code::color_space_differs, kFiles},
    {Code::mixed_gradients, kTwoParts},
    {Code::file_missing, kFiles},
    {Code::path_escapes, kFiles},
    {Code::file_unreadable, kFiles},
    {Code::output_clash, kFiles},
    {Code::file_unwritable, kFiles},
    {Code::target_lacks, kOutput},
    {Code::over_budget, kOutput},
    {Code::import_left_out, kOther},
    {Code::glsl_fault, kGlsl},
    {Code::glsl_refused, kGlsl},
    {Code::glsl_signature, kGlsl},
    {Code::image_format, kOther},
    {Code::image_limit, kOther},
    {Code::mesh_format, kOther},
    {Code::mesh_attribute, kOther},
    {Code::mesh_empty, kOther},
    {Code::manifest_format, kOther},
    {Code::manifest_mismatch, kOther},
    {Code::unknown_view, kOther},
    {Code::unknown_material_parameter, kOther},
    {Code::bad_argument, kOther},
    {Code::angle_exceeded, kOther},
    {Code::no_height, kOther},
    {Code::no_smooth_surface, kOther},
    {Code::module_missing, kOther},
    {Code::not_comparable, kOther},
    {Code::claim_failed, kOther},
    {Code::module_fault, kOther},
    {Code::vulkan_missing, kOther},
    {Code::device_missing, kOther},
    {Code::vulkan_failed, kOther},
    {Code::validation_failed, kOther},
    {Code::layer_missing, kOther},
    {Code::compiler_missing, kOther},
};

constexpr BeyondCase kBeyondCases[] = {
    {"SG1207_parallax_steps", "no keyword compares two numbers"},
    {"SG1105_in_base", "the fault is in the file that the instance extends"},
    {"SG1104_in_instance",
     "the fields and types of its parameters are in the file that the instance extends"},
    {"SG1202_instance", "the types of its parameters are declared in the file that the instance extends"},
};

constexpr BeyondMessage kBeyondMessages[] = {
    {Code::too_many, " bytes of parameters", "no keyword adds up sizes"},
    {Code::out_of_range, " here",
     "what a constant or a parameter is, is compared with the range of the field that uses it"},
    {Code::out_of_range, " where it is used", "the field is in the file that the instance extends"},
    {Code::unused_setting, "'min_steps' is more than 'max_steps'", "no keyword compares two numbers"},
    {Code::unused_setting, "'angle_fade' runs backwards", "no keyword compares two numbers"},
    {Code::unused_setting, "the range 'from' is empty", "no keyword compares two numbers"},
    {Code::unused_setting, "'rnm' turns one map by the other", "it compares two coordinates and two tilings"},
    {Code::unused_setting, "means nothing without a parallax",
     "no keyword looks from a layer or node, however deep, to the first entry"},
    {Code::unused_setting, "calls GLSL itself", "no keyword looks for a kind at any depth"},
};

}  // namespace

std::span<const Verdict> verdicts() {
    return kVerdicts;
}
const Verdict* find_verdict(Code code) {
    auto at = std::find_if(std::begin(kVerdicts), std::end(kVerdicts),
                           [&](const Verdict& v) { return v.code == code; });
    return at == std::end(kVerdicts) ? nullptr : at;
}

std::span<const BeyondCase> beyond_cases() {
    return kBeyondCases;
}
const BeyondCase* find_beyond_case(std::string_view name) {
    auto at = std::find_if(std::begin(kBeyondCases), std::end(kBeyondCases),
                           [&](const BeyondCase& c) { return c.name == name; });
    return at == std::end(kBeyondCases) ? nullptr : at;
}

const BeyondMessage* find_beyond_message(int code, std::string_view message) {
    auto at =
        std::find_if(std::begin(kBeyondMessages), std::end(kBeyondMessages), [&](const BeyondMessage& m) {
            return static_cast<int>(m.code) == code && message.find(m.part) != std::string_view::npos;
        });
    return at == std::end(kBeyondMessages) ? nullptr : at;
}

}  // namespace sg::test
