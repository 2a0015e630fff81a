// Does not compile: the scale is nowhere declared.
vec3 dents(SgFrame frame) {
    float depth = 2.0;
    return depth * frame_scale * frame.normal;
}
