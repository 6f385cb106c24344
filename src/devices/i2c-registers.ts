/**
 * A register machine: how most I2C chips and robot controllers talk.
 *
 *      write  [register, data, data …]   data for that register and the following ones
 *      write  [register]                 selects it
 *      read   n bytes                    from the selected register on; the selection moves along
 *
 * Register numbers are bytes and wrap from 255 to 0. A register without a part ignores writes and reads as 0.
 */
import type { I2cTarget } from '#board/wires/i2c-bus';

const REGISTER_COUNT = 256;

/** Consecutive registers that belong together. `offset` counts from the first of them. */
export interface RegisterPart {
  readonly first: number;
  readonly count: number;
  readonly read: (offset: number) => number;
  /** Left out: read-only. */
  readonly write?: (offset: number, byte: number) => void;
  /** Called once at the end of each transfer that wrote at least one of them, with those that it wrote. */
  readonly written?: (touched: Touched) => void;
}

/** Registers of a part that a transfer has written: the offsets of the first and the last of them. */
export interface Touched {
  readonly first: number;
  readonly last: number;
}

/** Registers that keep what was written; at the start 0. `written` gets their contents. */
export function memoryRegisters(
  first: number,
  count: number,
  written: (bytes: Readonly<Uint8Array>, touched: Touched) => void = () => undefined,
): RegisterPart {
  const bytes = new Uint8Array(count);
  return {
    first,
    count,
    read: (offset) => bytes[offset] ?? 0,
    write: (offset, byte) => {
      bytes[offset] = byte;
    },
    written: (touched) => written(bytes, touched),
  };
}

/** Read-only registers; `read` is called again for every byte. */
export function liveRegisters(first: number, count: number, read: (offset: number) => number): RegisterPart {
  return { first, count, read };
}

/** An ASCII text, read-only: its length in the first register, its characters in the following ones. */
export function textRegisters(first: number, text: string): RegisterPart {
  return liveRegisters(first, text.length + 1, (offset) => (offset === 0 ? text.length : text.charCodeAt(offset - 1)));
}

/** Makes the device. Where parts overlap, the first one in the list counts. */
export function createRegisterMachine(parts: readonly RegisterPart[]): I2cTarget {
  const partOf = Array.from({ length: REGISTER_COUNT }, (_, register) =>
    parts.find(({ first, count }) => register >= first && register < first + count),
  );
  let selected = 0;
  const next = (): number => (selected + 1) % REGISTER_COUNT;

  /** Calls `written` once for each part in which a transfer has written, from this register on. */
  const tell = (register: number, count: number): void => {
    const touched = new Map<RegisterPart, Touched>();
    for (let i = 0; i < count; i++) {
      const at = (register + i) % REGISTER_COUNT;
      const part = partOf[at];
      if (part?.write) touched.set(part, around(touched.get(part), at - part.first));
    }
    for (const [part, registers] of touched) part.written?.(registers);
  };

  return {
    write: (bytes) => {
      if (bytes.length === 0) return; // an address probe
      const start = bytes[0] ?? 0;
      const whole = partOf[start];
      let isWhole = true;
      selected = start;
      for (let i = 1; i < bytes.length; i++) {
        const part = partOf[selected];
        isWhole &&= part === whole;
        part?.write?.(selected - part.first, bytes[i] ?? 0);
        selected = next();
      }
      const count = bytes.length - 1;
      if (count === 0) return;
      // Nearly every transfer stays within one part, and in simple loops they come by the thousand.
      if (!isWhole || start + count > REGISTER_COUNT) tell(start, count);
      else if (whole?.write) whole.written?.({ first: start - whole.first, last: start - whole.first + count - 1 });
    },
    read: (count) => {
      const answer = new Uint8Array(count);
      for (let i = 0; i < count; i++) {
        const part = partOf[selected];
        answer[i] = part?.read(selected - part.first) ?? 0;
        selected = next();
      }
      return answer;
    },
  };
}

const around = (before: Touched | undefined, offset: number): Touched => ({
  first: Math.min(before?.first ?? offset, offset),
  last: Math.max(before?.last ?? offset, offset),
});
