import { createLoader, type FileLookup, type HostFunctions } from './loader';
import { formatSingle, parseSingle } from './single-float-text';
import type { Value } from './syscall';
import { Memory, VALUE_BYTES } from './values';

type TableFunction = (...args: readonly number[]) => number;

/**
 * The exports of the firmware: MicroPython's own entries and those that the build step added
 * (../firmware/transform.mjs).
 */
export interface Firmware {
  readonly memory: WebAssembly.Memory;
  readonly __indirect_function_table: { get(index: number): TableFunction };
  malloc(bytes: number): number;
  free(address: number): void;
  /** pystack in words, heap in bytes. */
  mp_js_init(pystackWords: number, heapBytes: number): void;
  proxy_c_init(): void;
  mp_js_register_js_module(nameAddress: number, valueAddress: number): void;
  /** Compiles and runs source text; the result or the exception goes to the 12 bytes at `resultAddress`. */
  mp_js_do_exec(sourceAddress: number, bytes: number, resultAddress: number): void;
  mp_sched_keyboard_interrupt(): void;
  /** Queues a function and its argument (object references). Returns 0 if the queue is full. */
  mp_sched_schedule(callable: number, argument: number): number;
  /** 1 = a queued callback can run, 2 = an exception is pending. */
  queued(): number;
  /** Raises the exception object at this address at the program's next jump. */
  set_pending(exception: number): void;
  emscripten_stack_get_current(): number;
  _emscripten_stack_restore(address: number): void;
  setThrew(threw: number, value: number): void;
  __wasm_call_ctors(): void;
  emscripten_stack_init(): void;
  asyncify_start_unwind(buffer: number): void;
  asyncify_stop_unwind(): void;
  asyncify_start_rewind(buffer: number): void;
  asyncify_stop_rewind(): void;
  /** 0 = running, 1 = unwinding (suspending), 2 = rewinding (resuming). */
  asyncify_get_state(): number;
  /** Simulated µs until `tick`, counted down by the pupil's bytecodes and allocations. */
  readonly gas: WebAssembly.Global;
  /** Bytecodes of our library until `tick`. */
  readonly library_gas: WebAssembly.Global;
  /** Cost of one allocation by the pupil's code, in units of `gas`. */
  readonly allocation_cost: WebAssembly.Global;
  /** Address where the library ends and the pupil's part of the heap begins. */
  readonly program_start: WebAssembly.Global;
  /** End of what the library has filled: from then on a collection goes through the program's part alone. */
  readonly library_end: WebAssembly.Global;
  /** Start of the C stack (it grows downwards); the collector scans from the stack pointer to here. */
  readonly stack_base: WebAssembly.Global;
  /** A block of the heap that is freed when memory runs out, for the error itself (heap.ts); 0 once it is used. */
  readonly reserve: WebAssembly.Global;
  /** 1: code that is compiled now prints the values of its expressions, as in the REPL. */
  readonly echo: WebAssembly.Global;
  /** The board's MicroPython, such as 18 for 1.18: numbers, errors and names differ between versions. */
  readonly minor: WebAssembly.Global;
  /** Address of the type of images, which MicroPython 1.18 cannot change in place (../firmware/operators.mjs). */
  readonly image_type: WebAssembly.Global;
  /** Start of the collector's tables; the heap's blocks follow them. */
  readonly heap_start: WebAssembly.Global;
  /** End of the heap. */
  readonly heap_end: WebAssembly.Global;
  /** End of the list of running functions (../debug/inspected.ts); the host sets it to the list's start at first. */
  readonly frames_end: WebAssembly.Global;
  /** Added to a bytecode's address it gives that of its mark (marks.ts); 0: there is no watch. */
  readonly marks: WebAssembly.Global;
  /** Address of the pointer to the last pool of interned names. */
  readonly interned: WebAssembly.Global;
  /** Address of the pointer to the names of the module or class whose body runs. */
  readonly locals_at: WebAssembly.Global;
}

/** The functions that the firmware calls on the run-time side. */
export interface FirmwareHost {
  /** A counter ran out. */
  tick(): void;
  /** A bytecode with a mark is next. */
  look(): void;
  /** The C code is in a state that it cannot leave. Must throw. */
  fatal(): never;
  /** The collector has run. */
  collected(): void;
  /** The compiler has finished the scope_t at this address. */
  scope(address: number): void;
  /** Bytes for the console (stdout and stderr). */
  write(bytes: Uint8Array): void;
  /** A random 32-bit number. */
  randomU32(): number;
  /** Looks a name up in `_hal`: the reference of a function, or −1. */
  lookup(name: string): number;
  readonly call: HostCall;
}

