// Purpose: the one triangle of a plugin's full-screen pass. Inputs: none; output: clip positions (-1,-1), (3,-1), (-1,3),
// which cover the target exactly once (no diagonal on which fragments would be shaded twice).
#version 460

void main() {
  gl_Position = vec4(float((gl_VertexIndex << 2) & 4) - 1.0, float((gl_VertexIndex << 1) & 4) - 1.0, 0.0, 1.0);
}
