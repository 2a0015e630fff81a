#include "target/spirv.hpp"

#include <fmt/core.h>

#include <mutex>
#include <spirv-tools/libspirv.hpp>
#include <spirv-tools/optimizer.hpp>

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wconversion"
#include <glslang/Include/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>
#pragma GCC diagnostic pop

#if __has_include(<glslang/Public/ResourceLimits.h>)
#include <glslang/Public/ResourceLimits.h>
#endif

#include "base/ice.hpp"

namespace sg::target {
namespace {

constexpr spv_target_env kEnvironment = SPV_ENV_VULKAN_1_1;

// glslang is started once and never ended: ending it would drop its table of built-ins.
void start_glslang() {
    static std::once_flag once;
    std::call_once(once, [] { glslang::InitializeProcess(); });
}

class LibraryIncluder final : public glslang::TShader::Includer {
public:
    explicit LibraryIncluder(const ShaderLibrary& library) : library_(library) {}

    IncludeResult* includeLocal(const char* header, const char*, std::size_t) override {
        auto it = library_.files.find(header);
        if (it == library_.files.end()) return nullptr;
        return new IncludeResult(it->first, it->second.data(), it->second.size(), nullptr);
    }
    void releaseInclude(IncludeResult* result) override { delete result; }

private:
    const ShaderLibrary& library_;
};

EShLanguage language(Stage stage) {
    switch (stage) {
        case Stage::vertex:
            return EShLangVertex;
        case Stage::fragment:
            return EShLangFragment;
        case Stage::compute:
            return EShLangCompute;
    }
    SG_UNREACHABLE("a stage that glslang does not know");
}

// glslang follows its first fault with noise: keep that one, as "file:line: what".
std::string first_error(std::string_view log) {
    constexpr std::string_view kMark = "ERROR: ";
    std::size_t at = log.find(kMark);
    if (at == log.npos) return std::string(log.substr(0, log.find('\n')));
    std::string_view line = log.substr(at + kMark.size());
    return std::string(line.substr(0, line.find('\n')));
}

// The lines that belong to the first fault: glslang's linker names functions on lines of their own.
std::vector<std::string> indented(std::string_view log) {
    constexpr std::string_view kIndent = "    ";
    std::vector<std::string> out;
    for (std::size_t at = log.find('\n'); at != log.npos; at = log.find('\n', at + 1)) {
        std::string_view line = log.substr(at + 1);
        if (!line.starts_with(kIndent)) break;
        line = line.substr(kIndent.size());
        out.emplace_back(line.substr(0, line.find('\n')));
    }
    return out;
}

void register_passes(spvtools::Optimizer& optimizer, Optimise level) {
    // The passes that change GPU code, in the order that lets each feed the next; functions have one return,
    // so merge-return is not among them.
    optimizer.RegisterPass(spvtools::CreateInlineExhaustivePass())
        .RegisterPass(spvtools::CreateEliminateDeadFunctionsPass())
        .RegisterPass(spvtools::CreatePrivateToLocalPass())
        .RegisterPass(spvtools::CreateScalarReplacementPass(100))
        .RegisterPass(spvtools::CreateLocalAccessChainConvertPass())
        .RegisterPass(spvtools::CreateLocalSingleBlockLoadStoreElimPass())
        .RegisterPass(spvtools::CreateLocalSingleStoreElimPass())
        .RegisterPass(spvtools::CreateSSARewritePass())
        .RegisterPass(spvtools::CreateDeadBranchElimPass())
        .RegisterPass(spvtools::CreateSimplificationPass())
        .RegisterPass(spvtools::CreateAggressiveDCEPass())
        .RegisterPass(spvtools::CreateRedundancyEliminationPass())
        .RegisterPass(spvtools::CreateBlockMergePass());
    if (level == Optimise::size) optimizer.RegisterPass(spvtools::CreateStripDebugInfoPass());
}

}  // namespace

// An Optimizer may run once only: each call makes its own.
std::optional<Words> run_optimizer(const Words& words, Optimise level, std::string& fault) {
    spvtools::Optimizer optimizer(kEnvironment);
    optimizer.SetMessageConsumer(
        [&](spv_message_level_t, const char*, const spv_position_t&, const char* message) {
            if (fault.empty()) fault = fmt::format("spirv-opt: {}", message);
        });
    register_passes(optimizer, level);
    spvtools::OptimizerOptions options;
    options.set_run_validator(false);
    Words out;
    if (!optimizer.Run(words.data(), words.size(), &out, options)) return std::nullopt;
    fault.clear();
    return out;
}

namespace {

constexpr unsigned kMessages = unsigned{EShMsgSpvRules} | unsigned{EShMsgVulkanRules};

// glslang writes names between quotes into #line directives of its own.
std::string file_name(std::string_view name) {
    std::string file(name);
    for (char& c : file) {
        if (c == '"' || c == '\\' || static_cast<unsigned char>(c) < 0x20u) c = '?';
    }
    return file;
}

// The shader and the program that hold what was read; both must live while either is used.
struct Parsed {
    std::vector<std::string> names;
    std::vector<const char*> name_pointers, strings;
    std::vector<int> lengths;
    glslang::TShader shader;
    glslang::TProgram program;

    Parsed(std::span<const GlslPart> parts, Stage stage) : shader(language(stage)) {
        for (const GlslPart& part : parts) {
            names.push_back(file_name(part.name));
            strings.push_back(part.text.data());
            lengths.push_back(static_cast<int>(part.text.size()));
        }
        for (const std::string& name : names) name_pointers.push_back(name.c_str());
        shader.setStringsWithLengthsAndNames(strings.data(), lengths.data(), name_pointers.data(),
                                             static_cast<int>(parts.size()));
        shader.setEnvInput(glslang::EShSourceGlsl, language(stage), glslang::EShClientVulkan, 110);
        shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_1);
        shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_3);
    }

