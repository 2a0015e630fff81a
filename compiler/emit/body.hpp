// The lines of main() that compute a module's values.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "emit/interface.hpp"
#include "emit/names.hpp"
#include "ir/ir.hpp"

namespace sg::emit {

// How an operation is written, and the file of the library that this needs, as in ops.def.
struct Wording {
    std::string_view glsl, include;
};
// The table's own: between the stages of a pipeline.
Wording stage_wording(ir::Op op);

class Body {
public:
    Body(const ir::Module& module, const MaterialInterface& material,
         Wording (*wording)(ir::Op) = stage_wording);

    // The statements, each on its line, indented by four blanks.
    [[nodiscard]] const std::string& text() const { return text_; }
    // How a value is written where it is used.
    [[nodiscard]] std::string operand(ir::ValueId id) const { return expressions_[id.index]; }
    [[nodiscard]] const std::set<std::string_view>& includes() const { return includes_; }

private:
    [[nodiscard]] std::string expression(const ir::Value& value) const;
    [[nodiscard]] bool leaves_level_to_hardware(const ir::Value& value) const;
    [[nodiscard]] Wording wording_of(const ir::Value& value) const;
    [[nodiscard]] std::string attribute(const ir::Value& value) const;
    [[nodiscard]] std::string call(const ir::Value& value) const;
    [[nodiscard]] std::string operand_of(const ir::Value& parent, std::size_t index) const;
    [[nodiscard]] bool wants_name(std::size_t i, const std::string& expression) const;
    [[nodiscard]] std::string wanted_name(std::size_t i) const;
    void count_uses();
    void begin_layer(ir::LayerId layer);
    void statement(std::size_t i);

    const ir::Module& module_;
    const MaterialInterface& material_;
    Wording (*wording_)(ir::Op);
    bool looks_along_ray_;
    std::vector<bool> follows_the_pixels_;  // by value; empty in functions
    Names names_;
    std::vector<std::uint32_t> uses_;
    std::vector<bool> layer_result_;
    std::vector<std::string> expressions_;
    std::set<std::string_view> includes_;
    ir::LayerId current_layer_;
    std::string text_;
};

}  // namespace sg::emit
