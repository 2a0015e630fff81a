// node check_wgsl.mjs FILE.wgsl... : hands each to Dawn, the WebGPU of Chromium, which needs no device for it. What Dawn
// refuses is printed, one line a fault, and the exit code is 1. The last line is "checked".
import fs from 'node:fs';
import {create} from 'webgpu';

const gpu = create(['backend=null']);  // must outlive what comes from it
const adapter = await gpu.requestAdapter();
const device = await adapter.requestDevice();
console.warn = console.error = () => {};  // Dawn's own report of what is told below
let refused = 0;
for (const file of process.argv.slice(2)) {
  device.pushErrorScope('validation');
  const module = device.createShaderModule({code: fs.readFileSync(file, 'utf8')});
  for (const fault of (await module.getCompilationInfo()).messages) {
    if (fault.type !== 'error') continue;
    ++refused;
    console.log(`${file}:${fault.lineNum}:${fault.linePos}: ${fault.message}`);
  }
  await device.popErrorScope();
}
device.destroy();  // and no process.exit, which aborts its threads
process.exitCode = refused ? 1 : 0;
if (gpu) console.log('checked');
