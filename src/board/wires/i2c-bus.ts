import type { Stop } from '#core/stop';
import type { Wire } from './wire';

/** A chip on the bus. It acknowledges every byte; a chip that must not answer is detached. */
export interface I2cTarget {
  /**
   * Receives the bytes after the address of one write transfer; may be empty (an address probe). They may be a view
   * of other memory: copy them to store them.
   */
  write(bytes: Uint8Array): void;
  /** Gives the bytes of one read transfer: exactly `count`, missing ones are read as 0xFF (the released bus). */
  read(count: number): Uint8Array;
}

/** The wires of a bus. */
export interface I2cWires {
  readonly scl: Wire;
  readonly sda: Wire;
}

/** The result of a transfer. */
export interface I2cTransfer {
  /** False if no chip has the address: the controller sees no acknowledge (rule I1). */
  readonly acknowledged: boolean;
  /** Time for which the bus was busy, in whole µs; equals `writeUs` or `readUs`. */
  readonly durationUs: number;
  /** The bytes read, valid until the next transfer; empty for a write. */
  readonly bytes: Uint8Array;
}

/** The controller's overhead besides the bits on the bus, in µs. */
export interface I2cOverhead {
  /** After every transfer. */
  readonly gapUs: number;
  /** A write of no bytes that is acknowledged: the controller waits for a byte that never arrives. */
  readonly probeUs: number;
}

const BITS_PER_BYTE = 9; // eight data bits and the acknowledge, NXP UM10204 §3.1.5
const MAX_ADDRESS = 0x7f;
/** Bus clocks of the controller, fastest first: nRF52833 product specification, TWIM FREQUENCY. */
const CLOCKS_HZ: readonly number[] = [400_000, 250_000, 100_000];
const NOTHING = new Uint8Array(0);

/**
 * The microcomputer's I2C bus, the controller's side. 7-bit addresses.
 *
 * A transfer happens at its end: let `transferUs` pass first, then call `write` or `read` (rule I4).
 */
export class I2cBus {
  private readonly chips: { readonly address: number; readonly target: I2cTarget; readonly wires: I2cWires | null }[] =
    [];
  /** The wires in use; `null` for those after a start. */
  private wires: I2cWires | null = null;

  private clockHz: number;

  /** @param startHz bus clock after a start, in Hz */
  constructor(
    private readonly startHz = 100_000,
    private readonly overhead: I2cOverhead = { gapUs: 0, probeUs: 0 },
  ) {
    this.clockHz = startHz;
  }

  /** The bus clock in Hz. */
  get frequencyHz(): number {
    return this.clockHz;
  }

  /** Resets clock and wires to those after a start; the chips stay. */
  reset(): void {
    this.clockHz = this.startHz;
    this.wires = null;
  }

  /** Moves the bus to other wires; only the chips there receive it (rule I8). `null`: the wires after a start. */
  useWires(wires: I2cWires | null): void {
    this.wires = wires;
  }

  /** Chooses the fastest clock of 100, 250 and 400 kHz up to the requested one; 100 kHz for less (rule I5). */
  setFrequency(wishHz: number): void {
    this.clockHz = CLOCKS_HZ.find((clockHz) => clockHz <= wishHz) ?? 100_000;
  }

  /**
   * Puts a chip on the bus.
   *
   * @param wires where it is; left out: the wires that the bus uses after a start
   * @throws RangeError if the address is taken there or not 0 … 127
   */
  attach(address: number, target: I2cTarget, wires: I2cWires | null = null): Stop {
    if (!(Number.isInteger(address) && address >= 0 && address <= MAX_ADDRESS)) {
      throw new RangeError(`I2C address ${address} is not within 0 … 127.`);
    }
    if (this.chips.some((chip) => chip.address === address && areSame(chip.wires, wires))) {
      throw new RangeError(`I2C address ${address} is taken.`);
    }
    const chip = { address, target, wires };
    this.chips.push(chip);
    return () => {
      const place = this.chips.indexOf(chip);
      if (place >= 0) this.chips.splice(place, 1);
    };
  }

  /** True if a chip has the address. */
  answers(address: number): boolean {
    return this.find(address) !== undefined;
  }

  /** Time for which a transfer of the address byte and `byteCount` data bytes occupies the bus, in µs, rounded up. */
  transferUs(byteCount: number): number {
    return Math.ceil(((byteCount + 1) * BITS_PER_BYTE * 1_000_000) / this.frequencyHz) + this.overhead.gapUs;
  }

  /** Duration of a write, in µs: the address alone if no chip answers, the probe time if it is empty. */
  writeUs(address: number, byteCount: number): number {
    return this.timeOfWrite(this.find(address), byteCount);
  }

  private timeOfWrite(target: I2cTarget | undefined, byteCount: number): number {
    if (!target) return this.transferUs(0);
    return byteCount > 0 ? this.transferUs(byteCount) : Math.max(this.transferUs(0), this.overhead.probeUs);
  }

  /** Duration of a read, in µs. */
  readUs(address: number, byteCount: number): number {
    return this.transferUs(this.answers(address) ? byteCount : 0);
  }

  /** Writes bytes to a chip. */
  write(address: number, bytes: Uint8Array): I2cTransfer {
    const target = this.find(address);
    const durationUs = this.timeOfWrite(target, bytes.length);
    target?.write(bytes);
    return { acknowledged: target !== undefined, durationUs, bytes: NOTHING };
  }

  /** Reads bytes from a chip. */
  read(address: number, count: number): I2cTransfer {
    const durationUs = this.readUs(address, count);
    const target = this.find(address);
    if (!target) return { acknowledged: false, durationUs, bytes: NOTHING };
    return { acknowledged: true, durationUs, bytes: exactly(count, target.read(count)) };
  }

  private find(address: number): I2cTarget | undefined {
    for (const chip of this.chips) if (chip.address === address && areSame(chip.wires, this.wires)) return chip.target;
    return undefined;
  }
}

/** The first bytes; missing ones are those of the released bus. */
function exactly(count: number, given: Uint8Array): Uint8Array {
  if (given.length === count) return given;
  const bytes = new Uint8Array(count).fill(0xff);
  bytes.set(given.subarray(0, count));
  return bytes;
}

function areSame(a: I2cWires | null, b: I2cWires | null): boolean {
  return a?.scl === b?.scl && a?.sda === b?.sda;
}
