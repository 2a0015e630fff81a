// The lines of main() that compute a module's values.
#pragma once

#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "emit/interface.hpp"
#include "emit/names.hpp"
#include "emit/plan.hpp"
#include "ir/ir.hpp"

namespace sg::emit {

class Body {
public:
    Body(const ir::Module& module, const MaterialInterface& material,
         Wording (*wording)(ir::Op) = stage_wording);

    // The statements, each on a line of any length (wrap.hpp), indented by four blanks.
    [[nodiscard]] const std::string& text() const { return text_; }
    // How a value is written where it is used.
    [[nodiscard]] std::string operand(ir::ValueId id) const { return expressions_[id.index]; }
    [[nodiscard]] const std::set<std::string_view>& includes() const { return includes_; }

private:
    [[nodiscard]] std::string expression(std::size_t index) const;
    [[nodiscard]] Wording wording_of(std::size_t index) const;
    [[nodiscard]] std::string attribute(const ir::Value& value) const;
    [[nodiscard]] std::string call(const ir::Value& value) const;
    [[nodiscard]] std::string operand_of(std::size_t parent, std::size_t index) const;
    [[nodiscard]] std::string_view plainer_wording(const ir::Value& value) const;
    [[nodiscard]] std::string wanted_name(std::size_t i) const;
    void write(const std::vector<std::string>& statements);
    [[nodiscard]] std::vector<ir::LayerId> looks_without_lines(std::vector<ir::ValueId> open,
                                                               std::vector<bool>& has_lines,
                                                               std::vector<bool>& seen) const;
    void begin_paragraph(std::span<const ir::LayerId> layers);

    const ir::Module& module_;
    const MaterialInterface& material_;
    Wording (*wording_)(ir::Op);
    Plan plan_;
    Names names_;
    std::vector<std::string> expressions_;
    std::set<std::string_view> includes_;
    std::string text_;
};

}  // namespace sg::emit
