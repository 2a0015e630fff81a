// The runs of surfgrad-render that measure angles: --view error and --compare.
#pragma once

#include "runtime/cli.hpp"
#include "runtime/job.hpp"
#include "runtime/proof/angles.hpp"
#include "runtime/proof/material.hpp"
#include "runtime/proof/truth.hpp"

namespace sg::proof {

// Prints the numbers on standard output and writes the map of angles, if one is wanted. Gives the exit code.
int run_error_view(const runtime::Arguments& arguments, Files& files, Diags& diags);
int run_compare(const runtime::Arguments& arguments, Files& files, Diags& diags);

// A job whose truth is known.
struct Judge {
    std::unique_ptr<Material> material;
    std::deque<ref::MemoryTexture> texels;  // of the partners
    std::unique_ptr<Truth> truth;
    runtime::CameraMatrices camera;
};
// The job must be for the entry point `normal`, on one built-in shape. heights: TEXTURE=FILE[:LENGTH]. Fails
// with no_smooth_surface, module_missing, no_height, unknown_texture, and what reading files reports.
std::optional<Judge> make_judge(const runtime::Job& job, std::string_view mesh,
                                const std::filesystem::path& manifest, const std::filesystem::path& root,
                                std::span<const std::string> heights, Files& files, Diags& diags);

// The base surface's point that belongs to each pixel, relative to the camera.
std::optional<runtime::Picture> draw_positions(runtime::gpu::Device& device, const runtime::Job& job,
                                               Diags& diags);
// The truth at these points, and if asked for that with all weights held as they are at each.
struct TruePictures {
    runtime::Picture normal, held;
    Angles tilt;      // from the smooth surface to the truth
    Angles left_out;  // what bump mapping leaves out at most
};
TruePictures true_normals(const runtime::Job& job, Judge& judge, const runtime::Picture& positions,
                          bool held = false);

// Draws the normals and compares each with the truth at the point that its pixel shows.
std::optional<Angles> error_angles(runtime::gpu::Device& device, const runtime::Job& job, Judge& judge,
                                   Diags& diags);

}  // namespace sg::proof
