#include "runtime/views.hpp"

#include <fmt/core.h>

#include <algorithm>

namespace sg::runtime {

std::vector<View> debug_views(const Artefact& artefact) {
    std::vector<View> out;
    if (const EntryPoint* debug = artefact.entry("debug")) {
        for (const DebugView& view : debug->views) out.push_back({"debug", view});
    }
    return out;
}

std::vector<View> all_views(const Artefact& artefact) {
    std::vector<View> out;
    if (artefact.entry("forward")) out.push_back({"forward", {"lit", 0, 3, ViewKind::radiance}});
    if (artefact.entry("normal")) out.push_back({"normal", {"normal", 0, 3, ViewKind::direction}});
    if (const EntryPoint* gbuffer = artefact.entry("gbuffer")) {
        for (std::uint32_t i = 0; i < gbuffer->outputs.size(); ++i) {
            const std::string& name = gbuffer->outputs[i];
            ViewKind kind = name == "normal" ? ViewKind::direction : ViewKind::vector;
            out.push_back({"gbuffer", {"gbuffer:" + name, i, 4, kind}});
        }
    }
    if (artefact.entry("depth")) out.push_back({"depth", {"depth", 0, 3, ViewKind::vector}});
    for (View& view : debug_views(artefact)) {
        bool taken = std::any_of(out.begin(), out.end(),
                                 [&](const View& other) { return other.view.name == view.view.name; });
        if (!taken) out.push_back(std::move(view));
    }
    return out;
}

std::optional<View> find_view(const Artefact& artefact, std::string_view name, Diags& diags) {
    std::vector<View> views = all_views(artefact);
    std::vector<std::string_view> names;
    for (const View& view : views) {
        if (view.view.name == name) return view;
        names.push_back(view.view.name);
    }
    std::string known = names.empty() ? "it has none" : fmt::format("it has {}", one_of(names));
    diags.error(Code::unknown_view,
                fmt::format("material '{}' has no view '{}'{} ({})", printable(artefact.name),
                            printable(name), did_you_mean(name, names), known));
    return std::nullopt;
}

}  // namespace sg::runtime
