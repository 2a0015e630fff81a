#version 450
#extension GL_GOOGLE_include_directive : require
// flat wall: fragment shader of the entry point 'depth', made by surfgradc.



void main() {
}
