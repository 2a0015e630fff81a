// node spirv_to_wgsl.mjs OUT FILE.spv... : writes OUT/FILE.spv.wgsl, or OUT/FILE.spv.refused with naga's words.
import fs from 'node:fs';
import path from 'node:path';
import {parseSpirv, validate, writeWgsl} from 'naga-wasm';

const [folder, ...files] = process.argv.slice(2);
for (const file of files) {
  const stem = path.join(folder, path.basename(file));
  try {
    const module = parseSpirv(fs.readFileSync(file));
    fs.writeFileSync(stem + '.wgsl', writeWgsl(module, validate(module)));
  } catch (error) {
    fs.writeFileSync(stem + '.refused', String(error.message ?? error));
  }
}
