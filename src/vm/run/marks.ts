import type { Firmware } from './firmware';
import type { Memory } from './values';

/**
 * The bytecodes of the program before which a debugger looks: a byte for each address of the program's part of the heap.
 * The interpreter reads it (../firmware/transform.mjs); while it is off, it costs one comparison.
 */
export class Marks {
  private start = 0;

  constructor(
    private readonly firmware: Firmware,
    private readonly memory: Memory,
  ) {}

  /** Marks all bytecodes, or none, and lets the interpreter look. */
  begin(all: boolean): void {
    const { firmware, memory } = this;
    const bytes = firmware.heap_end.value - firmware.program_start.value;
    if (this.start === 0) this.start = firmware.malloc(bytes);
    memory.bytes.fill(Number(all), this.start, this.start + bytes);
    firmware.marks.value = this.start - firmware.program_start.value;
  }

  /** Marks the addresses from the first up to, not including, the last, or takes their marks away; nothing while it is off. */
  set(from: number, to: number, isMarked: boolean): void {
    const shift = this.firmware.marks.value;
    if (shift !== 0) this.memory.bytes.fill(Number(isMarked), shift + from, shift + to);
  }
}
