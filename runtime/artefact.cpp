#include "runtime/artefact.hpp"

#include <fmt/core.h>

#include <cstring>

namespace sg::runtime {
namespace {

constexpr std::uint32_t kSpirvMagic = 0x07230203;
constexpr std::size_t kSpirvHeaderWords = 5;

bool read_stage(Files& files, const std::filesystem::path& folder, ShaderStage& stage, Diags& diags) {
    auto bytes = read_or_report(files, folder / stage.file, diags);
    if (!bytes) return false;
    std::string shown = printable(stage.file);
    if (std::string hash = content_hash(*bytes); hash != stage.hash) {
        diags.error(Code::manifest_mismatch,
                    fmt::format("'{}' is not the shader that the manifest names: its hash is {}, expected {}",
                                shown, hash, printable(stage.hash)));
        return false;
    }
    stage.words.resize(bytes->size() / sizeof(std::uint32_t));
    std::memcpy(stage.words.data(), bytes->data(), stage.words.size() * sizeof(std::uint32_t));
    if (bytes->size() % 4 == 0 && stage.words.size() > kSpirvHeaderWords && stage.words[0] == kSpirvMagic)
        return true;
    diags.error(Code::manifest_mismatch, fmt::format("'{}' is not a SPIR-V file", shown));
    return false;
}

}  // namespace

const EntryPoint* Artefact::entry(std::string_view wanted) const {
    for (const EntryPoint& entry : entries) {
        if (entry.name == wanted) return &entry;
    }
    return nullptr;
}

std::optional<Artefact> read_artefact(Files& files, const std::filesystem::path& manifest, Diags& diags) {
    auto text = read_or_report(files, manifest, diags);
    if (!text) return std::nullopt;
    auto artefact = read_manifest(*text, manifest.string(), diags);
    if (!artefact) return std::nullopt;
    artefact->folder = manifest.parent_path();
    bool ok = true;
    for (EntryPoint& entry : artefact->entries) {
        ok = read_stage(files, artefact->folder, entry.vertex, diags) && ok;
        ok = read_stage(files, artefact->folder, entry.fragment, diags) && ok;
    }
    if (!ok) return std::nullopt;
    return artefact;
}

}  // namespace sg::runtime
