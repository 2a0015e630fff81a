#include <fmt/core.h>

#include <algorithm>
#include <set>

#include "asset/image.hpp"
#include "base/ice.hpp"
#include "material/checker.hpp"

namespace sg::material {

namespace fs = std::filesystem;
using enum ir::TextureEncoding;

namespace {

bool holds_directions(ir::TextureEncoding encoding) {
    return encoding == tangent_normal || encoding == tangent_normal_xy || encoding == derivative;
}

}  // namespace

bool setting_counts(std::string_view setting, ir::TextureEncoding encoding) {
    if (setting == "green") return holds_directions(encoding);
    if (setting == "range") return encoding == derivative;
    if (setting == "swizzle") return channel_count(encoding) > 0;
    SG_ASSERT(setting == "zero");
    return holds_directions(encoding) || encoding == object_normal || encoding == world_normal ||
           encoding == parallax_map;
}

// Textures that nothing names get no binding.
std::vector<bool> Checker::used_textures() const {
    std::vector<bool> used(in.textures.size(), false);
    auto mark = [&](const std::vector<FieldEntry>& entries) {
        for (const FieldEntry& entry : entries) {
            auto it = textures_by_name.find(entry.word);
            if (it != textures_by_name.end()) used[it->second] = true;
            for (const ArgumentDecl& argument : entry.arguments) {
                auto handed = textures_by_name.find(argument.texture);
                if (handed != textures_by_name.end()) used[handed->second] = true;
            }
        }
    };
    auto mark_layers = [&](auto& self, const std::vector<LayerDecl>& layers) -> void {
        for (const LayerDecl& decl : layers) {
            mark(decl.entries);
            self(self, decl.group.layers);
            self(self, decl.equivalent);
        }
    };
    for (const NodeDecl& node : in.nodes) mark(node.entries);
    for (const StageDecl& stage : in.bump) {
        if (stage.parallax) mark(stage.parallax->entries);
        mark_layers(mark_layers, stage.layers);
    }
    return used;
}

// Paths in a material that is extended stand relative to its own folder.
std::string Checker::from_material(const std::string& file) const {
    return in.folder.empty() ? file : (fs::path(in.folder) / file).lexically_normal().generic_string();
}

std::optional<std::string> Checker::file_below_roots(const std::string& file, const At& at) {
    auto found = find_file(file, at, in.source, roots, files, diags);
    return found ? std::optional(std::move(found->bytes)) : std::nullopt;
}

std::size_t channel_count(ir::TextureEncoding encoding) {
    switch (encoding) {
        case tangent_normal:
        case object_normal:
        case world_normal:
        case color:
            return 3;
        case tangent_normal_xy:
        case derivative:
            return 2;
        case mask:
            return 4;
        default:
            return 0;
    }
}

// Where the channels stand, as in "ag" for what DXT5nm keeps.
void Checker::swizzle(const TextureDecl& decl, layers::TextureFacts& facts) {
    constexpr std::string_view kLetters = "rgba";
    const std::string& written = decl.swizzle.value;
    if (decl.swizzle.at.pointer.empty() || decl.faulty) return;
    const bool report = decl.parameter.empty();  // else the declared texture says it
    std::string_view encoding = ir::encoding_name(decl.encoding);
    std::size_t count = channel_count(decl.encoding);
    if (count == 0 && !report) return;
    if (count == 0) {
        error(Code::unused_setting, decl.swizzle.at,
              fmt::format("'swizzle' means nothing for the encoding '{}', which is read from red", encoding));
        return;
    }
    bool any_length = decl.encoding == mask;
    bool good = any_length ? !written.empty() && written.size() <= count : written.size() == count;
    for (std::size_t i = 0; i < written.size(); ++i) {
        std::size_t channel = kLetters.find(written[i]);
        bool again = !any_length && written.find(written[i]) != i;
        good = good && channel != kLetters.npos && !again;
        if (good) facts.swizzle[i] = static_cast<std::uint32_t>(channel);
    }
    if (good || !report) return;
    error(Code::unknown_choice, decl.swizzle.at,
          fmt::format("'swizzle' is '{}', expected {} of the letters r, g, b and a for the encoding '{}'",
                      printable(written), any_length ? "1 to 4" : fmt::format("{} different ones", count),
                      encoding));
}

// Settings that mean nothing for the encoding, and colour spaces that would bend data.
void Checker::texture_settings(const TextureDecl& decl) {
    std::string_view encoding = ir::encoding_name(decl.encoding);
    auto unused = [&](const At& at, std::string_view key) {
        if (at.pointer.empty() || setting_counts(key, decl.encoding)) return;
        error(Code::unused_setting, at,
              fmt::format("'{}' means nothing for the encoding '{}'", key, encoding));
    };
    unused(decl.green_up.at, "green");
    unused(decl.zero.at, "zero");
    unused(decl.range.at, "range");
    if (decl.color_space && decl.color_space->value == ColorSpace::srgb && decl.encoding != color) {
        error(Code::srgb_data, decl.color_space->at,
              fmt::format("texture '{}' of encoding '{}' is declared 'srgb', expected 'linear'",
                          printable(decl.name.value), encoding));
    }
}

// A PNG whose chunk says otherwise than the declaration, which holds: many programs mark whatever they write.
// A colour texture with a "color_space" has been thought about.
void Checker::color_space(const TextureDecl& decl, const SourcePtr& source, std::string_view bytes) {
    const bool is_color = decl.encoding == color;
    if (decl.faulty || (is_color && decl.color_space)) return;
    const auto said = asset::png_colors(bytes);
    if (!said || said->linear() != is_color) return;
    const std::string holds = said->linear()          ? "linear numbers"
                              : said->chunk == "sRGB" ? "sRGB colours"
                                                      : fmt::format("numbers of gamma {:.3g}", said->gamma);
    diags.warning(
        Code::color_space_differs, {source, decl.file.at.span, decl.file.at.pointer},
        fmt::format("'{}' says by its chunk '{}' that it holds {}, but texture '{}' of encoding '{}' "
                    "is read as {}, expected {}a file without that chunk",
                    printable(decl.file.value), said->chunk, holds, printable(decl.name.value),
                    ir::encoding_name(decl.encoding), is_color ? "sRGB colours" : "linear numbers",
                    is_color ? "\"color_space\": \"linear\" or " : ""));
}

void Checker::textures() {
    std::vector<bool> used = used_textures();
    std::set<std::pair<const Source*, std::uint32_t>> told, missing;  // by where the file is named
    texture_index.assign(in.textures.size(), 0);
    for (std::size_t i = 0; i < in.textures.size(); ++i) {
        const TextureDecl& decl = in.textures[i];
        if (!decl.faulty && decl.parameter.empty()) texture_settings(decl);
        ColorSpace natural = decl.encoding == color ? ColorSpace::srgb : ColorSpace::linear;
        CheckedTexture texture{
            .name = decl.name.value,
            .file = decl.file_source ? decl.file.value : from_material(decl.file.value),
            .parameter = decl.parameter,
            .label = decl.label,
            .encoding = decl.encoding,
            .facts = {decl.green_up.value, decl.zero.value, decl.range.value, {0, 1, 2, 3}},
            .color_space = decl.color_space ? decl.color_space->value : natural,
            .sampler = decl.sampler};
        swizzle(decl, texture.facts);
        if (!decl.file.value.empty()) {
            const SourcePtr& source = decl.file_source ? decl.file_source : in.source;
            const std::pair named{static_cast<const Source*>(source.get()), decl.file.at.span.begin};
            if (missing.contains(named)) continue;  // the texture of a parameter; the material is refused
            if (auto found = find_file(texture.file, decl.file.at, source, roots, files, diags)) {
                texture.hash = content_hash(found->bytes);
                // The texture of a parameter may be the one that is declared: what it is is told once.
                if (used[i] && told.insert(named).second) color_space(decl, source, found->bytes);
            } else {
                missing.insert(named);
            }
        } else if (!decl.file.at.pointer.empty() && decl.parameter.empty()) {
            error(Code::file_missing, decl.file.at, "file '' does not exist, expected a path");
        }
        texture_index[i] = static_cast<std::uint32_t>(out.textures.size());
        if (used[i] && out.textures.size() == kMaxTextures) texture_too_many = decl.name.at;
        if (used[i]) out.textures.push_back(std::move(texture));
    }
}

}  // namespace sg::material
