#include "tests/oracle/random_module.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>
#include <map>

namespace sg::oracle {
namespace {

using ir::Op;
using ir::Type;
using ir::ValueId;

constexpr std::size_t kValues = 200, kMaxDepth = 3;
constexpr std::size_t kBeforeParallax =
    60;  // of these take screen derivatives, of the others look along rays
constexpr std::uint32_t kSets = 3;

class Generator {
public:
    explicit Generator(std::mt19937_64& random) : random_(random) {}

    RandomModule make() {
        out_.module.name = "random";
        out_.module.textures = {{"xyz", ir::TextureEncoding::tangent_normal},
                                {"xy", ir::TextureEncoding::tangent_normal_xy},
                                {"height", ir::TextureEncoding::height},
                                {"mask", ir::TextureEncoding::mask},
                                {"color", ir::TextureEncoding::color}};
        for (Type type : {Type::Scalar, Type::Vec2, Type::Vec3, Type::Vec4, Type::Color}) parameter(type);
        out_.module.parameters.push_back({"projector", Type::Projector});
        out_.parameters.push_back(ir::datum_of(Type::Projector, affine()));
        derive();
        while (out_.module.values.size() < kValues) {
            const ir::OpInfo& op = pick_op();
            const bool looks = out_.module.values.size() >= kBeforeParallax;
            if (looks ? !ir::takes_screen_derivatives(op.op) : !ir::looks_along_ray(op.op)) add(op);
        }
        resolve_one_map();
        resolve_seldom_things();
        keep_within();
        out_.module.layers.push_back({"one", "normal_map"});
        for (ir::Output output : ir::all_outputs()) {
            const std::vector<ValueId>& values = by_type_[ir::output_type(output)];
            if (values.empty()) continue;
            const ValueId last = values.back();
            const ir::Value& value = out_.module.at(last);
            const bool set = output == ir::Output::uv && value.op == Op::uv_set;
            out_.module.outputs.push_back({output, set ? value.index : 0, last});
        }
        return std::move(out_);
    }

private:
    std::size_t below(std::size_t count) {
        return std::uniform_int_distribution<std::size_t>(0, count - 1)(random_);
    }

    // One in three may be any number; the others keep to a range, above 0, from 0, or across it.
    void parameter(Type type) {
        constexpr std::array<double, 2> kRanges[] = {{0.25, 3}, {0.25, 3}, {0, 2}, {-2, 2}};
        ir::Parameter parameter{fmt::format("p{}", out_.module.parameters.size()), type};
        std::array<double, 4> value = numbers();
        if (below(3) != 0) {
            parameter.range = kRanges[below(std::size(kRanges))];
            std::uniform_real_distribution<double> within((*parameter.range)[0], (*parameter.range)[1]);
            for (double& component : value) component = within(random_);
        }
        out_.module.parameters.push_back(std::move(parameter));
        out_.parameters.push_back(ir::datum_of(type, value));
    }

    // What the host computed already before an optimiser came; half of what is above 0 is known to be.
    void derive() {
        ir::Module& module = out_.module;
        module.host = {{.op = Op::parameter, .type = Type::Scalar},
                       {.op = Op::constant, .type = Type::Scalar, .number = {number()}},
                       {.op = Op::multiply, .type = Type::Scalar, .operands = {ValueId{0}, ValueId{1}}}};
        const double second = std::get<double>(out_.parameters[0]), first = second * module.host[1].number[0];
        module.derived = {{"first", Type::Scalar, {2}, first > 0 && below(2) == 0},
                          {"second", Type::Scalar, {0}, second > 0 && below(2) == 0}};
    }