    // "" or glslang's log.
    std::string read(const ShaderLibrary& library, unsigned extra_messages) {
        LibraryIncluder includer(library);
        auto messages = static_cast<EShMessages>(kMessages | extra_messages);
        if (!shader.parse(GetDefaultResources(), 450, false, messages, includer)) return shader.getInfoLog();
        program.addShader(&shader);
        return program.link(messages) ? "" : program.getInfoLog();
    }
};

}  // namespace

std::optional<Words> front_end(std::string_view text, std::string_view name, Stage stage,
                               const ShaderLibrary& library, bool debug_info, std::string& fault) {
    start_glslang();
    const GlslPart part{name, text};
    Parsed parsed({&part, 1}, stage);
    std::string log = parsed.read(library, debug_info ? EShMsgDebugInfo : EShMsgDefault);
    if (!log.empty()) {
        fault = first_error(log);
        return std::nullopt;
    }
    Words words;
    glslang::SpvOptions options;
    options.generateDebugInfo = debug_info;
    options.disableOptimizer = true;
    options.validate = false;
    glslang::GlslangToSpv(*parsed.program.getIntermediate(language(stage)), words, &options);
    return words;
}

std::optional<GlslFault> check_glsl(std::span<const GlslPart> parts, Stage stage,
                                    const ShaderLibrary& library) {
    start_glslang();
    Parsed parsed(parts, stage);
    std::string log = parsed.read(library, EShMsgDefault);
    if (log.empty()) {
        Words words;
        glslang::GlslangToSpv(*parsed.program.getIntermediate(language(stage)), words,
                              static_cast<glslang::SpvOptions*>(nullptr));
        std::string invalid = validate(words);
        return invalid.empty() ? std::nullopt : std::optional(GlslFault{"", 0, invalid, {}});
    }
    // "name:12: 'x' : undeclared identifier", where the name may hold colons.
    std::string first = first_error(log);
    GlslFault fault{.part = "", .line = 0, .what = first, .details = indented(log)};
    for (std::size_t at = first.find(':'); at != first.npos; at = first.find(':', at + 1)) {
        std::size_t end = at + 1;
        while (end < first.size() && first[end] >= '0' && first[end] <= '9') ++end;
        if (end == at + 1 || end - at > 9 || first.compare(end, 2, ": ") != 0) continue;
        fault.part = first.substr(0, at);
        fault.line = static_cast<std::uint32_t>(std::stoul(first.substr(at + 1, end - at - 1)));
        fault.what = first.substr(end + 2);
        break;
    }
    return fault;
}

std::optional<Words> compile_glsl(std::string_view text, std::string_view name, Stage stage,
                                  const ShaderLibrary& library, const SpirvOptions& options,
                                  std::string& fault) {
    fault.clear();
    std::optional<Words> words = front_end(text, name, stage, library, options.debug_info, fault);
    if (words && options.optimise != Optimise::none) words = run_optimizer(*words, options.optimise, fault);
    if (!words) return std::nullopt;
    fault = validate(*words);
    if (!fault.empty()) return std::nullopt;
    return words;
}

std::string validate(std::span<const std::uint32_t> words) {
    spvtools::SpirvTools tools(kEnvironment);
    std::string fault;
    tools.SetMessageConsumer(
        [&](spv_message_level_t, const char*, const spv_position_t& at, const char* message) {
            if (fault.empty()) fault = fmt::format("spirv-val: word {}: {}", at.index, message);
        });
    if (!tools.Validate(words.data(), words.size()) && fault.empty()) fault = "spirv-val: invalid module";
    return fault;
}

std::string disassemble(std::span<const std::uint32_t> words) {
    spvtools::SpirvTools tools(kEnvironment);
    tools.SetMessageConsumer([](spv_message_level_t, const char*, const spv_position_t&, const char*) {});
    std::string text;
    bool good = tools.Disassemble(words.data(), words.size(), &text,
                                  SPV_BINARY_TO_TEXT_OPTION_FRIENDLY_NAMES |
                                      SPV_BINARY_TO_TEXT_OPTION_INDENT | SPV_BINARY_TO_TEXT_OPTION_NO_HEADER);
    SG_ASSERT(good);
    return text;
}

std::size_t instruction_count(std::span<const std::uint32_t> words) {
    constexpr std::size_t kHeader = 5;
    constexpr std::uint32_t kFunction = 54, kLabel = 248, kFunctionParameter = 55, kFunctionEnd = 56,
                            kVariable = 59, kLine = 8, kNoLine = 317;
    std::size_t count = 0;
    bool in_function = false;
    for (std::size_t i = kHeader; i < words.size(); i += std::max<std::uint32_t>(1, words[i] >> 16u)) {
        std::uint32_t op = words[i] & 0xFFFFu;
        if (op == kFunction) in_function = true;
        bool work = in_function && op != kFunction && op != kLabel && op != kFunctionParameter &&
                    op != kFunctionEnd && op != kVariable && op != kLine && op != kNoLine;
        if (work) ++count;
    }
    return count;
}

std::string bytes(std::span<const std::uint32_t> words) {
    std::string out;
    out.reserve(words.size() * 4);
    for (std::uint32_t word : words) {
        for (unsigned shift = 0; shift < 32; shift += 8) out += static_cast<char>((word >> shift) & 0xFFu);
    }
    return out;
}

}  // namespace sg::target