/** Calls a function of `_hal`. Its arguments come one by one, since a list costs more than many a call; none takes more. */
export type HostCall = (
  reference: number,
  resultAddress: number,
  a?: Given,
  b?: Given,
  c?: Given,
  d?: Given,
  e?: Given,
  f?: Given,
  g?: Given,
  h?: Given,
) => void;
export type Given = Value | undefined;

/** The firmware's state that the host tracks itself, without asking for it. */
export interface Flow {
  /** A suspended call is being resumed: the stack is built up again, down to where it was. */
  isRewinding: boolean;
}

/** The reference of the `_hal` object at the boundary; its functions have the references after it. */
export const HAL_REFERENCE = 100;

const ENOSYS = 52; // WASI error numbers, as the C library of the firmware has them
const EROFS = 69;

/** A running copy of the firmware. */
export interface Instantiated {
  readonly firmware: Firmware;
  readonly memory: Memory;
  readonly flow: Flow;
  /** Tells it its host and its files. Call it before anything runs. */
  readonly serve: (host: FirmwareHost, lookup: FileLookup) => void;
  /** Forgets both: they know all of a run. */
  readonly release: () => void;
}

/**
 * Makes a running copy of the firmware. We provide every import ourselves: the published JavaScript glue, its proxies
 * for host objects and its file system are not used, so the host is out of reach and copies share nothing.
 */
export function instantiateFirmware(module: WebAssembly.Module): Instantiated {
  const loaded: { firmware?: Firmware; memory?: Memory; host?: FirmwareHost; lookup?: FileLookup } = {};
  const running = (): Firmware => loaded.firmware ?? notLoaded();
  const inMemory = (): Memory => loaded.memory ?? notLoaded();
  const host = (): FirmwareHost => loaded.host ?? notLoaded();
  const files = createLoader((path) => loaded.lookup?.(path), inMemory);
  const flow: Flow = { isRewinding: false };
  const imports = {
    host: {
      tick: () => host().tick(),
      look: () => host().look(),
      fatal: () => host().fatal(),
      collected: () => host().collected(),
      scope: (address: number) => host().scope(address),
      ...decimals(running, inMemory),
    },
    env: { ...invokers(running, inMemory, flow), ...boundary(inMemory, host), ...files.environment, ...system(host) },
    wasi_snapshot_preview1: { ...files.wasi, ...output(inMemory, host) },
  };
  const firmware = new WebAssembly.Instance(module, imports).exports as unknown as Firmware;
  const memory = new Memory(firmware.memory.buffer, (bytes) => firmware.malloc(bytes));
  Object.assign(loaded, { firmware, memory });
  firmware.emscripten_stack_init();
  firmware.__wasm_call_ctors();
  const serve = (given: FirmwareHost, lookup: FileLookup): void => {
    Object.assign(loaded, { host: given, lookup });
  };
  const release = (): void => {
    files.closeAll();
    delete loaded.host;
    delete loaded.lookup;
  };
  return { firmware, memory, flow, serve, release };
}

/** Decimal numbers as the board writes and reads them; the build step puts these in place of the published ones. */
const decimals = (running: () => Firmware, memory: () => Memory): HostFunctions => {
  const minor = (): number => running().minor.value;
  return {
    format_single: (value: number, at: number, letter: number, precision: number, sign: number) =>
      memory().putAscii(at, formatSingle(minor(), value, letter, precision, sign)),
    parse_single: (at: number, length: number) => parseSingle(minor(), memory().text(at, length)),
  };
};

function notLoaded(): never {
  throw new Error('The firmware is not loaded yet.');
}

/**
 * Calls through the function table that catch what C's longjmp throws (any number; ours and the engine's errors are
 * objects and pass). When a suspended call is resumed, the stack pointer is already at the deep place. So the one saved
 * on entry is kept per nesting depth; otherwise each exception caught after a suspension would leak C stack.
 */
