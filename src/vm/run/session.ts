import { createRng } from '#core/rng';
import type { ConsolePort } from './console-port';
import { Engine, VmFault } from './engine';
import type { Files } from './files';
import { HAL_REFERENCE, instantiateFirmware, type Firmware, type FirmwareHost } from './firmware';
import { createHal } from './hal';
import { deviceLibrary } from './library';
import { createLoader, type FileLookup } from './loader';
import type { Report } from './report';
import type { SyscallTable } from './syscall';
import { VALUE_BYTES, type Memory } from './values';
import type { VmSetup } from './vm-setup';

/** What outlives a reset of the board. */
export interface SessionPorts {
  readonly files: Files;
  readonly port: ConsolePort;
  readonly report: Report;
}

/**
 * The device's heap: 64 KiB, of which 64512 bytes are blocks (py/gc.c) and some hundred are taken before the program
 * begins. Chosen so that the program measured in micropython-microbit-v2 issue #146 starts with the same 63984 bytes.
 */
const PROGRAM_HEAP_BYTES = 4022 * 16;
/** Library and program together. What the library leaves free is filled, so that the program's part is always the same. */
const HEAP_BYTES = 144 * 1024;
/** Room for the frames of running Python functions, in words: enough that the limit of the C stack decides. */
const PYSTACK_WORDS = 16 * 1024;
/** The C stack. Larger than MicroPython is allowed to use (../firmware/transform.mjs), for what it calls at the limit. */
const STACK_BYTES = 256 * 1024;

const BOOT = "import sys\nsys.path[:]=['/lib']\ndel sys\n__import__('_boot')";
const PROGRAM = "__import__('_boot').run()";

/** MicroPython from power-up to the end of its program or the next reset. */
export class Session {
  private readonly firmware: Firmware;
  private readonly memory: Memory;
  private readonly engine: Engine;
  private readonly program: () => void;
  private wantsReset = false;

  constructor(
    setup: VmSetup,
    private readonly ports: SessionPorts,
  ) {
    const rng = createRng(setup.seed).fork('vm');
    const byteUs = setup.board.type.costsUs.printByteUs;
    let engine: Engine | undefined;
    const host: FirmwareHost = {
      tick: () => engine?.tick(),
      fatal: () => {
        throw new VmFault('MicroPython cannot go on: its memory or its stack is used up.');
      },
      write: (bytes) => {
        ports.report.write(bytes);
        engine?.print(bytes.length * byteUs);
      },
      randomU32: () => rng.u32(),
      lookup: (name) => engine?.lookup(name) ?? -1,
      call: (reference, args, result) => engine?.call(reference, args, result),
    };
    const { firmware, memory } = instantiateFirmware(
      setup.firmware,
      host,
      createLoader(lookupIn(ports.files, setup.libraries)),
    );
    this.firmware = firmware;
    this.memory = memory;
    this.engine = engine = new Engine(firmware, memory, setup.clock, (machine) => ({
      ...createHal(machine, setup.board, ports.files, ports.port, rng),
      ...ports.report.syscalls(() => machine.end()),
      ...this.ownSyscalls(machine),
    }));
    this.boot(setup.board.type.costsUs.allocationUs);
    this.program = this.executor(PROGRAM);
  }

  /** Runs until the clock reaches the limit, the program ends or the board resets. The report tells how it ended. */
  run(limitUs: number): 'suspended' | 'ended' | 'reset' {
    try {
      if (!this.engine.run(this.program, limitUs)) return 'suspended';
    } catch (fault) {
      this.ports.report.fault(fault);
      return 'ended';
    }
    if (this.wantsReset) return 'reset';
    this.ports.report.finish();
    return 'ended';
  }

  /** KeyboardInterrupt at the program's next jump. */
  interrupt(): void {
    this.engine.interrupt();
  }

  /** Free bytes of the program's part of the heap, counted in the collector's table: nothing runs for it. */
  get heapFree(): number {
    const { heap_start: start, heap_end: end, program_start: program } = this.firmware;
    return freeBytes(this.memory.bytes, { start: start.value, program: program.value, end: end.value });
  }

  private ownSyscalls(engine: Engine): SyscallTable {
    const address = (value: unknown): number => (typeof value === 'number' ? value : 0);
    return {
      program_start: () => this.firmware.program_start.value,
      reserve: (block) => {
        this.firmware.reserve.value = address(block);
        return null;
      },
      on_callback: (dispatcher) => {
        engine.setDispatcher(address(dispatcher));
        return null;
      },
      throw: (exception) => {
        engine.throwInProgram(address(exception));
        return null;
      },
      panic: () => {
        this.ports.report.panic();
        engine.end();
        return null;
      },
      reset: () => {
        this.wantsReset = true;
        engine.end();
        return null;
      },
    };
  }

  /** Starts MicroPython, loads the library, and gives the program its part of the heap. */
  private boot(allocationUs: number): void {
    const { firmware, memory } = this;
    const stack = firmware.malloc(STACK_BYTES);
    firmware._emscripten_stack_restore(stack + STACK_BYTES);
    firmware.stack_base.value = stack + STACK_BYTES;
    firmware.mp_js_init(PYSTACK_WORDS, HEAP_BYTES);
    firmware.proxy_c_init();
    const name = memory.allocateText('_hal').address;
    const value = firmware.malloc(VALUE_BYTES);
    memory.writeReference(HAL_REFERENCE, value);
    firmware.mp_js_register_js_module(name, value);
    firmware.allocation_cost.value = allocationUs;
    firmware.program_start.value = firmware.heap_end.value - PROGRAM_HEAP_BYTES;
    firmware.library_gas.value = 0x7fffffff; // loading the library costs nothing
    if (!this.engine.run(this.executor(BOOT), Infinity)) throw new VmFault('The library did not load.');
  }

  /** A call that compiles and runs a text of our own; an exception that leaves it is our bug. */
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

/**
 * What `gc.mem_free()` would give for the program's part. The heap opens with a table of two bits for each block of 16
 * bytes, 0 = free; with the finaliser table of half its size and the blocks, one byte of the table stands for 65.5
 * bytes of heap (py/gc.c).
 */
function freeBytes(
  memory: Uint8Array,
  heap: { readonly start: number; readonly program: number; readonly end: number },
): number {
  const tableBytes = Math.floor(((heap.end - heap.start - 1) * 2) / 131);
  const firstBlock = (heap.program - (heap.end - tableBytes * 64)) / 16;
  let free = 0;
  for (let block = firstBlock; block < tableBytes * 4; block++) {
    const state = ((memory[heap.start + (block >> 2)] ?? 0) >> (2 * (block & 3))) & 3;
    if (state === 0) free++;
  }
  return free * 16;
}

/** What is on the board wins over the robot's libraries; the device's own modules lie in a folder of their own. */
function lookupIn(files: Files, libraries: Readonly<Record<string, string>>): FileLookup {
  const encoder = new TextEncoder();
  const sources = new Map(Object.entries(libraries).map(([name, text]) => [name, encoder.encode(text)]));
  return (path) => {
    if (path.startsWith('/lib/')) return deviceLibrary.get(path.slice('/lib/'.length));
    return files.find(path)?.bytes ?? sources.get(path);
  };
}