    // One map on vertex tangents by itself, where there is one: chance seldom brings its parts together.
    void resolve_one_map() {
        const ir::Module& module = out_.module;
        ValueId n, g;
        for (std::uint32_t i = 0; i < module.values.size(); ++i) {
            const ir::Value& value = module.values[i];
            if (value.op == Op::base_normal) n = {i};
            if (value.op != Op::surfgrad_from_tbn) continue;
            const Op deriv = module.at(value.operands[0]).op;
            const bool of_map =
                deriv == Op::deriv_from_normal_xyz || deriv == Op::scale_deriv || deriv == Op::deriv_green_up;
            if (of_map && module.at(value.operands[1]).op == Op::basis_vertex) g = {i};
        }
        if (!n.valid() || !g.valid()) return;
        ir::Value resolved{.op = Op::resolve, .type = Type::Normal};
        resolved.operands = {n, g};
        depth_.push_back(0);
        by_type_[Type::Normal].push_back({static_cast<std::uint32_t>(module.values.size())});
        out_.module.values.push_back(std::move(resolved));
    }

    ValueId put(Op op, std::vector<ValueId> operands) {
        const ValueId id{static_cast<std::uint32_t>(out_.module.values.size())};
        const Type type = ir::info(op).result;
        ir::Value value{.op = op, .type = type};
        value.operands = std::move(operands);
        out_.module.values.push_back(std::move(value));
        depth_.push_back(0);
        by_type_[type].push_back(id);
        return id;
    }

    // In one of 32 modules each, for they take the place of other outputs: what chance seldom brings
    // together.
    void resolve_seldom_things() {
        const std::vector<ValueId>&numbers = by_type_[Type::Scalar], &normals = by_type_[Type::Normal];
        const std::size_t which = below(32);
        if (which > 3 || numbers.empty() || normals.empty()) return;
        const ValueId n = pick(normals), part = pick(numbers);
        if (which == 0) {
            resolve_part_of_a_normal(n, part);
        } else if (which == 1) {
            resolve_noise(n, part);
        } else if (!by_type_[Type::VolGrad].empty()) {
            resolve_two_projections(n, part, which == 2);
        }
    }

    void resolve_part_of_a_normal(ValueId n, ValueId part) {
        const ValueId direction = put(Op::direction_of, {pick(by_type_[Type::Normal])});
        const ValueId gradient = put(Op::surfgrad_from_normal, {n, direction});
        put(Op::resolve, {n, put(Op::mask_surfgrad, {gradient, part})});
    }

    void resolve_noise(ValueId n, ValueId strength) {
        if (by_type_[Type::Noise].empty()) return;
        const ValueId noise = pick(by_type_[Type::Noise]);
        const ValueId local = put(Op::noise_gradient, {pick(by_type_[Type::Scalar]), noise});
        const Op turn = below(2) == 0 ? Op::gradient_from_object : Op::gradient_from_world;
        const ValueId scaled = put(Op::scale_volgrad, {strength, put(turn, {local})});
        put(Op::resolve, {n, put(Op::surfgrad_from_volume, {n, scaled})});
    }

    // Mixed, or the first of them by itself under a factor of nothing and added.
    void resolve_two_projections(ValueId n, ValueId part, bool mixed) {
        const ValueId first = pick(by_type_[Type::VolGrad]), second = pick(by_type_[Type::VolGrad]);
        const ValueId scaled = mixed ? first : put(Op::scale_volgrad, {constant(0), first});
        const ValueId a = put(Op::surfgrad_from_volume, {n, scaled});
        const ValueId b = put(Op::surfgrad_from_volume, {n, second});
        put(Op::resolve, {n, mixed ? put(Op::mix_surfgrad, {a, b, part}) : put(Op::add_surfgrad, {a, b})});
    }

    // Coordinates and bases, which many rules look at, more often than the rest.
    const ir::OpInfo& pick_op() {
        const std::span<const ir::OpInfo> all = ir::all_ops();
        const bool any = below(8) != 0;
        for (;;) {
            const ir::OpInfo& op = all[below(all.size())];
            if (any || op.include == "surfgrad/tbn.glsl" || op.include == "surfgrad/uv.glsl" ||
                op.include == "surfgrad/combine.glsl")
                return op;
        }
    }

    // Numbers that rules look for, and others; small, so that chains of factors stay within reason.
    double number() {
        constexpr double kNumbers[] = {0, 0, 1, 1, 1, -1, 2, 0.5, -0.75, 3, 1.25};
        return kNumbers[below(std::size(kNumbers))];
    }
    std::array<double, 4> numbers() { return {number(), number(), number(), number()}; }

