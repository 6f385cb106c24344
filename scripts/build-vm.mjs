// Makes the firmware (.cache/vm/vm.wasm) from the published MicroPython package, unless it is there already.
import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readdirSync, readFileSync, renameSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { fileURLToPath } from 'node:url';

const require = createRequire(import.meta.url);
const root = new URL('..', import.meta.url);
const target = new URL('.cache/vm/vm.wasm', root);
const marker = new URL('.cache/vm/made-from', root);
const published = require.resolve('@micropython/micropython-webassembly-pyscript/micropython.wasm');

/** Everything the result depends on: the published file, the tool and our own steps. */
function fingerprint() {
  const hash = createHash('sha256');
  hash.update(readFileSync(published));
  hash.update(require('binaryen/package.json').version);
  const steps = new URL('src/vm/firmware/', root);
  for (const file of readdirSync(steps).sort()) hash.update(readFileSync(new URL(file, steps)));
  return hash.digest('hex');
}

const wanted = fingerprint();
if (existsSync(target) && existsSync(marker) && readFileSync(marker, 'utf8') === wanted) {
  console.log('VM: up to date');
} else {
  const started = Date.now();
  const tell = (step) => console.log(`VM: ${step} … (${Math.round((Date.now() - started) / 1000)} s)`);
  const { transform } = await import('../src/vm/firmware/transform.mjs');
  const bytes = transform(new Uint8Array(readFileSync(published)), tell);
  mkdirSync(new URL('.', target), { recursive: true });
  // A file that appears whole: an interrupted build leaves no half VM behind.
  writeFileSync(new URL('.cache/vm/vm.wasm.tmp', root), bytes);
  renameSync(fileURLToPath(new URL('.cache/vm/vm.wasm.tmp', root)), fileURLToPath(target));
  writeFileSync(marker, wanted);
  tell(`made, ${Math.round(bytes.length / 1024)} kB`);
}
