import type { Stop } from '#core/stop';
import type { Pin } from './pin';
import type { Wire } from './wire';

/** The wires of an SPI bus. */
export interface SpiWires {
  readonly clock: Wire;
  /** Controller to chip; `null` for a chip that only sends. */
  readonly mosi: Wire | null;
  /** Chip to controller; `null` for a chip that only receives. */
  readonly miso: Wire | null;
}

/** A chip on an SPI bus. It finds out itself from its select wire whether it is selected. */
export interface SpiTarget {
  /**
   * One byte each way at the same time.
   *
   * @param sent the byte that the controller sends
   * @param mode clock polarity and phase, 0 … 3; a chip made for another mode behaves as its datasheet says
   * @returns the byte that the chip sends at the same time, or `null` if it leaves the wire alone (it is not
   *   selected)
   */
  transfer(sent: number, mode: number): number | null;
}

/** The pins that the controller uses. */
export interface SpiPins {
  readonly clock: Pin;
  readonly mosi: Pin;
  readonly miso: Pin;
}

/** Clocks of the controller, fastest first: codal-nrf52 NRF52SPI.cpp, setFrequency (SPIM2). */
const CLOCKS_HZ: readonly number[] = [8_000_000, 4_000_000, 2_000_000, 1_000_000, 500_000, 250_000, 125_000];
const START_HZ = 1_000_000; // NRF52SPI.cpp, constructor
const BITS_PER_BYTE = 8;

/**
 * The microcomputer's SPI controller. It is off until `init`; chips then receive it on its wires.
 *
 * A transfer happens at its end: let `transferUs` pass first, then call `transfer`. Its bits are not seen as levels on
 * the wires (rule Q2).
 */
export class SpiBus {
  private readonly chips = new Set<{ readonly wires: SpiWires; readonly target: SpiTarget }>();
  private pins: SpiPins | null = null;
  private clockHz = START_HZ;
  private currentMode = 0;

  /** True once `init` was called. */
  get isOn(): boolean {
    return this.pins !== null;
  }

  /** The bus clock in Hz. */
  get frequencyHz(): number {
    return this.clockHz;
  }

  /**
   * Switches the bus on, on these pins; they must have been taken for `spi`. The clock is the fastest one that does not
   * exceed the requested one, 125 kHz for less (rule Q3).
   *
   * @param mode clock polarity and phase; its two low bits count
   */
  init(pins: SpiPins, wishHz: number, mode: number): void {
    this.pins = pins;
    this.clockHz = CLOCKS_HZ.find((clockHz) => clockHz <= wishHz) ?? 125_000;
    this.currentMode = mode & 3;
    const idle = this.currentMode <= 1 ? 0 : 1; // NRF52SPI.cpp, config
    pins.clock.holdLevel(idle);
    pins.mosi.holdLevel(0);
    pins.miso.holdInput(idle === 0 ? 'down' : 'up');
  }

  /** Switches off, as after a start; the chips stay. */
  reset(): void {
    this.pins = null;
    this.clockHz = START_HZ;
    this.currentMode = 0;
  }

  /** Connects a chip. */
  attach(wires: SpiWires, target: SpiTarget): Stop {
    const chip = { wires, target };
    this.chips.add(chip);
    return () => {
      this.chips.delete(chip);
    };
  }

  /** Duration of this many bytes, in whole µs, rounded up. */
  transferUs(byteCount: number): number {
    return Math.ceil((byteCount * BITS_PER_BYTE * 1_000_000) / this.clockHz);
  }

  /**
   * Sends bytes and receives as many. If no chip answers, the level of the wire is read for all eight bits. If two
   * answer, a low bit wins (rule Q4).
   *
   * @throws Error while the bus is off: check `isOn` first
   */
  transfer(sent: Uint8Array): Uint8Array {
    const { pins } = this;
    if (!pins) throw new Error('SPI is off: call init first.');
    const listening = [...this.chips].filter(({ wires }) => wires.clock === pins.clock.wire);
    return sent.map((byte) => this.exchange(pins, listening, byte));
  }

  private exchange(
    pins: SpiPins,
    chips: readonly { readonly wires: SpiWires; readonly target: SpiTarget }[],
    byte: number,
  ): number {
    let received: number | null = null;
    for (const { wires, target } of chips) {
      const heard = wires.mosi === pins.mosi.wire ? byte : 0;
      const answer = target.transfer(heard, this.currentMode);
      if (answer !== null && wires.miso === pins.miso.wire) received = (received ?? 0xff) & answer;
    }
    return received ?? (pins.miso.wire.level === 1 ? 0xff : 0);
  }
}