    // A matrix by its columns, any three rows.
    std::array<double, 16> affine() {
        std::array<double, 16> out{};
        for (std::size_t i = 0; i < 16; ++i) out[i] = i % 4 < 3 ? number() : i == 15 ? 1 : 0;
        return out;
    }

    // Mostly a recent value, so that graphs become deep.
    ValueId pick(const std::vector<ValueId>& values) {
        const std::size_t reach = below(2) == 0 ? std::min<std::size_t>(values.size(), 3) : values.size();
        return values[values.size() - 1 - below(reach)];
    }

    ValueId nothing(Type type) {
        const ValueId id{static_cast<std::uint32_t>(out_.module.values.size())};
        depth_.push_back(0);
        by_type_[type].push_back(id);
        out_.module.values.push_back({.op = Op::constant, .type = type});
        return id;
    }

    // The last number that has a bound, if there is one.
    ValueId bounded() {
        ValueId out;
        for (ValueId id : by_type_[Type::Scalar]) {
            const Op op = out_.module.at(id).op;
            const bool falls_off = ir::info(op).name.starts_with("decal_");
            if (falls_off || op == Op::facing || op == Op::smoothstep) out = id;
        }
        return out;
    }

    ValueId constant(double number) {
        const ValueId id = nothing(Type::Scalar);
        out_.module.values[id.index].number[0] = number;
        return id;
    }

    // A number with a bound, or what is computed of it, kept within bounds that it may or may not leave.
    void keep_within() {
        ValueId number = bounded();
        if (!number.valid() || below(4) != 0) return;
        if (below(2) == 0) number = put(Op::subtract, {constant(1), number});
        if (below(2) == 0) number = put(Op::multiply, {constant(below(2) == 0 ? 0.5 : -0.5), number});
        const ValueId least = constant(below(2) == 0 ? 0 : -1), most = constant(1);
        put(Op::clamp, {number, least, most});
    }

    void add(const ir::OpInfo& op) {
        // Most operations take something: else the few types that sources give crowd out deep graphs.
        const bool source = op.operands.empty() && op.attribute != ir::Attribute::Number;
        if (source && !by_type_[op.result].empty() && below(6) != 0) return;
        ir::Value value{.op = op.op, .type = op.result};
        std::size_t depth = 0;
        for (Type type : op.operands) {
            if (by_type_[type].empty()) return;
            value.operands.push_back(pick(by_type_[type]));
            depth = std::max(depth, depth_[value.operands.back().index]);
        }
        // Chance seldom lets a drift begin nowhere.
        if (op.op == Op::drift && below(2) == 0) value.operands[0] = nothing(Type::Vec2);
        // Nor comes a number with a bound under a factor of nothing.
        if (op.op == Op::multiply && below(4) == 0) {
            if (const ValueId factor = bounded(); factor.valid())
                value.operands = {nothing(Type::Scalar), factor};
        }
        if (grows(op.result)) {
            depth += op.op == Op::power ? kMaxDepth : 1;  // nothing but plain numbers under a power
            if (depth > kMaxDepth) return;
        } else {
            depth = 0;
        }
        constexpr double kZeros[] = {127, 127.5, 128};
        constexpr Type kConstants[] = {Type::Scalar, Type::Scalar, Type::Vec2,
                                       Type::Vec2,   Type::Vec3,   Type::Vec4};
        switch (op.attribute) {
            case ir::Attribute::Set:
                value.index = static_cast<std::uint32_t>(below(kSets));
                break;
            case ir::Attribute::Texture:
                value.index = static_cast<std::uint32_t>(below(out_.module.textures.size()));
                break;
            case ir::Attribute::Parameter:
                value.index = static_cast<std::uint32_t>(below(out_.module.parameters.size()));
                value.type = out_.module.parameters[value.index].type;
                break;
            case ir::Attribute::Derived:
                value.index = static_cast<std::uint32_t>(below(out_.module.derived.size()));
                value.type = out_.module.derived[value.index].type;
                break;
            case ir::Attribute::Zero:
                value.number[0] = kZeros[below(3)];
                break;
            case ir::Attribute::Number:
                value.type = kConstants[below(std::size(kConstants))];
                for (std::size_t i = 0; i < ir::component_count(value.type); ++i) value.number[i] = number();
                break;
            case ir::Attribute::Count:
                value.index = static_cast<std::uint32_t>(below(4)) + 1;
                break;
            case ir::Attribute::Swizzle:
                value.index = static_cast<std::uint32_t>(below(256));
                break;
            case ir::Attribute::Channel:
            case ir::Attribute::Corner:
                value.index = static_cast<std::uint32_t>(below(4));
                break;
            case ir::Attribute::Axis:
                value.index = static_cast<std::uint32_t>(below(3));
                break;
            case ir::Attribute::Function:
                return;  // it has no reference
            case ir::Attribute::None:
                break;
        }
        depth_.push_back(depth);
        by_type_[value.type].push_back({static_cast<std::uint32_t>(out_.module.values.size())});
        out_.module.values.push_back(std::move(value));
    }

