// noise: procedural bumps on a volume with analytic gradients.
#include "layers/kind.hpp"
#include "layers/lower_context.hpp"

namespace sg::layers {
namespace {

using ir::Op;
using ir::ValueId;

enum FieldIndex : std::size_t { kFunction, kSpace, kFrequency, kOctaves, kPower };
enum FunctionChoice : std::uint32_t { kPerlin, kFractalSum, kTurbulence };

ValueId lower(LowerContext& context, FieldValues values) {
    ir::Builder& builder = context.builder();
    auto space = static_cast<Space>(values[kSpace].index);
    ValueId frequency = context.number(values[kFrequency]);
    ValueId place = builder.add(Op::volume_scale, {context.volume(space), frequency}, "place");
    ValueId value;
    if (values[kFunction].index == kPerlin) {
        value = builder.add(Op::noise_perlin, {place}, "noise");
    } else {
        Op op = values[kFunction].index == kFractalSum ? Op::noise_fractal_sum : Op::noise_turbulence;
        value = builder.add_indexed(op, values[kOctaves].index, {place}, "noise");
    }
    if (values[kPower].given)
        value = builder.add(Op::noise_power, {value, context.number(values[kPower])}, "noise");
    ValueId gradient = builder.add(Op::noise_gradient, {frequency, value}, "gradient");
    return context.surfgrad_from_local(gradient, space);
}

}  // namespace

const LayerKind& noise() {
    static const LayerKind kRow{
        .name = "noise",
        .doc =
            "procedural bumps on a volume; strength is the height, in world units, of the value 1; in object "
            "space an instance that is scaled by s has features of s times the size and, at the same height, "
            "1/s of the slope",
        .fields =
            {{.name = "function",
              .kind = FieldKind::choice,
              .fallback = kFractalSum,
              .choices = {"perlin", "fractal_sum", "turbulence"},
              .doc =
                  "improved Perlin noise (-1 to 1), the sum of its octaves, or the sum of their magnitudes"},
             {.name = "space",
              .kind = FieldKind::choice,
              .choices = {"object", "world"},
              .doc = "where the noise lies: it moves with the object, or stands in the world"},
             {.name = "frequency",
              .kind = FieldKind::number,
              .fallback = 1,
              .minimum = 1e-6,
              .maximum = 1e6,
              .unit = "cells per unit of the space",
              .doc = "of the first octave; octaves that are smaller than a pixel fade out"},
             {.name = "octaves",
              .kind = FieldKind::integer,
              .fallback = 4,
              .minimum = 1,
              .maximum = 16,
              .doc = "how many, each of twice the frequency and half the height"},
             {.name = "power",
              .kind = FieldKind::number,
              .fallback = 1,
              .minimum = 0,
              .maximum = 16,
              .doc = "the value v >= 0 becomes v^power: above 1 it leaves dents where the noise is low"},
             follow_parallax()},
        .rules = {{.field = "octaves",
                   .word = "",
                   .other = "function",
                   .words = {"fractal_sum", "turbulence"},
                   .message = "'perlin' has one octave, expected 'octaves' beside 'fractal_sum' or "
                              "'turbulence' only"}},
        .lower = lower,
    };
    return kRow;
}

}  // namespace sg::layers
