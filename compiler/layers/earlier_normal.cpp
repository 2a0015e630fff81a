// earlier_normal: back to the normal that an earlier entry of bump left, or to the mesh's.
#include "layers/kind.hpp"
#include "layers/lower_context.hpp"

namespace sg::layers {
namespace {

enum FieldIndex : std::size_t { kEntry };

ir::ValueId lower(LowerContext& context, FieldValues values) {
    ir::Builder& builder = context.builder();
    ir::ValueId n = context.normal();
    ir::ValueId earlier =
        values[kEntry].given ? context.entry_normal(values[kEntry].index) : context.surface_normal();
    ir::ValueId direction = builder.add(ir::Op::direction_of, {earlier});
    return builder.add(ir::Op::surfgrad_from_normal, {n, direction});
}

}  // namespace

const LayerKind& earlier_normal() {
    static const LayerKind kRow{
        .name = "earlier_normal",
        .doc =
            "the bump that leads back to the normal of an earlier entry of 'bump', or of the mesh: in an "
            "entry of its own a mask mixes that back in; strength is a factor on the slope",
        .fields = {{.name = "entry",
                    .kind = FieldKind::entry,
                    .doc = "whose normal; left out: the base normal of the mesh"}},
        .lower = lower,
    };
    return kRow;
}

}  // namespace sg::layers
