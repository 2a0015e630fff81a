// surfgradc: the command line. Arguments, one call, diagnostics, exit code:
// 0 fine, 1 the input is wrong, 2 the command line is wrong, 3 our own bug, 4 the system failed.
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <exception>
#include <iostream>
#include <iterator>

#include "artefact.hpp"
#include "base/ice.hpp"
#include "compile.hpp"
#include "custom/user_glsl.hpp"
#include "emit/function.hpp"
#include "emit/glsl.hpp"
#include "explain.hpp"
#include "import/gltf_import.hpp"
#include "kinds.hpp"
#include "outputs.hpp"
#include "sarif.hpp"
#include "schema.hpp"

namespace {

namespace fs = std::filesystem;

constexpr int kExitUsage = 2;

struct Options {
    std::vector<std::string> files;
    std::string out_dir;
    std::vector<std::string> roots;
    std::vector<std::string> entries;
    std::vector<std::string> targets{"spirv"};
    std::vector<std::string> emit;
    std::vector<std::string> budget;
    std::vector<std::string> defines;
    std::string numbers = "baked";
    std::string name;
    std::string diagnostics = "human";
    std::string color = "auto";
    bool o0 = false, os = false, o = false, debug = false;
};

bool use_color(const Options& options) {
    return options.color == "always" || (options.color == "auto" && ::isatty(STDERR_FILENO) == 1);
}

void print_diags(sg::Diags& diags, const Options& options) {
    diags.sort();
    if (options.diagnostics == "sarif") {
        std::cerr << sg::sarif(diags);
        return;
    }
    auto format = options.diagnostics == "json" ? sg::DiagFormat::json : sg::DiagFormat::human;
    std::cerr << sg::render(diags, format, use_color(options));
}

// The text of a file, or of standard input for "-".
sg::SourcePtr read_source(const std::string& file, const Options& options, sg::Files& files,
                          sg::Diags& diags) {
    if (file == "-") {
        std::string text{std::istreambuf_iterator<char>(std::cin), {}};
        return std::make_shared<sg::Source>(
            sg::Source{options.name.empty() ? "stdin" : options.name, std::move(text)});
    }
    std::optional<std::string> text = sg::read_or_report(files, file, diags);
    if (!text) return nullptr;
    return std::make_shared<sg::Source>(sg::Source{file, std::move(*text)});
}

// "instructions=300" into the budget; "" or what is wrong with it.
std::string set_limit(const std::string& word, sg::material::Budget& budget) {
    std::size_t equals = word.find('=');
    auto name =
        std::find(sg::material::kCostNames.begin(), sg::material::kCostNames.end(), word.substr(0, equals));
    std::uint32_t limit = 0;
    const char* end = word.data() + word.size();
    auto number = equals == word.npos ? std::from_chars(end, end, limit)
                                      : std::from_chars(word.data() + equals + 1, end, limit);
    if (name == sg::material::kCostNames.end() || number.ec != std::errc{} || number.ptr != end) {
        return fmt::format("'{}' is no limit, expected {}=N", word,
                           fmt::join(sg::material::kCostNames, "=N, "));
    }
    budget[static_cast<std::size_t>(name - sg::material::kCostNames.begin())] =
        sg::material::Located<std::uint32_t>{limit, {}};
    return "";
}

// "NAME=VALUE" or "NAME", which is 1.
std::pair<std::string, std::string> split_define(const std::string& word) {
    std::size_t equals = word.find('=');
    return {word.substr(0, equals), equals == word.npos ? "1" : word.substr(equals + 1)};
}

sg::CompileRequest make_request(sg::SourcePtr source, const std::string& file, const Options& options) {
    sg::CompileRequest request{.source = std::move(source)};
    fs::path path = file == "-" ? fs::path(request.source->name) : fs::path(file);
    request.stem = path.stem().string();
    request.roots.push_back(file == "-" ? fs::path(".") : path.parent_path());
    for (const std::string& root : options.roots) request.roots.emplace_back(root);
    request.entries = options.entries;
    request.targets = sg::target::select_targets(options.targets);
    using enum sg::target::Optimise;
    request.spirv.optimise = options.o0 ? none : options.os ? size : speed;
    request.spirv.debug_info = options.debug;
    request.optimise_ir = !options.o0;
    request.numbers =
        options.numbers == "uniforms" ? sg::layers::Numbers::uniforms : sg::layers::Numbers::baked;
    for (const std::string& word : options.budget) set_limit(word, request.budget);
    for (const std::string& word : options.defines) request.defines.push_back(split_define(word));
    return request;
}

using FileList = std::vector<std::pair<fs::path, std::string>>;

// What --emit asks for, beside the artefact.
void add_emitted(const sg::Compiled& compiled, const std::string& stem, const Options& options,
                 FileList& out) {
    fs::path dir(options.out_dir);
    for (const std::string& kind : options.emit) {
        if (kind == "ir") out.emplace_back(dir / (stem + ".ir"), compiled.ir);
        if (kind == "opt-ir") out.emplace_back(dir / (stem + ".opt.ir"), compiled.optimised_ir);
        if (kind == "glsl") {
            for (const sg::NamedText& t : compiled.glsl)
                out.emplace_back(dir / fmt::format("{}.{}.glsl", stem, t.name), t.text);
        }
        if (kind == "spvasm") {
            for (const sg::NamedText& t : compiled.spirv_assembly) {
                out.emplace_back(dir / fmt::format("{}.{}.spvasm", stem, t.name), t.text);
            }
        }
    }
}

enum class Task { check, explain, compile };

int run_task(const Options& options, Task task) {
    sg::RealFiles files;
    sg::target::ShaderLibrary library = sg::target::embedded_library();
    sg::Diags diags;
    sg::Outputs outputs(files);
    for (const std::string& file : options.files) outputs.add_input(file);
    for (const std::string& file : options.files) {
        sg::SourcePtr source = read_source(file, options, files, diags);
        if (!source) continue;
        sg::CompileRequest request = make_request(source, file, options);
        if (task == Task::check) {
            sg::check_material(request, files, library, diags);
            continue;
        }
        if (task == Task::explain) {
            fmt::print("{}", sg::explain_material(request, files, library, diags).value_or(""));
            continue;
        }
        std::optional<sg::Compiled> compiled = sg::compile_material(request, files, library, diags);
        if (!compiled) continue;
        FileList out;
        add_emitted(*compiled, request.stem, options, out);
        for (auto& [name, bytes] : compiled->files)
            out.emplace_back(fs::path(options.out_dir) / name, std::move(bytes));
        if (outputs.claim(source->name, out, diags)) sg::write_or_report(files, out, diags);
    }
    print_diags(diags, options);
    return diags.exit_code();
}

int run_import(const Options& options) {
    sg::RealFiles files;
    sg::Diags diags;
    sg::Outputs outputs(files);
    for (const std::string& file : options.files) outputs.add_input(file);
    for (const std::string& file : options.files) {
        std::optional<sg::import::ImportedFiles> imported = sg::import::import_gltf(files, file, diags);
        if (!imported) continue;
        for (auto& [name, bytes] : *imported) name = fs::path(options.out_dir) / name;
        if (outputs.claim(file, *imported, diags)) sg::write_or_report(files, *imported, diags);
    }
    print_diags(diags, options);
    return diags.exit_code();
}

int print(const std::string& text) {
    fmt::print("{}", text);
    return 0;
}

int run_codes() {
    for (const sg::CodeInfo& info : sg::all_codes()) {
        fmt::print("SG{}: {}\n  {}\n", static_cast<int>(info.code), info.cause, info.mend);
    }
    return 0;
}

void add_message_options(CLI::App& command, Options& options) {
    command.add_option("--diagnostics", options.diagnostics, "form of messages")
        ->check(CLI::IsMember({"human", "json", "sarif"}))
        ->capture_default_str();
    command.add_option("--color", options.color, "colour in messages")
        ->check(CLI::IsMember({"auto", "always", "never"}))
        ->capture_default_str();
}

void add_input_options(CLI::App& command, Options& options) {
    command.add_option("FILE", options.files, "material files; - reads standard input")->required();
    command.add_option("-I", options.roots, "further folder that textures may be below (repeatable)")
        ->type_name("DIR")
        ->allow_extra_args(false)
        ->check([](const std::string& folder) {
            std::error_code fault;
            return fs::is_directory(folder, fault) ? ""
                                                   : fmt::format("'{}' is no folder", sg::printable(folder));
        });
    command
        .add_option(
            "-D", options.defines,
            "macro of custom layers' GLSL: NAME or NAME=VALUE (repeatable; of one name the last counts)")
        ->type_name("NAME=VALUE")
        ->allow_extra_args(false)
        ->check([](const std::string& word) {
            auto [name, value] = split_define(word);
            return sg::custom::define_fault(name, value);
        });
    command
        .add_option("--numbers", options.numbers,
                    "where written numbers go: into the shader, or into the parameter block, so that "
                    "materials which differ in numbers share a shader")
        ->check(CLI::IsMember({"baked", "uniforms"}))
        ->capture_default_str();
    command.add_option("--name", options.name, "name of standard input in messages and of its files");
    add_message_options(command, options);
}

void add_compile_options(CLI::App& command, Options& options) {
    std::vector<std::string> entries;
    for (const sg::emit::EntryPoint& entry : sg::emit::all_entry_points()) entries.emplace_back(entry.name);
    entries.emplace_back(sg::emit::kFunctionEntry);
    command.add_option("-o", options.out_dir, "folder of the artefact")->required()->type_name("DIR");
    command
        .add_option("--entry", options.entries,
                    "entry points to compile, all by default (a list; repeatable)")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->check(CLI::IsMember(entries));
    command.add_option("--target", options.targets, "languages to write: a target or a group of them")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->check(CLI::IsMember(sg::target::target_words()))
        ->capture_default_str();
    command.add_option("--emit", options.emit, "further texts to write: ir, opt-ir, glsl, spvasm")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->check(CLI::IsMember({"ir", "opt-ir", "glsl", "spvasm"}));
    command
        .add_option(
            "--budget", options.budget,
            "fail where the forward shader costs more: instructions=N, texture_reads=N, interpolants=N")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->check([](const std::string& word) {
            sg::material::Budget budget;
            return set_limit(word, budget);
        });
    auto* o = command.add_flag("-O", options.o, "optimise (default)");
    auto* o0 = command.add_flag("--O0", options.o0,
                                "do not optimise, neither the gradients nor the SPIR-V (also -O0)");
    auto* os = command.add_flag("--Os", options.os, "as -O, and strip names from the SPIR-V (also -Os)");
    o0->excludes(os)->excludes(o);
    os->excludes(o);
    command.add_flag("-g", options.debug, "keep sources and lines in the SPIR-V");
}

// Compilers spell these with one dash, which the argument parser would take for bundled flags.
std::vector<std::string> spelled_out(int argc, char** argv) {
    std::vector<std::string> out;
    for (int i = argc - 1; i > 0; --i) {  // CLI11 takes them last first
        std::string word = argv[i];
        if (word.size() == 3 && word.starts_with("-O")) word = "-" + word;  // also -O3, which is unknown
        out.push_back(std::move(word));
    }
    return out;
}

// What the words after the program's name leave open or get wrong, with the nearest word that exists.
int usage(CLI::App& app, const CLI::ParseError& error, int argc, char** argv) {
    if (error.get_exit_code() == 0) return app.exit(error);  // --help, --version
    std::vector<std::string> owned;
    const CLI::App* command = app.get_subcommands().empty() ? &app : app.get_subcommands().front();
    for (const CLI::App* sub : app.get_subcommands({})) {
        if (command == &app) owned.push_back(sub->get_name());
    }
    for (const CLI::Option* option : command->get_options()) owned.push_back(option->get_name());
    std::vector<std::string_view> words(owned.begin(), owned.end());
    std::string text = error.what();
    for (int i = 1; i < argc; ++i) {
        std::string_view word = argv[i];
        word = word.substr(0, word.starts_with("--") ? word.find('=') : word.npos);
        bool expected = std::find(words.begin(), words.end(), word) != words.end();
        if (command == &app && !expected && !word.starts_with('-')) {
            text = fmt::format("unknown command '{}'", sg::printable(word));
        } else if (expected || !word.starts_with("--")) {
            continue;
        }
        std::string hint = sg::did_you_mean(word, words);
        if (hint.empty() && command == &app) hint = fmt::format(", expected {}", sg::one_of(words));
        text += hint;
        break;
    }
    fmt::print(stderr, "surfgradc: {}\nsurfgradc{} --help tells what is expected\n", text,
               command == &app ? "" : " " + command->get_name());
    return kExitUsage;
}

int run(int argc, char** argv) {
    CLI::App app{"surfgradc: compiles material graphs of bump layers to SPIR-V"};
    app.set_version_flag("--version", std::string(sg::generator_name()));
    app.require_subcommand(1);
    Options options;
    CLI::App* compile = app.add_subcommand("compile", "compile materials into an artefact folder");
    add_input_options(*compile, options);
    add_compile_options(*compile, options);
    CLI::App* check = app.add_subcommand("check", "report what is wrong with materials, write nothing");
    add_input_options(*check, options);
    CLI::App* explain =
        app.add_subcommand("explain", "tell what the optimiser did and what each layer costs");
    add_input_options(*explain, options);
    CLI::App* import =
        app.add_subcommand("import", "write a material for each material of glTF files, with its textures");
    import->add_option("FILE", options.files, ".gltf or .glb files")->required();
    import->add_option("-o", options.out_dir, "folder of the materials")->required()->type_name("DIR");
    add_message_options(*import, options);
    CLI::App* kinds = app.add_subcommand("kinds", "list the layer and node kinds and their fields");
    CLI::App* schema =
        app.add_subcommand("schema", "print the JSON Schema (draft-07) of materials, for editors");
    app.add_subcommand("codes", "list the diagnostic codes with cause and mend");
    try {
        app.parse(spelled_out(argc, argv));
    } catch (const CLI::ParseError& error) {
        return usage(app, error, argc, argv);
    }
    if (compile->parsed()) return run_task(options, Task::compile);
    if (explain->parsed()) return run_task(options, Task::explain);
    if (check->parsed()) return run_task(options, Task::check);
    if (import->parsed()) return run_import(options);
    if (kinds->parsed()) return print(sg::kinds_text());
    return schema->parsed() ? print(sg::schema_text()) : run_codes();
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return run(argc, argv);
    } catch (const std::exception& error) {
        sg::internal_error(__FILE__, __LINE__, error.what());
    }
}
