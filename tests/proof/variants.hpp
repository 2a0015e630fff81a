// Every kind of bump, drawn in each way that must not matter: from which camera, at which resolution, with
// which unwrap, placement and side.
#pragma once

#include "tests/proof/kinds.hpp"

namespace sg::proof {

enum class Change {
    plain,
    ortho,
    twice,
    mirrored_uv,
    negative,
    stretched,
    inside_mirror,
    inside_flip,
    turned
};
struct Variant {
    Change change;
    const char* name;
};
std::span<const Variant> all_variants();

constexpr std::uint32_t kVariantPixels = 128;
// Texels per side of every texture.
constexpr int kVariantTexels = 256;
// The share of the strengths of kinds.cpp: tilts of 0.2 to 2 degrees.
constexpr double kVariantStrength = 0.02;

const runtime::Scene& variant_scene(runtime::SmoothShape shape, Change change);
std::uint32_t variant_side(Change change);  // pixels

// One kind, compiled once for all variants but "flip", which is another material.
class DrawnKind {
public:
    DrawnKind(const KindCase& c, const target::ShaderLibrary& library) : case_(c), library_(library) {}

    // json: another material with the same textures, drawn as it is written. What a viewport of negative
    // height shows upside down is turned back.
    runtime::Picture normals(Change change, const std::string& json = "");
    // At a grid of pixels of such a picture. Degrees: to the truth with all weights held constant, from the
    // smooth surface to that truth, and of the normals without a bump to those of the smooth surface.
    struct Errors {
        std::vector<double> error, tilt, bare;
        double moved = 0;      // most: how far the surface is displaced
        double curvature = 0;  // largest between neighbours, 1 / world units
    };
    Errors against_truth(const runtime::Picture& normals, Change change);

private:
    const runtime::TextureSet& textures(const runtime::Artefact& artefact, Change change);

    const KindCase& case_;
    const target::ShaderLibrary& library_;
    std::map<bool, truth::Made> made_;  // by: it flips
    std::map<bool, Subject> subjects_;  // the same
    std::map<Change, runtime::TextureSet> textures_;
};

// The material of a kind, two-sided; `flip` chooses how. drawn: what is drawn, else that whose heights are
// known.
std::string variant_json(const KindCase& c, bool flip, bool drawn = true);
// What its textures hold for a variant.
asset::Image variant_texture(const KindCase& c, const std::string& name, Change change);

}  // namespace sg::proof
