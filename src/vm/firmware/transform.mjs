// Turns the published MicroPython .wasm into one that can be suspended anywhere, counts its work, collects garbage
// inside a fixed heap and never spins on its own. Every place is found by its shape (see wat.mjs: exactly one match).
// ../run/firmware.ts says what the run-time side expects of the result.
import binaryen from 'binaryen';
import { askBefore, enterFrame, findScopeEnd, leaveFrame, tellScopes, tellState } from './debugging.mjs';
import { callDirectly, shorten } from './direct-calls.mjs';
import { echoPasted } from './echo-pasted.mjs';
import { orderKeywordArguments } from './keyword-order.mjs';
import { hideLibrary } from './library-hidden.mjs';
import { refuseCallsAsNative } from './native-calls.mjs';
import { operateAsTheBoard } from './operators.mjs';
import { collectProgramAlone } from './program-alone.mjs';
import { computeInSingles } from './single-floats.mjs';
import { readFormatsAsTheBoard } from './earlier-formats.mjs';
import { chargeThreshold, chargeWork, findWork } from './work-in-c.mjs';
import { exportState, fixMemory, limitStack } from './state.mjs';
import { speakAsTheDevice } from './words.mjs';
import { declareVersion } from './version.mjs';
import { readWholeNumbersAsTheBoard } from './whole-numbers.mjs';
import {
  addressOfText,
  bodyStart,
  expressionEnd,
  flat,
  joinModule,
  only,
  onlyFunction,
  onlyMatch,
  splitModule,
} from './wat.mjs';

/** Number of our library's bytecodes that one call may run free of charge; the run-time side has the same number. */
const FREE_LIBRARY_BYTECODES = 20_000;

const EMPTY = '\\(i32\\.const 0\\)';

/**
 * @param {Uint8Array} published the .wasm of the npm package
 * @param {(step: string) => void} report called with the name of each step
 * @returns {Uint8Array} the firmware
 */
export function transform(published, report) {
  report('reading');
  const original = binaryen.readBinary(published);
  const features = original.getFeatures();
  const build = (module, passes) => {
    const result = binaryen.parseText(joinModule(module));
    result.setFeatures(features);
    if (!result.validate()) throw new Error('The transformed module is not valid WebAssembly.');
    result.runPasses(passes);
    return result;
  };
  // The pass that spills pointers finds the stack pointer by its name.
  const module = splitModule(original.emitText().replace(/\$global\$0(?!\d)/g, '$__stack_pointer'));
  original.dispose();
  const work = findWork(module);
  const scopeEnd = findScopeEnd(module);
  declareHost(module);
  tellState(module);
  computeInSingles(module);
  collectInsideFixedHeap(module);
  tellHeapPlace(module);
  freeReserveOnMemoryError(module);
  collectProgramAlone(module);
  hideLibraryFrames(module, findInterpreter(module));
  exportScheduler(module);
  replaceEndlessLoops(module);
  limitStack(module);
  orderKeywordArguments(module);
  refuseCallsAsNative(module);
  hideLibrary(module);
  beTheBoardsVersion(module);
  echoPasted(module);
  fixMemory(module);
  const directCalls = callDirectly(module);

  report('spilling pointers for the collector');
  const spilled = build(module, ['spill-pointers']);
  // Metering and shorter ways come after. They allocate nothing, so pointers need not be spilled for them, and must not be: the
  // contents of the stack slots would depend on when ticks come, and so on how often the program is suspended. What the
  // (conservative) collector keeps would depend on it, too.
  const metered = splitModule(spilled.emitText());
  spilled.dispose();
  shorten(metered, directCalls);
  meter(metered, findInterpreter(metered));
  chargeWork(metered, work);
  tellScopes(metered, scopeEnd);
  exportState(metered);

  report('making it suspendable');
  const result = suspendable(build, metered);
  report('optimising');
  result.optimize();
  return result.emitBinary();
}

function suspendable(build, module) {
  binaryen.setOptimizeLevel(2);
  binaryen.setShrinkLevel(0);
  const imports = 'env.invoke_*,env.call0,env.call1,env.call2,env.calln,host.tick,host.look';
  binaryen.setPassArgument('asyncify-imports', imports);
  return build(module, ['asyncify']);
}

/** Makes the language and its messages those of the board's MicroPython. */
function beTheBoardsVersion(module) {
  speakAsTheDevice(module);
  operateAsTheBoard(module);
  readWholeNumbersAsTheBoard(module);
  readFormatsAsTheBoard(module);
}

