// Putting bumps together.
#pragma once

#include "ir/reference/checked.hpp"

namespace sg::ref {

dvec3 combine_add(dvec3 a, dvec3 b);
dvec3 combine_scale(dvec3 g, double strength);
dvec3 combine_mask(dvec3 g, double mask);
dvec3 combine_mix(dvec3 a, dvec3 b, double t);

struct DerivPair {
    dvec2 first, second;
};
dvec3 combine_pd(dvec3 a, dvec3 b);
DerivPair combine_whiteout(dvec3 a, dvec3 b);
DerivPair combine_udn(dvec3 a, dvec3 b);
dvec3 combine_rnm(dvec3 a, dvec3 b);
dvec3 combine_reoriented(dvec3 n, dvec3 a, dvec3 b);
dvec3 combine_weighted(dvec3 a, dvec3 b, dvec2 weights);
dvec3 combine_additive(dvec3 a, dvec3 b);

}  // namespace sg::ref
