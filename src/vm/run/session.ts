import { createRng, type Rng } from '#core/rng';
import type { Inspected } from '../debug/inspected';
import { Scopes } from '../debug/scopes';
import { wholeOf } from './arguments';
import type { ConsolePort } from './console-port';
import { Engine, VmFault, type Hold } from './engine';
import { readableBytes, type Files } from './files';
import { HAL_REFERENCE, type Firmware, type FirmwareHost, type Instantiated } from './firmware';
import { createHal } from './hal/hal';
import { createHeapCalls } from './hal/heap';
import { deviceLibrary } from './library';
import { giveBack, lendFirmware } from './lent-firmware';
import { findCopy, keepCopy } from './library-copy';
import type { FileLookup } from './loader';
import { Heap } from './heap';
import { createReplCalls } from './hal/repl';
import { observed } from './observed';
import { Marks } from './marks';
import type { Repl } from './repl';
import type { Report } from './report';
import { showError, showPanic, type Shown } from './show-error';
import type { SyscallTable, Value, Wait } from './syscall';
import { VALUE_BYTES, type Memory } from './values';
import { applyChange, stateOf } from './vm-state';
import type { VmSetup } from './vm-setup';

/** The state that survives a reset of the board. */
export interface SessionPorts {
  readonly files: Files;
  readonly port: ConsolePort;
  readonly report: Report;
  readonly repl: Repl;
  readonly hold: Hold;
  /** When the board was last switched on or reset. */
  readonly startUs: number;
}

/**
 * Library (78 kB, measured when everything was in it), reserve and program together, with room for a library that grows
 * by a quarter: heap.ts fills the rest, so that the program's part is always the same.
 */
const HEAP_BYTES = 192 * 1024;
/** Room for the frames of running Python functions, in words: large enough that the C stack sets the limit. */
const PYSTACK_WORDS = 16 * 1024;
/** The C stack. Larger than MicroPython may use (../firmware/transform.mjs), for the calls it makes at the limit. */
const STACK_BYTES = 256 * 1024;

const BOOT = "import sys\nsys.path[:]=['/lib']\ndel sys\n_run=__import__('_boot').run";
const PROGRAM = '_run()';

/** MicroPython from power-up to the next reset: its program, then the REPL. */
export class Session {
  private readonly lent: Instantiated;
  private readonly firmware: Firmware;
  private readonly memory: Memory;
  private readonly engine: Engine;
  private readonly heap: Heap;
  private readonly scopes: Scopes;
  /** The state that a debugger may read. */
  readonly inspected: Inspected;
  private readonly program: () => void;
  private restartsAs: 'reset' | 'reboot' | null = null;
  private isGivenBack = false;

  constructor(
    private readonly setup: VmSetup,
    private readonly ports: SessionPorts,
  ) {
    const rng = createRng(setup.seed).fork('vm');
    this.lent = lendFirmware(setup.firmware);
    const { firmware, memory, flow, serve } = this.lent;
    this.firmware = firmware;
    this.memory = memory;
    this.heap = new Heap(firmware, memory);
    this.scopes = new Scopes(memory);
    const running = { firmware, memory, flow, hold: ports.hold };
    this.engine = new Engine(running, setup.clock, ports.startUs, (machine) => this.calls(machine, rng));
    serve(this.host(rng), lookupIn(ports.files, setup.libraries));
    ports.port.onInterrupt = () => this.engine.interrupt();
    this.startFirmware();
    this.inspected = this.inspect();
    this.loadLibrary();
    this.program = this.executor(PROGRAM);
  }

  /** The functions that the firmware calls. */
  private host(rng: Rng): FirmwareHost {
    const { engine, heap, scopes } = this;
    return {
      tick: () => engine.tick(),
      look: () => engine.look(),
      fatal: () => {
        throw new VmFault('MicroPython cannot go on: its memory or its stack is used up.');
      },
      collected: () => heap.collected(),
      scope: (address) => scopes.add(address),
      write: (bytes) => {
        this.print(bytes);
        engine.print(bytes.length * this.printByteUs);
        this.setup.observer?.print(bytes); // now the clock shows the program's time
      },
      randomU32: () => rng.u32(),
      lookup: (name) => engine.lookup(name),
      call: (reference, result, a, b, c, d, e, f, g, h) => engine.call(reference, result, a, b, c, d, e, f, g, h),
    };
  }

  /** Runs until the clock reaches the limit, the program ends or the board restarts. The report tells how it ended. */
  run(limitUs: number): 'suspended' | 'ended' | 'reset' | 'reboot' {
    if (this.isGivenBack) return 'ended';
    try {
      if (!this.engine.run(this.program, limitUs)) return 'suspended';
    } catch (fault) {
      this.ports.report.fault(fault);
      return 'ended';
    }
    return this.restartsAs ?? 'ended';
  }

