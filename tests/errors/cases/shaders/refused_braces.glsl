#ifdef WIDE
vec3 dents(SgFrame frame) {
#else
vec3 dents(SgFrame frame) {
#endif
    return frame.normal;
}
