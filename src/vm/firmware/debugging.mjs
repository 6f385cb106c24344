// What a debugger reads from outside (../debug): which functions run now, the names of their local variables, and where
// MicroPython keeps its names. The program does nothing for it but keep a list of its running functions, one word each.
import { bodyStart, flat, onlyFunction, only } from './wat.mjs';

/** Offsets in mp_state_ctx (py/mpstate.h): `dict_locals` of the thread, and the last pool of interned names. */
const STATE = { locals: 24, pools: 48 };

/**
 * Finds scope_free (py/scope.c): the compiler calls it for each scope at the end, when code and slots are known.
 *
 * @returns {string} its name; call it while functions have the shape in which they were published
 */
export function findScopeEnd(module) {
  return onlyFunction(
    module,
    'scope_free',
    /^\(func \$\S+ \(param \$0 i32\) \(call (\$\S+) \(i32\.load offset=44 \(local\.get \$0\)\)\) \(call \1 \(local\.get \$0\)\)\)$/,
  ).name;
}

/** Exports the addresses of the interned names and of the names of the module or class that runs now. */
export function tellState(module) {
  const shape =
    /^\(func \$\S+ \(param \$0 i32\) \(result i32\) .*\(i32\.add \(i32\.const (\d+)\) \(i32\.const (\d+)\)\).*\(loop .*\(i32\.const 2147483647\).*\(i32\.load offset=24 /;
  const { match } = onlyFunction(module, 'qstr_str', shape);
  const [state, pools] = [Number(match[1]), Number(match[2])];
  if (pools !== STATE.pools)
    throw new Error(`qstr_str: the pools lie at ${pools} of the state, not at ${STATE.pools}.`);
  // The built-in locals() reads them there.
  const locals = `(func $N (result i32) (i32.load offset=${state} (i32.const ${STATE.locals})))`;
  const readers = [...module.functions.values()].filter(
    (text) => flat(text).replace(/^\(func \S+/, '(func $N') === locals,
  );
  only(readers, 'locals()');
  for (const [name, address] of [
    ['interned', state + pools],
    ['locals_at', state + STATE.locals],
  ])
    module.head += `\n (global $${name} i32 (i32.const ${address}))\n (export "${name}" (global $${name}))`;
}

/** Reports each compiled scope to the host. Call it after pointers were spilled: nothing may be spilled for it. */
export function tellScopes(module, scopeEnd) {
  const text = flat(module.functions.get(scopeEnd));
  const body = bodyStart(text);
  module.functions.set(scopeEnd, `${text.slice(0, body)}(call $scope (local.get $0)) ${text.slice(body)}`);
}

/** Around a run of the interpreter: its code_state (the first parameter) goes to the end of the list and off again. */
export const enterFrame = `(i32.store (global.get $frames_end) (local.get $0))
    (global.set $frames_end (i32.add (global.get $frames_end) (i32.const 4)))`;
export const leaveFrame = '(global.set $frames_end (i32.sub (global.get $frames_end) (i32.const 4)))';

/** Asks the host before a bytecode that has a mark. @param {string} code the local with the bytecode's address */
export const askBefore = (code) => `(if (global.get $marks)
  (then (if (i32.load8_u (i32.add (global.get $marks) (local.get $${code}))) (then (call $look)))))`;
