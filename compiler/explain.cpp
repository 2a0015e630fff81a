#include "explain.hpp"

#include <fmt/format.h>

#include <sstream>
#include <utility>

#include "opt/optimise.hpp"
#include "stages.hpp"

namespace sg {
namespace {

using ir::ValueId;

constexpr std::size_t kMargin = 72;  // where the remarks begin, unless a line is longer

// ---- what became of each line ----

class Remarks {
public:
    Remarks(const ir::Module& before, const opt::Log& log) : log_(log), uses_(before.values.size()) {
        for (const opt::RuleUse& use : log.uses) uses_[use.before.index].push_back(use.rule);
    }

    [[nodiscard]] std::string before(std::size_t i) const {
        const ValueId after = log_.after[i];
        const std::string by = fmt::format("{}", fmt::join(uses_[i], ", "));
        if (!after.valid()) return fmt::format("gone: {}{}{}", by, by.empty() ? "" : ", then ", loss(i));
        const std::string out = fmt::format("now %{}", after.index);
        if (!by.empty()) return fmt::format("{}: {}", out, by);
        const opt::Origin& origin = log_.origins[after.index];
        if (origin.before.index == i) return out;
        const std::string made = origin.rule.empty() ? "" : fmt::format("what {} made of ", origin.rule);
        return fmt::format("{}: the same as {}%{}", out, made, origin.before.index);
    }

    [[nodiscard]] std::string after(std::size_t i) const {
        const opt::Origin& origin = log_.origins[i];
        std::string out = fmt::format("was %{}", origin.before.index);
        return origin.rule.empty() ? out : fmt::format("{}: {}", out, origin.rule);
    }

private:
    // What took its last use away.
    [[nodiscard]] std::string loss(std::size_t i) const {
        const opt::Loss& loss = log_.losses[i];
        return loss.rule.empty() ? "nothing needs it"
                                 : fmt::format("{} of %{}", loss.rule, loss.before.index);
    }

    const opt::Log& log_;
    std::vector<std::vector<std::string_view>> uses_;  // rules, by value
};

// The module's text with a remark behind each value.
template <class Remark>
std::string annotated(const ir::Module& module, Remark remark) {
    std::istringstream lines(ir::print(module));
    std::string out;
    std::size_t value = 0;
    for (std::string line; std::getline(lines, line);) {
        out += line.starts_with('%') ? fmt::format("{:<{}}  # {}\n", line, kMargin, remark(value++))
                                     : line + "\n";
    }
    return out;
}

// ---- what the user's functions are checked against ----

void add_references(std::string& out, const std::vector<material::CheckedLayer>& layers,
                    const material::CheckedMaterial& material) {
    for (const material::CheckedLayer& layer : layers) {
        for (const layers::FieldValue& value : layer.values) {
            if (value.word.empty()) continue;
            const std::string& file = material.shaders[layer.values.front().index].file;
            std::string reference = "no reference: add an 'equivalent' to have one";
            if (!layer.equivalent.empty()) {
                const layers::LayerKind* kind = layer.equivalent.front().kind;
                reference =
                    fmt::format("the reference is its equivalent of kind '{}'", kind ? kind->name : "group");
            }
            out += fmt::format("{} ({} of {}): {}\n", printable(layer.id), printable(value.word),
                               printable(file), reference);
        }
        add_references(out, layer.group, material);
    }
}

// "" without such functions.
std::string references(const material::CheckedMaterial& material) {
    std::string out;
    for (const auto& stage : material.stages) add_references(out, stage, material);
    return out.empty() ? "" : "\n# What your own GLSL can be compared with, in double precision\n\n" + out;
}

// ---- what each layer costs ----

class Costs {
public:
    Costs(material::CheckedMaterial material, const CompileRequest& request,
          const target::ShaderLibrary& library)
        : material_(std::move(material)), request_(request), library_(library), whole_(measured()) {}

    std::string text() {
        std::string out = fmt::format("{:<32} {:<18}", "layer", "kind");
        for (std::string_view name : material::kCostNames) out += fmt::format(" {:>16}", name);
        out += fmt::format("\n{:<51}", "(the whole shader)");
        for (std::uint32_t cost : whole_) out += fmt::format(" {:>16}", cost);
        rows_ = out + "\n";
        if (material_.parallax) parallax();
        for (auto& stage : material_.stages) layers(stage, 0);
        return rows_;
    }

private:
    [[nodiscard]] ForwardCost measured() const {
        ir::Module module = material::lower(material_, material::Custom::called, request_.numbers);
        if (request_.optimise_ir) module = opt::optimise(module, request_.skipped_rule);
        emit::MaterialInterface interface = emit::material_interface(module, group_samplers(material_).group);
        return forward_cost(module, interface, request_.stem, library_, request_.spirv);
    }

    // Takes each layer out, measures, and puts it back.
    void layers(std::vector<material::CheckedLayer>& list, std::size_t depth) {
        for (std::size_t i = 0; i < list.size(); ++i) {
            auto at = list.begin() + static_cast<std::ptrdiff_t>(i);
            material::CheckedLayer layer = std::move(*at);
            list.erase(at);
            row(layer, depth, measured());
            list.insert(list.begin() + static_cast<std::ptrdiff_t>(i), std::move(layer));
            layers(list[i].group, depth + 1);
        }
    }

    void parallax() {
        auto taken = std::exchange(material_.parallax, std::nullopt);
        row("parallax", taken->kind->name, measured());
        material_.parallax = std::move(taken);
    }

    void row(const material::CheckedLayer& layer, std::size_t depth, const ForwardCost& without) {
        row(std::string(2 * depth, ' ') + printable(layer.id), layer.kind ? layer.kind->name : "group",
            without);
    }

    void row(const std::string& name, std::string_view kind, const ForwardCost& without) {
        rows_ += fmt::format("{:<32} {:<18}", name, kind);
        for (std::size_t k = 0; k < whole_.size(); ++k) {
            std::int64_t costs = std::int64_t{whole_[k]} - without[k];
            rows_ += fmt::format(" {:>16}", fmt::format("{} ({} - {})", costs, whole_[k], without[k]));
        }
        rows_ += "\n";
    }

    material::CheckedMaterial material_;
    const CompileRequest& request_;
    const target::ShaderLibrary& library_;
    ForwardCost whole_;
    std::string rows_;
};

}  // namespace

std::string explain_module(const ir::Module& before, std::string_view skipped_rule) {
    opt::Log log;
    const ir::Module after = opt::optimise(before, skipped_rule, &log);
    const Remarks remarks(before, log);
    std::string out = fmt::format("# Before the optimiser: {} values\n\n", before.values.size());
    out += annotated(before, [&](std::size_t i) { return remarks.before(i); });
    out += fmt::format("\n# After it: {} values\n\n", after.values.size());
    return out + annotated(after, [&](std::size_t i) { return remarks.after(i); });
}

std::optional<std::string> explain_material(const CompileRequest& request, Files& files,
                                            const target::ShaderLibrary& library, Diags& diags) {
    auto checked = read_and_verify(request, files, library, diags);
    if (!checked) return std::nullopt;
    ir::Module before = material::lower(*checked, material::Custom::called, request.numbers);
    std::string out = explain_module(before, request.skipped_rule);
    out += references(*checked);
    out += "\n# What each layer costs the forward fragment shader (with all layers - without this one)\n\n";
    return out + Costs(std::move(*checked), request, library).text();
}

}  // namespace sg