  /** Raises KeyboardInterrupt at the program's next jump. */
  interrupt(): void {
    if (!this.isGivenBack) this.engine.interrupt();
  }

  /** When the board was last switched on or reset. */
  get startUs(): number {
    return this.ports.startUs;
  }

  /** Releases everything that would reach into this MicroPython later, and its memory. Nothing of it runs any more. */
  dispose(): void {
    if (this.isGivenBack) return;
    this.isGivenBack = true;
    this.engine.dispose();
    this.ports.port.onInterrupt = () => undefined;
    if (!this.engine.isRunning) giveBack(this.setup.firmware, this.lent);
  }

  /** Free bytes of the program's part of the heap, counted in the collector's table without running anything. */
  get heapFree(): number {
    return this.heap.freeBytes;
  }

  /** Time of a byte on the serial line, in µs: at the speed that the program has set, else at the REPL's. */
  private get printByteUs(): number {
    return this.setup.board.uart.byteUs;
  }

  /** Python's output goes where the serial line goes; a report on the program's end always goes to the console. */
  private print(bytes: Uint8Array): void {
    const { uart } = this.setup.board;
    if (uart.pins.tx && !this.ports.report.isReporting) uart.send(bytes.slice());
    else this.ports.report.print(bytes, this.ports.report.ended !== null && !this.ports.repl.isAsleep);
  }

  private calls(engine: Engine, rng: Rng): SyscallTable {
    const { files, port, report, repl } = this.ports;
    const runner: SyscallTable = {
      ...report.syscalls(),
      ...createReplCalls(repl, port, engine),
      ...this.runnerCalls(engine),
      booted: () => {
        engine.hide(Object.keys(runner));
        return null;
      },
    };
    const table: SyscallTable = {
      ...createHal(engine, this.setup.board, files, port, rng),
      ...createHeapCalls(this.heap),
      ...this.programCalls(engine),
      names: () => Object.keys(table).join(' '),
    };
    const all = { ...table, ...runner };
    return this.setup.observer ? observed(all, this.setup.observer) : all;
  }

  /**
   * For the library's runner alone. Like the report's and the REPL's they are hidden from Python when it calls booted().
   *
   * - seal() · reserve_bytes() → size, reserve(address of a block), reserve_give(), reserve_hold(): see heap.ts
   * - image_type(address of the type of images): see ../firmware/operators.mjs
   * - on_callback(address of the dispatcher) · throw(address of an exception) → whether it is one
   * - finish(): the program has ended · shown() waits for the error on the display → True when over · shown_skip()
   * - reboot(): main.py starts again
   */
  private runnerCalls(engine: Engine): SyscallTable {
    const { heap, setup } = this;
    const { report, repl } = this.ports;
    const address = (value: unknown): number => (typeof value === 'number' ? value : 0);
    let shown: Shown | null = null;
    const isShown = (): boolean => shown?.isOver() ?? true;
    const does = (action: (value: Value | undefined) => void) => (value?: Value) => {
      action(value);
      return null;
    };
    return {
      seal: does(() => heap.seal()),
      reserve_bytes: () => heap.reserveBytes,
      reserve: does((block) => heap.setReserve(address(block))),
      reserve_give: does(() => heap.giveReserve()),
      reserve_hold: does(() => heap.hold()),
      image_type: does((type) => {
        this.firmware.image_type.value = address(type);
      }),
      on_callback: does((dispatcher) => engine.setDispatcher(address(dispatcher))),
      throw: (exception) => {
        const isException = heap.isObject(address(exception));
        if (isException) engine.throwInProgram(address(exception));
        return isException;
      },
      finish: (): Wait => {
        report.finish();
        repl.programEnded();
        const { ended } = report;
        if (ended?.kind === 'exception' && ended.exception) shown = showError(setup.board, ended.exception);
        engine.pause();
        return { untilUs: setup.clock.nowUs, solid: true, result: () => null };
      },
      shown: (): Wait => ({ untilUs: isShown() ? setup.clock.nowUs : Infinity, ready: isShown, result: isShown }),
      shown_skip: does(() => shown?.skip()),
      reboot: does(() => {
        this.restartsAs = 'reboot';
        engine.end();
      }),
    };
  }

  /** The calls of a program to the machine: panic(number), reset(), kbd_intr(byte, −1 for none). */
  private programCalls(engine: Engine): SyscallTable {
    const { report, port } = this.ports;
    return {
      panic: (code) => {
        report.panic();
        showPanic(this.setup.board, wholeOf(code) ?? 0);
        engine.end();
        return null;
      },
      reset: () => {
        this.restartsAs = 'reset';
        engine.end();
        return null;
      },
      kbd_intr: (byte) => {
        const code = wholeOf(byte) ?? -1;
        port.interruptByte = code < 0 ? null : code & 0xff;
        return null;
      },
    };
  }

