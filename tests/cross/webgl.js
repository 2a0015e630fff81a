// Draws each entry of `drawings` with WebGL 2 and writes its pixels into the page: one line each, the driver's words
// where it refuses a shader, else base64 of rows of rgba floats, upper row first.
'use strict';

function makeProgram(gl, drawing) {
  const program = gl.createProgram();
  for (const [kind, text] of [[gl.VERTEX_SHADER, drawing.vertex], [gl.FRAGMENT_SHADER, drawing.fragment]]) {
    const shader = gl.createShader(kind);
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(shader));
    gl.attachShader(program, shader);
  }
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program));
  return program;
}

// With that many colour attachments, and the texture that holds the depth, if any.
function makeTarget(gl, side, attachments, depth) {
  gl.bindFramebuffer(gl.FRAMEBUFFER, gl.createFramebuffer());
  const places = [];
  for (let i = 0; i < attachments; ++i) {
    const buffer = gl.createRenderbuffer();
    gl.bindRenderbuffer(gl.RENDERBUFFER, buffer);
    gl.renderbufferStorage(gl.RENDERBUFFER, gl.RGBA32F, side, side);
    places.push(gl.COLOR_ATTACHMENT0 + i);
    gl.framebufferRenderbuffer(gl.FRAMEBUFFER, places[i], gl.RENDERBUFFER, buffer);
  }
  if (depth) gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.TEXTURE_2D, depth, 0);
  gl.drawBuffers(places);
  if (gl.checkFramebufferStatus(gl.FRAMEBUFFER) !== gl.FRAMEBUFFER_COMPLETE) throw new Error('no float framebuffer');
  gl.viewport(0, 0, side, side);
}

function makeDepth(gl, side) {
  const texture = gl.createTexture();
  gl.activeTexture(gl.TEXTURE0);
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.texStorage2D(gl.TEXTURE_2D, 1, gl.DEPTH_COMPONENT32F, side, side);
  for (const name of ['TEXTURE_MIN_FILTER', 'TEXTURE_MAG_FILTER']) gl.texParameteri(gl.TEXTURE_2D, gl[name], gl.NEAREST);
  return texture;
}

// WebGL cannot read depth back: this copies it into colours, with alpha 1 where something was drawn.
const depthCopy = {
  vertex: `#version 300 es
    void main() { gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0); }`,
  fragment: `#version 300 es
    precision highp float;
    uniform highp sampler2D depth;
    out vec4 color;
    void main() {
      float d = texelFetch(depth, ivec2(gl_FragCoord.xy), 0).x;
      color = d < 1.0 ? vec4(d, d, d, 1.0) : vec4(0.0);
    }`,
};

function copyDepth(gl, depth, side) {
  makeTarget(gl, side, 1, null);
  depthCopy.program ??= makeProgram(gl, depthCopy);
  gl.useProgram(depthCopy.program);
  gl.disable(gl.DEPTH_TEST);
  gl.disable(gl.CULL_FACE);
  gl.activeTexture(gl.TEXTURE0);
  gl.bindTexture(gl.TEXTURE_2D, depth);
  gl.bindSampler(0, null);
  gl.drawArrays(gl.TRIANGLES, 0, 3);
}

function bindVertices(gl, drawing) {
  gl.bindVertexArray(gl.createVertexArray());
  for (const attribute of drawing.attributes) {
    gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
    gl.bufferData(gl.ARRAY_BUFFER, bytesOf(attribute.values), gl.STATIC_DRAW);
    gl.vertexAttribPointer(attribute.location, attribute.components, gl.FLOAT, false, 0, 0);
    gl.enableVertexAttribArray(attribute.location);
  }
  gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer());
  const indices = bytesOf(drawing.indices);
  gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, indices, gl.STATIC_DRAW);
  return indices.length / 4;
}

