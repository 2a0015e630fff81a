#version 450
#extension GL_GOOGLE_include_directive : require
// pebbles, one step: fragment shader of the entry point 'depth', made by surfgradc.



void main() {
}
