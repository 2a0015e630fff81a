// A figure: one scene, several materials, what each is compared with, and what is claimed about it.
//
//   { "title": "...", "source": "...", "text": "what to see",
//     "mesh": "sphere", "detail": 4, "size": [360, 300], "light": [x, y, z],
//     "camera": { "position": [x, y, z], "target": [x, y, z], "fov": 30, "ortho": 0 },
//     "materials": "..",                                  where textures are, relative to this file
//     "truth": { "material": "ours.json", "heights": ["map=textures/h.png:0.1"], "parameters": ["a=1"],
//                "held": true },
//     "pictures": [ { "id": "old", "material": "old.json", "label": "...", "parameters": ["a=1"] } ],
//     "claims": [ { "text": "...", "picture": "old", "number": "median", ...one of
//                   "below": 0.5 | "above": 5 | "times": 5, "than": "ours" | "apart": 0.1, "from": "ours",
//                   "held": true, "tilted": 10, "beyond": true } ] }
//
// Numbers are degrees: median, p95, p99 or max of the angles to the truth, or with "from" to another picture.
// Where weights vary over the surface (shares of planes, edges of decals) every method leaves out their
// change, H grad w. "held": true in "truth" also measures the pictures against the surface whose weights are
// held as they are at each pixel, and how far that is from the truth; a claim with "held": true is about
// those angles. "tilted": 10 counts only pixels where the truth is 10 degrees or more from the smooth
// surface: level ground, which every method shows alike, would hide what they do to slopes. "beyond": true
// takes from each pixel's angle what bump mapping leaves out there at most (truth.hpp), with "held": true in
// "truth" H grad w as well: what remains is filters, texels and mistakes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/diag.hpp"
#include "base/files.hpp"
#include "runtime/camera.hpp"

namespace sg::proof {

struct FigurePicture {
    std::string id, material, label;
    std::vector<std::string> parameters;
};

struct Claim {
    enum class Kind { below, above, times, apart };
    std::string text, picture, other, number = "median";
    Kind kind = Kind::below;
    double value = 0;
    bool held = false;    // against the truth with its weights held
    bool beyond = false;  // what exceeds, at each pixel, what bump mapping leaves out
    double tilted = 0;    // degrees: only where the truth is that far from the smooth surface
    Place place;
};

struct Figure {
    std::string name;  // NAME.figure.json
    std::string title, source, text;
    std::string mesh;
    std::uint32_t detail = 1, width = 360, height = 300;
    std::optional<glm::dvec3> light;
    std::optional<runtime::Camera> camera;
    std::filesystem::path folder, materials;
    std::string truth;  // a material, or "" where nothing is displaced
    std::vector<std::string> heights, truth_parameters;
    bool held = false;  // measure against held weights too
    std::vector<FigurePicture> pictures;
    std::vector<Claim> claims;
};

// All faults are reported: json_*, unknown_key, missing_key, wrong_type, out_of_range, unknown_choice.
std::optional<Figure> read_figure(const std::filesystem::path& file, Files& files, Diags& diags);

}  // namespace sg::proof
