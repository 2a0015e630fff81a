// From radiance, and from the numbers of the other views, to 8 bits for the eye. README.md states the
// formulas.
#pragma once

#include "asset/image.hpp"
#include "runtime/artefact.hpp"
#include "runtime/camera.hpp"
#include "runtime/picture.hpp"

namespace sg::runtime {

// Linear radiance (any non-negative number) to 0..1, still linear: Narkowicz' fit of the ACES curve (2015). A
// value that is not a number gives 0.
double tone_curve(double radiance);
// Linear 0..1 to sRGB 0..1 (IEC 61966-2-1).
double srgb_encode(double linear);

// Opaque, over a soft grey gradient. `exposure` in stops: radiance is multiplied by 2^exposure.
asset::Image lit_to_display(const Picture& picture, double exposure);

// What maps a position view: relative world space lies around the camera.
struct ViewSpace {
    Bounds bounds;
    glm::dvec3 camera_position{0};
};
// Transparent background. Directions 0.5 v + 0.5; positions scaled to the bounding box; uv as the fraction of
// s and t in red and green; vectors 0.5 + 0.5 v / m, where m is the greatest magnitude of any shown component
// in the picture.
asset::Image values_to_display(const Picture& picture, const DebugView& view, const ViewSpace& space);

}  // namespace sg::runtime