    // Arithmetic on these has no bound of its own: a power of a power would soon be infinite.
    static bool grows(Type type) {
        return type == Type::Scalar || type == Type::Vec2 || type == Type::Color || type == Type::Volume ||
               type == Type::Noise || type == Type::LocalGrad || type == Type::VolGrad || type == Type::Uv;
    }

    std::mt19937_64& random_;
    std::vector<std::size_t> depth_;  // of arithmetic that led to each value
    RandomModule out_;
    std::map<Type, std::vector<ValueId>> by_type_;
};

}  // namespace

std::uint64_t run_seed() {
    static const std::uint64_t kSeed = [] {
        const char* given = std::getenv("SG_SEED");
        std::random_device device;
        const std::uint64_t fresh = std::uint64_t{device()} << 32U | device();
        const std::uint64_t seed = given ? std::strtoull(given, nullptr, 10) : fresh;
        fmt::print("SG_SEED={}\n", seed);
        return seed;
    }();
    return kSeed;
}

RandomModule random_module(std::mt19937_64& random) {
    return Generator(random).make();
}

namespace {

// Of a camera that looks along -z, turned: 100 pixels over a tangent of 1, depth 1 at the near plane.
glm::dmat4 screen(std::mt19937_64& random) {
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    const glm::dvec3 back = glm::normalize(glm::dvec3(unit(random), unit(random), 2.0));
    const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(0.0, 1.0, 0.0), back));
    const glm::dvec3 up = glm::cross(back, right);
    return glm::dmat4(glm::dvec4(0.01 * right, 0.0), glm::dvec4(-0.01 * up, 0.0),
                      glm::dvec4(0.0, 0.0, 0.0, 1.0), glm::dvec4(-back - 0.5 * right + 0.5 * up, 0.0));
}

}  // namespace

ir::PixelInputs random_pixel(std::mt19937_64& random) {
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    auto vec2 = [&](double size) { return size * ref::dvec2(unit(random), unit(random)); };
    auto vec3 = [&](double size) { return size * ref::dvec3(unit(random), unit(random), unit(random)); };
    ir::PixelInputs pixel;
    pixel.position = vec3(5.0);
    pixel.vertex_normal = vec3(1.0);
    pixel.vertex_tangent = ref::dvec4(vec3(1.0), unit(random) < 0.0 ? -1.0 : 1.0);
    for (ref::Uv& uv : pixel.uvs) uv = {vec2(3.0), vec2(0.05), vec2(0.05)};
    pixel.dpdx = vec3(0.02);
    pixel.dpdy = vec3(0.02);
    pixel.facing = unit(random) < 0.0 ? -1.0 : 1.0;
    pixel.dndx = vec3(0.02);
    pixel.dndy = vec3(0.02);
    pixel.object_origin = vec3(5.0);
    pixel.camera = {unit(random) < 0.0, vec3(5.0), glm::normalize(vec3(1.0)), screen(random)};
    return pixel;
}

}  // namespace sg::oracle
