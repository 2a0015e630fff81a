#version 450
#extension GL_GOOGLE_include_directive : require
// carved pebbles plus fine pebbles: fragment shader of the entry point 'depth', made by surfgradc.



void main() {
}
