// Compiles the device's Python modules (src/vm/library/{modules,internal}/*.py) to bytecode, as .cache/vm/library.json: name → text
// (asText).
import { mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';

const require = createRequire(import.meta.url);
// The compiler's loader would fetch its .wasm by a path, which Node refuses; without fetch it reads the file.
delete globalThis.fetch;
process.setMaxListeners(0); // its loader adds listeners for each file
const { compile } = require('@pybricks/mpy-cross-v6');
const wasm = require.resolve('@pybricks/mpy-cross-v6/build/mpy-cross-v6.wasm');
const root = new URL('..', import.meta.url);
const FOLDERS = ['modules', 'internal'].map((name) => new URL(`src/vm/library/${name}/`, root));
const sources = FOLDERS.flatMap((folder) => readdirSync(folder).map((file) => ({ file, path: new URL(file, folder) })));

/**
 * Bytes as a text of which each character has its byte as the lower half of its code, so that what is letters stays legible
 * and JSON escapes nothing. Of base64 a compressor recognises little: the page would load 6 kB more.
 */
const asText = (bytes) =>
  Array.from(bytes, (byte) => String.fromCharCode(isPlain(byte) ? byte : 0x100 + byte)).join('');
const isPlain = (byte) => /[ !#-[\]-~]/.test(String.fromCharCode(byte));

const modules = {};
for (const { file, path } of sources
  .filter(({ file }) => file.endsWith('.py'))
  .sort((a, b) => (a.file < b.file ? -1 : 1))) {
  const source = readFileSync(path, 'utf8');
  // The firmware's small integers have 31 bits; the file name is what marks a frame as the library's.
  const result = await compile(file, source, ['-msmall-int-bits=31', '-s', `/lib/${file}`], wasm);
  if (!result.mpy) throw new Error(`${file}: ${result.err.join('\n')}`);
  modules[file.replace(/\.py$/, '.mpy')] = asText(result.mpy);
}
mkdirSync(new URL('.cache/vm/', root), { recursive: true });
writeFileSync(new URL('.cache/vm/library.json', root), `${JSON.stringify(modules)}\n`);
console.log(`Library: ${Object.keys(modules).length} modules compiled`);