/** mp_execute_bytecode is the function with the widest jump table: the dispatch of the bytecodes. */
function findInterpreter(module) {
  const widest = [...module.functions].map(([name, text]) => ({ name, labels: widestTable(flat(text)) }));
  return only(
    widest.filter(({ labels }) => labels >= 80),
    'bytecode interpreter',
  ).name;
}

const widestTable = (text) =>
  Math.max(0, ...[...text.matchAll(/\(br_table ((?:\$\S+ )+)/g)].map((match) => match[1].trim().split(' ').length));

/**
 * The published build collects only between programs: gc_collect() raises a flag, gc_collect_top_level() acts on it.
 * Ours marks at once, from the globals, the Python stack and the C stack (to which spill-pointers brings all pointers).
 */
function collectInsideFixedHeap(module) {
  const collect = onlyFunction(
    module,
    'gc_collect',
    new RegExp(`^\\(func \\$\\S+ \\(i32\\.store8 offset=(\\d+) ${EMPTY} \\(i32\\.const 1\\)\\)\\)$`),
  );
  const top = onlyFunction(
    module,
    'gc_collect_top_level',
    new RegExp(
      `\\(i32\\.store8 offset=${collect.match[1]} ${EMPTY} ${EMPTY}\\) \\(call \\$([^\\s)]+)\\) \\(call \\$([^\\s)]+)\\)`,
    ),
  );
  const [start, end] = [top.match[1], top.match[2]];
  const stack = onlyMatch(
    flat(module.functions.get(start)),
    'Python stack bounds',
    /\(i32\.sub \(i32\.load offset=(\d+) \(i32\.const (\d+)\)\) \(local\.tee \$\d+ \(i32\.load offset=\1 \(i32\.const (\d+)\)\)\)\)/,
  );
  const current = Number(stack[1]) + Number(stack[2]);
  const bottom = Number(stack[1]) + Number(stack[3]);
  const overflowed = onlyMatch(
    flat(module.functions.get(end)),
    'mark stack overflow flag',
    /\(i32\.eqz \(i32\.load offset=(\d+) \(i32\.const (\d+)\)\)\)/,
  );
  const overflow = Number(overflowed[1]) + Number(overflowed[2]);
  const load = (address) => `(i32.load (i32.const ${address}))`;
  const store = (address, value) => `(i32.store (i32.const ${address}) ${value})`;
  module.functions.set(
    collect.name,
    `(func $${collect.name} (local $overflow i32) (local $bottom i32) (local $current i32)
      (call $${start})
      (local.set $overflow ${load(overflow)})
      (local.set $bottom ${load(bottom)})
      (local.set $current ${load(current)})
      ${store(bottom, '(global.get $__stack_pointer)')}
      ${store(current, '(global.get $stack_base)')}
      (call $${start})
      ${store(overflow, `(i32.or ${load(overflow)} (local.get $overflow))`)}
      ${store(bottom, '(local.get $bottom)')}
      ${store(current, '(local.get $current)')}
      (call $${end})
      (call $collected))`,
  );
  const split = onlyFunction(
    module,
    'gc_get_max_new_split',
    /^\(func \$\S+ \(result i32\) \(i32\.const 134217728\)\)$/,
  );
  module.functions.set(split.name, `(func $${split.name} (result i32) (i32.const 0))`);
  chargeAllocations(module, collect.name);
}

/** gc_init reports where the heap lies, so that the run-time side can divide it between library and program. */
function tellHeapPlace(module) {
  const init = onlyFunction(
    module,
    'gc_init',
    /^\(func \$\S+ \(param \$0 i32\) \(param \$1 i32\) \(local [^)]*\) \(i32\.store .*\(i32\.const 524\)/,
  );
  const text = flat(module.functions.get(init.name));
  const body = bodyStart(text);
  const tell =
    '(global.set $heap_start (local.get $0)) (global.set $heap_end (i32.and (local.get $1) (i32.const -16)))';
  module.functions.set(init.name, `${text.slice(0, body)}${tell} ${text.slice(body)}`);
}

/** gc_alloc is the large one of the two callers of gc_collect; an allocation by the pupil's code costs time. */
function chargeAllocations(module, collect) {
  const allocate = onlyFunction(
    module,
    'gc_alloc',
    new RegExp(`^\\(func \\$\\S+ \\(param \\$0 i32\\) \\(param \\$1 i32\\) \\(result i32\\).*\\(call \\$${collect}\\)`),
  );
  const text = flat(module.functions.get(allocate.name));
  const body = bodyStart(text);
  const charge = `(if (global.get $in_program) (then (global.set $gas (i32.sub (global.get $gas) (global.get $allocation_cost)))))`;
  module.functions.set(allocate.name, `${text.slice(0, body)}${charge} ${text.slice(body)}`);
  chargeThreshold(module, collect, allocate.name);
}

/**
 * A MemoryError needs memory itself, for its message and its traceback. The heap holds a reserve. The C function that
 * raises the error frees it first, so that even a heap full of small objects ends in an error that names its line.
 * Until then, the last word of the C stack keeps the reserve (see src/vm/run/heap.ts, which also takes it back after a
 * collection).
 */
function freeReserveOnMemoryError(module) {
  const fail = addressOfText(module, 'memory allocation failed, allocating %u bytes');
  const raise = onlyFunction(
    module,
    'm_malloc_fail',
    new RegExp(`^\\(func \\$\\S+ \\(param \\$0 i32\\) .*\\(i32\\.const ${fail}\\)`),
  );
  const free = onlyFunction(
    module,
    'gc_free',
    /^\(func \$\S+ \(param \$0 i32\) (?:\(local \$\d+ i32\) )*\(block \$\S+ \(br_if \$\S+ \(i32\.eqz \(local\.get \$0\)\)\) \(br_if \$\S+ \(i32\.gt_u \(i32\.and \(i32\.load16_u/,
  );
  const text = flat(module.functions.get(raise.name));
  const body = bodyStart(text);
  const giveFree = `(if (global.get $reserve) (then
    (call $${free.name} (global.get $reserve))
    (global.set $reserve (i32.const 0))
    (i32.store (i32.sub (global.get $stack_base) (i32.const 4)) (i32.const 0))))`;
  module.functions.set(raise.name, `${text.slice(0, body)}${giveFree} ${text.slice(body)}`);
}

/**
 * At each bytecode: code of the pupil (above `program_start` in memory, where the library ends) uses up `gas`, which is
 * simulated time; code of our library uses up `library_gas`, which only prevents endless spinning. While `marks` is not 0,
 * the host is asked before each bytecode of the pupil's whose byte there is not 0 (../run/marks.ts).
 */
function meter(module, interpreter) {
  const text = flat(module.functions.get(interpreter));
  const table = only(
    [...text.matchAll(/\(br_table ((?:\$\S+ )+)/g)].filter((match) => match[1].trim().split(' ').length >= 80),
    'bytecode dispatch',
  );
  const operand = table.index + table[0].length;
  const end = expressionEnd(text, operand);
  const expression = text.slice(operand, end);
  const code = onlyMatch(expression, 'bytecode pointer', /\(i32\.load8_u \(local\.get \$(\d+)\)\)/)[1];
  const use = (global) =>
    `(global.set $${global} (i32.sub (global.get $${global}) (i32.const 1))) (if (i32.le_s (global.get $${global}) (i32.const 0)) (then (call $tick)))`;
  const metered = `(block (result i32)
    (if (i32.ge_u (local.get $${code}) (global.get $program_start))
      (then
        (global.set $in_program (i32.const 1))
        (global.set $library_gas (i32.const ${FREE_LIBRARY_BYTECODES}))
        ${use('gas')}
        ${askBefore(code)})
      (else (global.set $in_program (i32.const 0)) ${use('library_gas')}))
    ${expression})`;
  const inner = `${interpreter}_metered`;
  const body = (text.slice(0, operand) + metered + text.slice(end)).replace(
    `(func $${interpreter} `,
    `(func $${inner} `,
  );
  module.functions.set(inner, body);
  module.functions.set(interpreter, returningTo(interpreter, inner, text));
}

/**
 * C code that the program has called goes on as the program's when it has asked a function of the library in between:
 * an iterator, a `__getattr__`.
 */
function returningTo(name, inner, text) {
  const [parameters] = /^(?:\(param \$\d+ i32\) )+\(result i32\)/.exec(text.slice(text.indexOf('(param'))) ?? [];
  if (parameters === undefined) throw new Error('The interpreter has another signature.');
  const given = [...parameters.matchAll(/\$\d+/g)].map(([parameter]) => `(local.get ${parameter})`).join(' ');
  return `(func $${name} ${parameters} (local $asked_by i32) (local $how i32)
    (local.set $asked_by (global.get $in_program))
    ${enterFrame}
    (local.set $how (call $${inner} ${given}))
    ${leaveFrame}
    (global.set $in_program (local.get $asked_by))
    (local.get $how))`;
}

/**
 * Leaves frames of library code out of tracebacks as they are recorded: one per function that the interpreter leaves.
 */
function hideLibraryFrames(module, interpreter) {
  const addFrame = importName(module, 'invoke_viiii');
  const text = flat(module.functions.get(interpreter));
  const call = onlyMatch(
    text,
    'mp_obj_exception_add_traceback',
    new RegExp(`\\(call \\$${addFrame.replace('$', '\\$')} \\(i32\\.const`),
  );
  const end = expressionEnd(text, call.index);
  // code_state is the interpreter's first parameter; its first word is the function, whose fourth is the bytecode.
  const code = '(i32.load offset=12 (i32.load (local.get $0)))';
  const guarded = `(if (i32.ge_u ${code} (global.get $program_start)) (then ${text.slice(call.index, end)}))`;
  module.functions.set(interpreter, text.slice(0, call.index) + guarded + text.slice(end));
}

function importName(module, name) {
  return onlyMatch(module.head, `import ${name}`, new RegExp(`\\(import "env" "${name}" \\(func \\$([^\\s)]+)`))[1];
}

/**
 * Exports mp_sched_schedule, a query (1 = a callback can run, 2 = an exception is pending) and a function that raises
 * any exception in the program, as the published mp_sched_keyboard_interrupt does with its own.
 */
function exportScheduler(module) {
  const interrupt = onlyMatch(
    module.head,
    'mp_sched_keyboard_interrupt',
    /\(export "mp_sched_keyboard_interrupt" \(func \$([^\s)]+)\)\)/,
  )[1];
  const pending = onlyMatch(
    flat(module.functions.get(interrupt)),
    'pending exception and scheduler state',
    /^\(func \$\S+ \(i32\.store offset=(\d+) \(i32\.const (\d+)\).*\(i32\.load16_u offset=(\d+) \(i32\.const (\d+)\)\)/,
  );
  const [exceptionAt, stateAt] = [Number(pending[1]) + Number(pending[2]), Number(pending[3]) + Number(pending[4])];
  const schedule = onlyFunction(
    module,
    'mp_sched_schedule',
    new RegExp(
      `^\\(func \\$\\S+ \\(param \\$0 i32\\) \\(param \\$1 i32\\) \\(result i32\\)(?!.*br_table).*\\(i32\\.store16 offset=${pending[3]} \\(i32\\.const ${pending[4]}\\)`,
    ),
  );
  module.head += `\n (export "mp_sched_schedule" (func $${schedule.name}))\n (export "queued" (func $queued))\n (export "set_pending" (func $set_pending))`;
  module.functions.set(
    'queued',
    `(func $queued (result i32)
      (i32.or
        (i32.eqz (i32.load16_u (i32.const ${stateAt})))
        (i32.shl (i32.ne (i32.load (i32.const ${exceptionAt})) (i32.const 0)) (i32.const 1))))`,
  );
  module.functions.set(
    'set_pending',
    `(func $set_pending (param $0 i32)
      (i32.store (i32.const ${exceptionAt}) (local.get $0))
      (if (i32.eq (i32.load16_u (i32.const ${stateAt})) (i32.const 1))
        (then (i32.store16 (i32.const ${stateAt}) (i32.const 0)))))`,
  );
}

/**
 * The C code ends a hopeless situation (nlr_jump_fail, a fatal error) in an empty endless loop. Ours tells the host.
 */
function replaceEndlessLoops(module) {
  const loop = /\(loop \$(\S+) \(br \$\1\)\)/g;
  let count = 0;
  for (const [name, text] of module.functions) {
    const line = flat(text);
    const found = line.match(loop);
    if (!found) continue;
    count += found.length;
    module.functions.set(name, line.replace(loop, '(call $fatal) (unreachable)'));
  }
  if (count !== 2) throw new Error(`Endless loops: expected 2 places, found ${count}.`);
}

/** Declares the imports from the host beyond the published ones, and the counters shared with it. */
function declareHost(module) {
  const lastImport = module.head.lastIndexOf('(import ');
  const end = expressionEnd(module.head, lastImport);
  const imports = [...['tick', 'look', 'fatal', 'collected'].map((name) => [name, '']), ['scope', ' (param i32)']]
    .map(([name, taken]) => ` (import "host" "${name}" (func $${name}${taken}))`)
    .join('\n');
  const counters = [
    'gas',
    'library_gas',
    'allocation_cost',
    'program_start',
    'stack_base',
    'heap_start',
    'heap_end',
    'reserve',
    'echo',
    'frames_end',
    'marks',
  ]
    .map((name) => ` (global $${name} (mut i32) (i32.const 0))\n (export "${name}" (global $${name}))`)
    .join('\n');
  const added = `\n${imports}\n${counters}\n (global $in_program (mut i32) (i32.const 0))`;
  module.head = module.head.slice(0, end) + added + module.head.slice(end);
  declareVersion(module);
}
