#include "runtime/textures.hpp"

#include <fmt/core.h>

#include "runtime/mips.hpp"

namespace sg::runtime {
namespace {

MipRule mip_rule(const TextureSlot& slot) {
    MipRule rule;
    rule.srgb = slot.srgb;
    rule.zero = slot.zero;
    rule.channels = slot.channels;
    switch (slot.encoding) {
        case TextureSlot::Encoding::plain:
            rule.kind = MipRule::Kind::color;
            break;
        case TextureSlot::Encoding::normal_xyz:
            rule.kind = MipRule::Kind::slopes_xyz;
            break;
        case TextureSlot::Encoding::normal_xy:
            rule.kind = MipRule::Kind::slopes_xy;
            break;
    }
    return rule;
}

// Compares whole path elements after symbolic links are followed.
bool is_below(Files& files, const std::filesystem::path& path, const std::filesystem::path& root) {
    std::filesystem::path relative = files.canonical(path).lexically_relative(files.canonical(root));
    return !relative.empty() && *relative.begin() != "..";
}

std::optional<std::vector<asset::Image>> load(Files& files, const TextureSlot& slot,
                                              const std::filesystem::path& root, Diags& diags) {
    std::filesystem::path path = root / slot.file;
    std::string shown = printable(slot.file);
    if (std::filesystem::path(slot.file).is_absolute() || !is_below(files, path, root)) {
        diags.error(Code::path_escapes,
                    fmt::format("texture '{}' lies at '{}', outside the texture root '{}'",
                                printable(slot.name), shown, printable(root.string())));
        return std::nullopt;
    }
    if (!files.exists(path)) {
        diags.error(
            Code::file_missing,
            fmt::format(
                "texture '{}' is missing: no file '{}' below '{}'; --texture-root names another folder",
                printable(slot.name), shown, printable(root.string())));
        return std::nullopt;
    }
    auto bytes = read_or_report(files, path, diags);
    if (!bytes) return std::nullopt;
    if (!slot.hash.empty() && content_hash(*bytes) != slot.hash) {
        diags.warning(Code::manifest_mismatch, Place{},
                      fmt::format("texture '{}' has changed since the material was compiled", shown));
    }
    auto image = asset::read_image(*bytes, slot.file, Place{}, diags);
    if (!image) return std::nullopt;
    return mip_chain(*image, mip_rule(slot));
}

}  // namespace

std::vector<std::string> exchange_textures(Artefact& artefact, std::span<const std::string> settings) {
    std::vector<std::string> left;
    for (const std::string& setting : settings) {
        const std::size_t equals = setting.find('=');
        bool taken = false;
        for (TextureSlot& slot : artefact.textures) {
            const bool named = !slot.parameter.empty() && slot.parameter == setting.substr(0, equals);
            if (equals == std::string::npos || !named) continue;
            slot.file = setting.substr(equals + 1);
            slot.hash.clear();  // whatever it holds
            taken = true;
        }
        if (!taken) left.push_back(setting);
    }
    return left;
}

std::optional<TextureSet> load_textures(Files& files, const Artefact& artefact,
                                        const std::filesystem::path& root, Diags& diags) {
    TextureSet set;
    for (const TextureSlot& slot : artefact.textures) {
        if (auto chain = load(files, slot, root.empty() ? "." : root, diags))
            set.chains.push_back(std::move(*chain));
    }
    if (set.chains.size() != artefact.textures.size()) return std::nullopt;
    return set;
}

}  // namespace sg::runtime
