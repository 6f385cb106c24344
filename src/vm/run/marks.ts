import type { Firmware } from './firmware';
import type { Memory } from './values';

/**
 * The bytecodes of the program before which a debugger looks: a byte for each address of the program's part of the heap.
 * The interpreter reads it (../firmware/transform.mjs); while it is off, it costs one comparison.
 */
export class Marks {
  private readonly start: number;
  private readonly bytes: number;

  /**
   * Takes their memory at once. A later `malloc` would leave remains in the C stack, where the collector takes any word
   * for a pointer, and the program's free memory would depend on whether there has been a watch.
   */
  constructor(
    private readonly firmware: Firmware,
    private readonly memory: Memory,
  ) {
    this.bytes = firmware.heap_end.value - firmware.program_start.value;
    this.start = firmware.malloc(this.bytes);
  }

  /** Marks all bytecodes, or none, and lets the interpreter look. */
  begin(all: boolean): void {
    const { firmware, memory, start } = this;
    memory.bytes.fill(Number(all), start, start + this.bytes);
    firmware.marks.value = this.start - firmware.program_start.value;
  }

  /**
   * Marks the addresses from the first up to, not including, the last, or takes their marks away; nothing of the library,
   * and nothing while it is off.
   */
  set(from: number, to: number, isMarked: boolean): void {
    const { firmware, memory } = this;
    if (firmware.marks.value === 0 || from < firmware.program_start.value) return;
    const shift = this.start - firmware.program_start.value;
    memory.bytes.fill(Number(isMarked), shift + from, Math.min(shift + to, this.start + this.bytes));
  }
}