  /** Starts MicroPython with a C stack and a heap. */
  private startFirmware(): void {
    const { firmware, memory } = this;
    const stack = firmware.malloc(STACK_BYTES);
    const base = stack + STACK_BYTES;
    // The last words do not belong to a frame: the heap holds its reserve by one of them.
    firmware._emscripten_stack_restore(base - STACK_ALIGNMENT);
    memory.bytes.fill(0, base - STACK_ALIGNMENT, base);
    firmware.stack_base.value = base;
    // The C stack never comes down here (STACK_BYTES), so there is room for the list of running functions.
    firmware.frames_end.value = stack;
    firmware.mp_js_init(PYSTACK_WORDS, HEAP_BYTES);
    firmware.proxy_c_init();
    const name = memory.allocateText('_host').address;
    const value = firmware.malloc(VALUE_BYTES);
    memory.writeReference(HAL_REFERENCE, value);
    firmware.mp_js_register_js_module(name, value);
    this.heap.divide();
  }

  /** Call it while nothing runs. */
  private inspect(): Inspected {
    const { firmware, memory, scopes, heap } = this;
    return {
      memory,
      minor: firmware.minor.value,
      framesStart: firmware.frames_end.value,
      framesEnd: () => firmware.frames_end.value,
      interned: firmware.interned.value,
      localsAt: firmware.locals_at.value,
      heapStart: firmware.heap_start.value,
      programStart: firmware.program_start.value,
      scopeOf: (code) => scopes.of(code),
      scopes,
      sizeOf: (address) => heap.sizeOf(address),
      marks: new Marks(firmware, memory),
      isOwnFile: (name) => this.ports.files.find(name) !== undefined,
    };
  }

  /**
   * Loads the library, which takes no simulated time. The state of the VM after that is saved: the next one for such a
   * board gets a copy. With an observer or a watch there is no copy: they see the library load.
   */
  private loadLibrary(): void {
    this.firmware.allocation_cost.value = this.setup.board.type.costsUs.allocationUs;
    this.firmware.library_gas.value = 0x7fffffff;
    [, this.firmware.minor.value] = this.setup.board.firmware.micropython;
    if (this.setup.observer !== undefined || this.ports.hold.watch !== null) return this.boot();
    const { firmware, memory, engine, scopes } = this;
    const wanted = { module: this.setup.firmware, board: this.setup.board, fileNames: this.ports.files.names };
    const copy = findCopy(wanted);
    if (copy === null) {
      const before = stateOf(firmware, memory);
      this.boot();
      return keepCopy(wanted, before, this.firmware, memory, { agreed: engine.agreed, scopes: scopes.all });
    }
    applyChange(copy.change, firmware, memory);
    engine.agreed = copy.agreed;
    scopes.know(copy.scopes);
  }

  private boot(): void {
    if (!this.engine.run(this.executor(BOOT), Infinity)) throw new VmFault('The library did not load.');
  }

  /** Compiles and runs a text of our own; an exception that leaves it is our bug. */
  private executor(source: string): () => void {
    const { firmware, memory } = this;
    const text = memory.allocateText(source);
    const result = firmware.malloc(VALUE_BYTES);
    return () => {
      firmware.mp_js_do_exec(text.address, text.length, result);
      if (firmware.asyncify_get_state() !== 0 || memory.word(result) !== EXCEPTION) return;
      throw new VmFault(memory.text(memory.word(result + 8), memory.word(result + 4)));
    };
  }
}

/** The kind of a result that is an exception: ports/webassembly/proxy_c.c. */
const EXCEPTION = -1;
/** Alignment of the C stack: WebAssembly tool conventions, basic C ABI. */
const STACK_ALIGNMENT = 16;

/** Files on the board win over the robot's libraries; the device's own modules lie in a folder of their own. */
function lookupIn(files: Files, libraries: Readonly<Record<string, string>>): FileLookup {
  const encoder = new TextEncoder();
  const sources = new Map(Object.entries(libraries).map(([name, text]) => [name, encoder.encode(text)]));
  return (path) => {
    if (path.startsWith('/lib/')) return deviceLibrary.get(path.slice('/lib/'.length));
    // The board's firmware loads no bytecode from files (MICROPY_PERSISTENT_CODE_LOAD is off).
    if (path.endsWith('.mpy')) return undefined;
    const file = files.find(path);
    return file ? readableBytes(file) : sources.get(path);
  };
}
