// Draws each entry of `input.drawings` with WebGPU and writes its pixels into the page, in the form of webgl.js.
'use strict';

async function makeModule(device, code) {
  const module = device.createShaderModule({code});
  const messages = (await module.getCompilationInfo()).messages.filter(m => m.type === 'error');
  if (messages.length > 0) throw new Error(messages.map(m => m.lineNum + ': ' + m.message).join('; '));
  return module;
}

function makeBuffer(device, base64, usage) {
  const bytes = bytesOf(base64);
  const buffer = device.createBuffer({size: (bytes.length + 15) & ~15, usage: usage | GPUBufferUsage.COPY_DST});
  device.queue.writeBuffer(buffer, 0, bytes);
  return buffer;
}

function makeTexture(device, image) {
  const usage = GPUTextureUsage.TEXTURE_BINDING | GPUTextureUsage.COPY_DST, size = [image.width, image.height];
  const texture = device.createTexture({size, format: 'rgba32float', usage});
  device.queue.writeTexture({texture}, bytesOf(image.bytes), {bytesPerRow: image.width * 16}, size);
  return texture;
}

// Groups and bindings are the sets and bindings of the SPIR-V.
function makeGroups(device, drawing, textures) {
  const layouts = [], groups = [];
  for (let set = 0; set < 3; ++set) {
    const entries = [], contents = [];
    for (const slot of drawing.slots.filter(s => s.set === set)) {
      const entry = {binding: slot.binding, visibility: GPUShaderStage.VERTEX | GPUShaderStage.FRAGMENT};
      if (slot.kind === 'uniform_buffer') {
        entries.push({...entry, buffer: {}});
        contents.push({binding: slot.binding, resource: {buffer: makeBuffer(device, slot.bytes, GPUBufferUsage.UNIFORM)}});
      } else if (slot.kind === 'texture') {
        entries.push({...entry, texture: {}});
        contents.push({binding: slot.binding, resource: makeTexture(device, textures[slot.texture]).createView()});
      } else {
        entries.push({...entry, sampler: {}});
        contents.push({binding: slot.binding, resource: device.createSampler(slot.sampler)});
      }
    }
    layouts.push(device.createBindGroupLayout({entries}));
    groups.push(device.createBindGroup({layout: layouts[set], entries: contents}));
  }
  return {layout: device.createPipelineLayout({bindGroupLayouts: layouts}), groups};
}

async function makePipeline(device, drawing, layout) {
  const buffers = drawing.attributes.map(a => ({
    arrayStride: a.components * 4,
    attributes: [{shaderLocation: a.location, offset: 0, format: 'float32x' + a.components}],
  }));
  return device.createRenderPipelineAsync({
    layout,
    vertex: {module: await makeModule(device, drawing.vertex), entryPoint: 'main', buffers},
    fragment: {
      module: await makeModule(device, drawing.fragment),
      entryPoint: 'main',
      targets: Array(drawing.attachments).fill({format: 'rgba32float'}),
    },
    primitive: {topology: 'triangle-list', frontFace: 'ccw', cullMode: drawing.cull ? 'back' : 'none'},
    depthStencil: {format: 'depth32float', depthWriteEnabled: true, depthCompare: 'less'},
  });
}

function recordDraw(device, encoder, drawing, pipeline, groups, targets) {
  const pass = encoder.beginRenderPass({
    colorAttachments: targets.colors.map(c => ({view: c.createView(), loadOp: 'clear', storeOp: 'store', clearValue: [0, 0, 0, 0]})),
    depthStencilAttachment: {view: targets.depth.createView(), depthLoadOp: 'clear', depthStoreOp: 'store', depthClearValue: 1},
  });
  pass.setPipeline(pipeline);
  groups.forEach((group, set) => pass.setBindGroup(set, group));
  drawing.attributes.forEach((a, i) => pass.setVertexBuffer(i, makeBuffer(device, a.values, GPUBufferUsage.VERTEX)));
  pass.setIndexBuffer(makeBuffer(device, drawing.indices, GPUBufferUsage.INDEX), 'uint32');
  pass.drawIndexed(bytesOf(drawing.indices).length / 4);
  pass.end();
}

// A depth buffer as a plane: (depth, depth, depth, 1), or zeros where nothing was drawn.
function planeOfDepth(depths) {
  const plane = new Float32Array(depths.length * 4);
  depths.forEach((d, i) => { if (d < 1) plane.set([d, d, d, 1], 4 * i); });
  return new Uint8Array(plane.buffer);
}

async function draw(device, drawing, textures, side) {
  device.pushErrorScope('validation');
  const {layout, groups} = makeGroups(device, drawing, textures);
  const pipeline = await makePipeline(device, drawing, layout);
  const usage = GPUTextureUsage.RENDER_ATTACHMENT | GPUTextureUsage.COPY_SRC, size = [side, side];
  const colors = Array.from({length: drawing.attachments}, () => device.createTexture({size, format: 'rgba32float', usage}));
  const depth = device.createTexture({size, format: 'depth32float', usage});
  const encoder = device.createCommandEncoder();
  recordDraw(device, encoder, drawing, pipeline, groups, {colors, depth});
  const buffer = device.createBuffer({size: side * side * 16 * Math.max(colors.length, 1), usage: GPUBufferUsage.COPY_DST | GPUBufferUsage.MAP_READ});
  colors.forEach((texture, i) => encoder.copyTextureToBuffer({texture}, {buffer, offset: side * side * 16 * i, bytesPerRow: side * 16}, size));
  if (colors.length === 0) encoder.copyTextureToBuffer({texture: depth, aspect: 'depth-only'}, {buffer, bytesPerRow: side * 4}, size);
  device.queue.submit([encoder.finish()]);
  const error = await device.popErrorScope();
  if (error) throw new Error(error.message);
  await buffer.mapAsync(GPUMapMode.READ);
  const bytes = buffer.getMappedRange();
  return base64Of(colors.length === 0 ? planeOfDepth(new Float32Array(bytes, 0, side * side)) : new Uint8Array(bytes));
}

async function drawAll({side, textures, drawings, modules}) {
  const adapter = navigator.gpu && await navigator.gpu.requestAdapter();
  if (!adapter) return ['no WebGPU'];
  const device = await adapter.requestDevice({
    requiredFeatures: ['float32-filterable'],
    requiredLimits: {maxColorAttachmentBytesPerSample: 64},  // of four attachments of floats
  });
  const tell = async work => {
    try {
      return await work();
    } catch (error) {
      return 'refused: ' + error.message.replace(/\s+/g, ' ');
    }
  };
  const lines = [];
  for (const drawing of drawings) lines.push(await tell(() => draw(device, drawing, textures, side)));
  for (const code of modules) lines.push(await tell(async () => (await makeModule(device, code), 'accepted')));
  return lines;
}

// A frame that is still being written holds back the end of loading, at which the browser prints the page.
const hold = document.body.appendChild(document.createElement('iframe'));
hold.contentDocument.open();
drawAll(input).catch(error => ['no answer: ' + error.message]).then(lines => { document.body.textContent = '\n' + lines.join('\n') + '\n'; });
