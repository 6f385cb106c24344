import type { Stop } from '#core/stop';
import type { Pin } from './pin';
import type { Wire } from './wire';

/** The wires of an SPI bus. */
export interface SpiWires {
  readonly clock: Wire;
  /** Controller to chip; `null` for a chip that only talks. */
  readonly mosi: Wire | null;
  /** Chip to controller; `null` for a chip that only listens. */
  readonly miso: Wire | null;
}

/** A chip on an SPI bus. Whether it is selected it finds out itself, from its select wire. */
export interface SpiTarget {
  /**
   * One byte each way at the same time.
   *
   * @param sent what the controller sends
   * @param mode clock polarity and phase, 0 … 3; a chip that knows another one does as its datasheet says
   * @returns what the chip sends meanwhile, or `null` when it leaves the wire alone (it is not selected)
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
 * The microcomputer's SPI controller. It is off until `init`; chips hear it on the wires that it uses then.
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
   * Switches the bus on, on these pins; they have to be taken for `spi` before. The clock is the fastest one that does
   * not exceed the wish, 125 kHz for less (rule Q3).
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

  /** Off, as after a start; the chips stay. */
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

  /** How long so many bytes take, in whole µs, rounded up. */
  transferUs(byteCount: number): number {
    return Math.ceil((byteCount * BITS_PER_BYTE * 1_000_000) / this.clockHz);
  }

  /**
   * Sends bytes and receives as many. Where no chip answers, the level of the wire is read for all eight bits; where
   * two answer, a low bit wins (rule Q4).
   *
   * @throws Error while the bus is off: ask `isOn` first
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
