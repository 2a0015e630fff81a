// What `surface` says of the surface, apart from its choices: a field is the output of the same name.
#include <algorithm>

#include "base/ice.hpp"
#include "layers/kind.hpp"

namespace sg::layers {

std::span<const Field> surface_fields() {
    static const Field kFields[] = {
        {.name = "base_color",
         .kind = FieldKind::color,
         .fallback = 0.5,
         .minimum = 0,
         .maximum = 1,
         .doc = "linear rgb"},
        {.name = "metallic",
         .kind = FieldKind::number,
         .fallback = 0,
         .minimum = 0,
         .maximum = 1,
         .doc = "0: an insulator, 1: a metal"},
        {.name = "roughness",
         .kind = FieldKind::number,
         .fallback = 0.5,
         .minimum = 0,
         .maximum = 1,
         .doc = "perceptual: its square is alpha"},
        {.name = "specular",
         .kind = FieldKind::color,
         .fallback = 1,
         .minimum = 0,
         .maximum = 1,
         .doc = "colour of the highlight, linear rgb"},
        {.name = "shininess",
         .kind = FieldKind::number,
         .fallback = 8,
         .minimum = 1,
         .maximum = 1000,
         .doc = "exponent of the highlight: larger is narrower"},
        {.name = "occlusion",
         .kind = FieldKind::number,
         .fallback = 1,
         .minimum = 0,
         .maximum = 1,
         .doc = "of the ambient light; 1 is open"},
        {.name = "emission",
         .kind = FieldKind::color,
         .fallback = 0,
         .minimum = 0,
         .maximum = 1e4,
         .doc = "linear radiance"},
        {.name = "opacity",
         .kind = FieldKind::number,
         .fallback = 1,
         .minimum = 0,
         .maximum = 1,
         .doc = "the alpha of `forward`"},
    };
    return kFields;
}

ir::Output surface_output(const Field& field) {
    const std::span<const ir::Output> all = ir::all_outputs();
    auto found = std::find_if(all.begin(), all.end(),
                              [&](ir::Output output) { return ir::output_name(output) == field.name; });
    SG_ASSERT(found != all.end());
    return *found;
}

}  // namespace sg::layers
