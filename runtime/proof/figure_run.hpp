// Draws and measures a figure.
#pragma once

#include "runtime/gpu/device.hpp"
#include "runtime/proof/angles.hpp"
#include "runtime/proof/figure.hpp"

namespace sg::proof {

struct DrawnPicture {
    FigurePicture picture;
    std::string lit;    // PNG for the eye
    std::string error;  // PNG, the map of angles; "" without a truth
    Numbers numbers;    // of the angles to the truth
    Numbers held;       // and to that with its weights held, if the figure asks for it
    std::vector<double> degrees, held_degrees;  // of which these are the numbers, per pixel
    std::string json;                           // the material
    std::string glsl;                           // its fragment shader of the entry point `forward`
    runtime::Picture normals;
};

struct DrawnFigure {
    Figure figure;
    std::vector<DrawnPicture> pictures;
    std::string
        truth;  // PNG: normals of the displaced surface, lit by the direction of the light; "" without
    // Per pixel, degrees from the smooth surface to the truth, and what bump mapping leaves out of that at
    // most.
    std::vector<double> tilt, left_out;
    Numbers most_left_out;  // of these
    Numbers neglected;      // of the angles between the truth and that with its weights held, if asked for
    std::vector<std::pair<std::string, bool>> claims;  // what was measured, and whether it holds
};

// shrink: divides the size, for quick checks. Everything is found by surfgradc beside this program. A claim
// that does not hold is an error (claim_failed).
std::optional<DrawnFigure> draw_figure(const Figure& figure, std::uint32_t shrink,
                                       runtime::gpu::Device& device, Files& files, Diags& diags);

}  // namespace sg::proof
