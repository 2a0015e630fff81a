#version 450
#extension GL_GOOGLE_include_directive : require
// rock, baked map first: fragment shader of the entry point 'depth', made by surfgradc.



void main() {
}
