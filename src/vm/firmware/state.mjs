// What a VM's state consists of: its memory, of a fixed size, and its global variables.
import { onlyMatch, replaceOnce } from './wat.mjs';

/**
 * 4 MiB in pages of 64 KiB. The published 16 MiB are for programs of a browser. Ours need 1.8: heap, C stack, a suspended
 * program's stack, and the C code's own data; the rest is for long texts on their way. JavaScript's collector counts all of
 * it for each VM that was given up, touched or not: with 16 MiB it took a quarter of the time of short runs.
 */
const MEMORY_PAGES = 64;

/** How much of the C stack Python may use before it raises "maximum recursion depth exceeded", in bytes. */
const STACK_LIMIT_BYTES = 72 * 1024;

/** Fixes the memory's size: the host refuses to let it grow (../run/firmware.ts, emscripten_resize_heap). */
export function fixMemory(module) {
  const [declared] = onlyMatch(module.head, 'memory', /\(memory \S+ 259 32768\)/);
  module.head = module.head.replace(declared, declared.replace('259 32768', `${MEMORY_PAGES} ${MEMORY_PAGES}`));
}

/** The port allows 32 kB of C stack; the run-time side gives a larger one. */
export function limitStack(module) {
  const init = onlyMatch(module.head, 'mp_js_init', /\(export "mp_js_init" \(func \$([^\s)]+)\)\)/)[1];
  replaceOnce(module, init, 'C stack limit', /\(i32\.const 32768\)/, `(i32.const ${STACK_LIMIT_BYTES})`);
}

/**
 * Exports each global variable that can change, so that the host can copy all of a VM's state (../run/library-copy.ts). Those
 * that suspending adds later are 0 while nothing is suspended.
 */
export function exportState(module) {
  const exported = new Set(
    [...module.head.matchAll(/\(export "[^"]*" \(global \$([^\s)]+)\)\)/g)].map(([, name]) => name),
  );
  const variables = [...module.head.matchAll(/\(global \$([^\s)]+) \(mut /g)].map(([, name]) => name);
  for (const name of variables.filter((each) => !exported.has(each)))
    module.head += `\n (export "state:${name}" (global $${name}))`;
}
