#include "material/instance.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "material/reader.hpp"

namespace sg::material {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kLongestChain = 16;

class Chain {
public:
    Chain(const Roots& roots, Files& files, Diags& diags) : roots_(roots), files_(files), diags_(diags) {}

    // `folder`: from the outermost material's folder to this one's.
    Material read(const json::Document& document, const fs::path& file, const fs::path& folder) {
        const json::Value* extends =
            document.root.kind == json::Kind::object ? document.root.find("extends") : nullptr;
        if (!extends) {
            Material material = material::read(document, diags_);
            material.folder = folder.generic_string();
            return material;
        }
        Reader reader{document.source, diags_};
        reader.out.source = document.source;
        ObjectReader object = reader.instance(document.root);
        auto written = object.name_of_file("extends");
        Material base;
        base.source = document.source;
        base.incomplete = true;
        open_.push_back({file, document.source->name});
        if (written) base = read_base(*written, object.at("extends", *extends), document.source, folder);
        open_.pop_back();
        if (!base.incomplete) reader.override_parameters(object, folder.generic_string(), base);
        base.name =
            reader.out.name.empty() ? fs::path(document.source->name).stem().string() : reader.out.name;
        base.description = reader.out.description;
        return base;
    }

private:
    struct Open {
        fs::path file;
        std::string name;
    };

    Material read_base(const std::string& written, const At& at, const SourcePtr& source,
                       const fs::path& folder) {
        Material none;
        none.source = source;
        none.incomplete = true;
        const std::string joined = (folder / written).lexically_normal().generic_string();
        auto found = find_file(joined, at, source, roots_, files_, diags_);
        if (!found) return none;
        auto again =
            std::find_if(open_.begin(), open_.end(), [&](const Open& o) { return o.file == found->path; });
        if (again != open_.end() || open_.size() >= kLongestChain) {
            std::string path;
            for (auto it = again == open_.end() ? open_.begin() : again; it != open_.end(); ++it)
                path += fmt::format("'{}' -> ", printable(it->name));
            path += fmt::format("'{}'", printable(joined));
            diags_.error(
                Code::extends_cycle, {source, at.span, at.pointer},
                again != open_.end()
                    ? fmt::format("materials extend each other in a circle: {}", path)
                    : fmt::format("more than {} materials extend each other: {}", kLongestChain, path));
            return none;
        }
        std::string hash = content_hash(found->bytes);
        Diags faults;
        auto document =
            json::parse(std::make_shared<Source>(Source{joined, std::move(found->bytes)}), faults);
        for (const Diagnostic& d : faults.all()) {
            std::vector<Note> notes = d.notes;
            notes.push_back({"it is extended here", {source, at.span, at.pointer}});
            diags_.error(d.code, d.place, d.message, std::move(notes));
        }
        if (!document) return none;
        Material base = read(*document, found->path, fs::path(joined).parent_path());
        base.bases.push_back({joined, std::move(hash)});
        return base;
    }

    const Roots& roots_;
    Files& files_;
    Diags& diags_;
    std::vector<Open> open_;
};

// A texture of its own for each parameter of type texture, named "$parameter": like the declared one but for
// the file.
void texture_parameters(Material& material, Diags& diags) {
    const std::size_t declared = material.textures.size();
    material.textures.reserve(declared + material.parameters.size());  // `names` must stay where they are
    std::vector<std::string_view> names;
    for (const TextureDecl& texture : material.textures) names.push_back(texture.name.value);
    for (const ParameterDecl& p : material.parameters) {
        if (p.type != ParameterType::texture || p.texture.value.empty()) continue;
        auto name =
            std::find(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(declared), p.texture.value);
        if (name == names.end()) {
            std::string hint = did_you_mean(p.texture.value, names);
            if (hint.empty())
                hint = names.empty() ? ", the material declares no textures"
                                     : fmt::format(", expected {}", one_of(names));
            diags.error(Code::unknown_texture, {material.source, p.texture.at.span, p.texture.at.pointer},
                        fmt::format("unknown texture '{}'{}", printable(p.texture.value), hint));
            continue;
        }
        TextureDecl own = material.textures[static_cast<std::size_t>(name - names.begin())];
        own.name = {"$" + p.name.value, p.name.at};
        own.parameter = p.name.value;
        own.label = p.label;
        if (!p.replacement.value.empty()) {
            own.file = p.replacement;
            own.file_source = p.replaced_in;
        }
        material.textures.push_back(std::move(own));
    }
}

}  // namespace

Material read_whole(const json::Document& document, const fs::path& file, const Roots& roots, Files& files,
                    Diags& diags) {
    Material material = Chain(roots, files, diags).read(document, file, "");
    texture_parameters(material, diags);
    return material;
}

ObjectReader Reader::instance(const json::Value& root) {
    ObjectReader reader = object(root, "", "a material that extends another",
                                 {"$schema", "version", "name", "description", "extends", "parameters"});
    header(reader);
    return reader;
}

void Reader::override_parameters(ObjectReader& reader, const std::string& folder, Material& base) {
    const json::Value* written = reader.get("parameters");
    if (!written) return;
    std::vector<std::string_view> keys;
    for (const json::Member& member : written->members) keys.push_back(member.key);
    ObjectReader values = object(*written, "/parameters", "'parameters'", keys);
    if (!values.ok()) return;
    std::vector<std::string_view> names;
    for (const ParameterDecl& decl : base.parameters) names.push_back(decl.name.value);
    for (const auto& [member, pointer] : reader.named("parameters")) {
        auto decl = std::find_if(base.parameters.begin(), base.parameters.end(),
                                 [&](const ParameterDecl& d) { return d.name.value == member->key; });
        if (decl == base.parameters.end()) {
            std::string hint = did_you_mean(member->key, names);
            if (hint.empty())
                hint = names.empty() ? ", the material that is extended declares none"
                                     : fmt::format(", expected {}", one_of(names));
            diags.error(Code::unknown_parameter, {source, member->key_span, pointer},
                        fmt::format("unknown parameter '{}'{}", printable(member->key), hint));
            continue;
        }
        if (decl->faulty) continue;
        if (decl->type != ParameterType::texture) {
            const std::size_t before = diags.error_count();
            parameter_value(values, member->key, *decl);
            if (diags.error_count() > before) continue;
            decl->set_in = source;
            decl->set_at = {member->value.span, pointer};
        } else if (auto file = values.name_of_file(member->key)) {
            decl->replacement = {(fs::path(folder) / *file).lexically_normal().generic_string(),
                                 {member->value.span, pointer}};
            decl->replaced_in = source;
        }
    }
}

}  // namespace sg::material