// ESSL 3.00 holds no numbers: blocks and samplers are bound by the names of the manifest.
function bindBlock(gl, program, slot) {
  const index = gl.getUniformBlockIndex(program, slot.name);
  if (index === gl.INVALID_INDEX) throw new Error('no block ' + slot.name);
  gl.uniformBlockBinding(program, index, slot.index);
  const buffer = gl.createBuffer();
  gl.bindBuffer(gl.UNIFORM_BUFFER, buffer);
  gl.bufferData(gl.UNIFORM_BUFFER, bytesOf(slot.bytes), gl.STATIC_DRAW);
  gl.bindBufferBase(gl.UNIFORM_BUFFER, slot.index, buffer);
}

function bindTexture(gl, program, slot, textures) {
  const location = gl.getUniformLocation(program, slot.name);
  if (location === null) throw new Error('no sampler ' + slot.name);
  gl.uniform1i(location, slot.index);
  gl.activeTexture(gl.TEXTURE0 + slot.index);
  gl.bindTexture(gl.TEXTURE_2D, gl.createTexture());
  textures[slot.texture].forEach((level, number) => {
    const bytes = bytesOf(level.bytes);
    const format = level.float ? gl.RGBA32F : slot.srgb ? gl.SRGB8_ALPHA8 : gl.RGBA8;
    gl.texImage2D(gl.TEXTURE_2D, number, format, level.width, level.height, 0, gl.RGBA,
                  level.float ? gl.FLOAT : gl.UNSIGNED_BYTE, level.float ? new Float32Array(bytes.buffer) : bytes);
  });
  const sampler = gl.createSampler();
  for (const name of ['TEXTURE_WRAP_S', 'TEXTURE_WRAP_T', 'TEXTURE_MIN_FILTER', 'TEXTURE_MAG_FILTER']) {
    gl.samplerParameteri(sampler, gl[name], gl[slot.sampler[name]]);
  }
  gl.bindSampler(slot.index, sampler);
}

// The planes, one after the other.
function readPlanes(gl, count, side) {
  const rows = new Float32Array(side * side * 4), pixels = new Float32Array(rows.length * count), width = side * 4;
  for (let i = 0; i < count; ++i) {
    gl.readBuffer(gl.COLOR_ATTACHMENT0 + i);
    gl.readPixels(0, 0, side, side, gl.RGBA, gl.FLOAT, rows);
    for (let y = 0; y < side; ++y) pixels.set(rows.subarray(y * width, (y + 1) * width), i * rows.length + (side - 1 - y) * width);
  }
  return base64Of(new Uint8Array(pixels.buffer));
}

function draw(gl, drawing, textures, side) {
  const program = makeProgram(gl, drawing), depth = makeDepth(gl, side);
  makeTarget(gl, side, drawing.attachments, depth);
  const count = bindVertices(gl, drawing);
  gl.useProgram(program);
  for (const slot of drawing.slots) slot.bytes === undefined ? bindTexture(gl, program, slot, textures) : bindBlock(gl, program, slot);
  for (let i = 0; i < drawing.attachments; ++i) gl.clearBufferfv(gl.COLOR, i, [0, 0, 0, 0]);
  gl.clearBufferfv(gl.DEPTH, 0, [1]);
  gl.enable(gl.DEPTH_TEST);
  drawing.cull ? gl.enable(gl.CULL_FACE) : gl.disable(gl.CULL_FACE);
  gl.drawElements(gl.TRIANGLES, count, gl.UNSIGNED_INT, 0);
  if (drawing.attachments === 0) copyDepth(gl, depth, side);
  const planes = readPlanes(gl, Math.max(drawing.attachments, 1), side), error = gl.getError();
  if (error !== gl.NO_ERROR) throw new Error('GL error ' + error);
  return planes;
}

function drawAll({side, textures, drawings}) {
  const gl = document.createElement('canvas').getContext('webgl2', {antialias: false});
  if (!gl) return ['no WebGL 2'];
  for (const extension of ['EXT_color_buffer_float', 'OES_texture_float_linear']) {
    if (!gl.getExtension(extension)) return ['no ' + extension];
  }
  const tell = work => {
    try {
      return work();
    } catch (error) {
      return 'refused: ' + error.message.replace(/\s+/g, ' ');
    }
  };
  return drawings.map(drawing => tell(() => draw(gl, drawing, textures, side)));
}

document.body.textContent = '\n' + drawAll(input).join('\n') + '\n';