function invokers(running: () => Firmware, memory: () => Memory, flow: Flow): HostFunctions {
  const stackAt: number[] = [];
  const functions: TableFunction[] = []; // asking the table each time takes 3 % of a run
  let depth = 0;
  const enter = (index: number): TableFunction => {
    const firmware = running();
    if (!flow.isRewinding) stackAt[depth] = firmware.emscripten_stack_get_current();
    depth++;
    return (functions[index] ??= firmware.__indirect_function_table.get(index));
  };
  const caught = (thrown: unknown, level: number): number => {
    // Remains of frames in the C stack would keep dead objects alive: later frames cover them without filling them, and
    // the collector takes any word there for a pointer.
    memory().bytes.fill(0, running().emscripten_stack_get_current(), stackAt[level]);
    running()._emscripten_stack_restore(stackAt[level] ?? 0);
    if (typeof thrown !== 'number') throw thrown;
    running().setThrew(1, 0);
    return 0;
  };
  // Five arguments for all functions. A function ignores those it does not take, and no array is built.
  const invoke = (index: number, a: number, b: number, c: number, d: number, e: number): number => {
    const level = depth;
    try {
      return enter(index)(a, b, c, d, e);
    } catch (thrown) {
      return caught(thrown, level);
    } finally {
      depth = level;
    }
  };
  const names = ['v', 'vi', 'vii', 'viii', 'viiii', 'i', 'ii', 'iii', 'iiii', 'iiiii', 'iiiiii'];
  const throwNumber = (): never => {
    // eslint-disable-next-line @typescript-eslint/only-throw-error -- the contract of the C library: a number, not an error
    throw Infinity;
  };
  return {
    ...Object.fromEntries(names.map((name) => [`invoke_${name}`, invoke])),
    _emscripten_throw_longjmp: throwNumber,
  };
}

/** The place where Python meets the host: one object, `_hal`, whose attributes are functions. Everything else is refused. */
function boundary(memory: () => Memory, host: () => FirmwareHost): HostFunctions {
  const nothing = (): number => 0;
  const refuse = (): never => host().fatal();
  const find = (reference: number, nameAddress: number): number =>
    reference === HAL_REFERENCE ? host().lookup(memory().textUntilZero(nameAddress)) : -1;
  const refused = [
    'call0_kwarg calln_kwarg js_reflect_construct js_get_iter js_iter_next js_subscr_load js_subscr_store create_promise',
    'js_then_resolve js_then_reject js_then_continue proxy_convert_mp_to_js_then_js_to_mp_obj_jsside',
    'proxy_convert_mp_to_js_then_js_to_js_then_js_to_mp_obj_jsside js_get_error_info',
  ];
  return {
    ...Object.fromEntries(refused.flatMap((line) => line.split(' ')).map((each) => [each, refuse])),
    call0: (reference: number, out: number) => host().call(reference, out),
    call1: (reference: number, _via: number, a: number, out: number) => host().call(reference, out, memory().read(a)),
    call2: (reference: number, _via: number, a: number, b: number, out: number) =>
      host().call(reference, out, memory().read(a), memory().read(b)),
    calln: (reference: number, _via: number, count: number, first: number, out: number) => {
      const given = (place: number): Given => (place < count ? memory().read(first + place * VALUE_BYTES) : undefined);
      host().call(reference, out, given(0), given(1), given(2), given(3), given(4), given(5), given(6), given(7));
    },
    has_attr: (reference: number, nameAddress: number) => Number(find(reference, nameAddress) >= 0),
    lookup_attr: (reference: number, nameAddress: number, out: number) => {
      const found = find(reference, nameAddress);
      if (found < 0) return 0;
      memory().writeReference(found, out);
      return 1;
    },
    store_attr: nothing,
    proxy_js_free_obj: nothing,
    js_check_existing: () => -1,
    js_get_proxy_js_ref_info: nothing,
  };
}

/** Time and random numbers of the C code. Its own clock is never read: the library replaces every access to it. */
function system(host: () => FirmwareHost): HostFunctions {
  return {
    mp_js_random_u32: () => host().randomU32() | 0,
    mp_js_ticks_ms: () => 0,
    mp_js_time_ms: () => 0,
    _abort_js: () => host().fatal(),
    emscripten_resize_heap: () => 0,
    ...Object.fromEntries(
      ['chdir', 'mkdirat', 'poll', 'renameat', 'rmdir', 'unlinkat'].map((call) => [`__syscall_${call}`, () => -EROFS]),
    ),
    __syscall_getdents64: () => -ENOSYS,
    __syscall_statfs64: () => -ENOSYS,
  };
}

/** Output of the C code. */
function output(memory: () => Memory, host: () => FirmwareHost): HostFunctions {
  const write = (_file: number, vectors: number, count: number, written: number): number => {
    let total = 0;
    for (let i = 0; i < count; i++) {
      const address = memory().word(vectors + 8 * i);
      const length = memory().word(vectors + 8 * i + 4);
      if (length) host().write(memory().bytes.subarray(address, address + length));
      total += length;
    }
    memory().setWord(written, total);
    return 0;
  };
  return { fd_write: write, fd_sync: () => 0 };
}
