import type { Pwm } from './wire';

/** A pin, as the PWM unit sees it. */
export interface PwmOutput {
  /** Outputs this signal from now on. A duty of 0 is a steady low. */
  show(pwm: Pwm): void;
}

/**
 * The one PWM peripheral behind `write_analog`: four channels that share one period.
 * Source: codal-nrf52 NRF52Pin.cpp (setAnalogValue, setAnalogPeriodUs) and NRF52PWM.cpp (setPeriodUs).
 */
export class PwmUnit {
  private readonly channels: ({ readonly output: PwmOutput; value: number } | null)[] = [null, null, null, null];
  private lastGiven = this.channels.length - 1;
  private prescaler = 0;
  private countTop = 0;

  constructor() {
    this.setPeriodUs(DEFAULT_PERIOD_US);
  }

  /** Frees all channels and resets the period. The pins must have been reset before. */
  reset(): void {
    this.channels.fill(null);
    this.lastGiven = this.channels.length - 1;
    this.setPeriodUs(DEFAULT_PERIOD_US);
  }

  /** The period of all channels in µs: the nearest possible value at or below the requested one. */
  get periodUs(): number {
    return (this.countTop << this.prescaler) / TICKS_PER_US;
  }

  /**
   * Changes the period of every channel; their duties stay the same (rule P2).
   *
   * @param periodUs 1 … 262143 µs
   * @returns false, with nothing changed, if the hardware cannot do it
   */
  setPeriodUs(periodUs: number): boolean {
    const ticks = Math.trunc(periodUs) * TICKS_PER_US;
    if (!(ticks >= TICKS_PER_US && ticks < COUNT_LIMIT << MAX_PRESCALER)) return false;
    this.prescaler = 0;
    while (ticks >> this.prescaler >= COUNT_LIMIT) this.prescaler++;
    this.countTop = ticks >> this.prescaler;
    for (const channel of this.channels) channel?.output.show(this.signal(channel.value));
    return true;
  }

  /**
   * Puts a value on an output. The first four outputs get a channel each; every further one takes the channel that
   * was assigned longest ago, and the output that had it becomes low (rule P4).
   *
   * @param value 0 … 1023
   */
  write(output: PwmOutput, value: number): void {
    const channel = this.channels.find((candidate) => candidate?.output === output);
    if (channel) {
      channel.value = value;
    } else {
      this.lastGiven = (this.lastGiven + 1) % this.channels.length;
      const robbed = this.channels[this.lastGiven];
      this.channels[this.lastGiven] = { output, value };
      robbed?.output.show(this.signal(0));
    }
    output.show(this.signal(value));
  }

  /** Takes an output off its channel; the pin decides what it does next. */
  drop(output: PwmOutput): void {
    const place = this.channels.findIndex((channel) => channel?.output === output);
    if (place >= 0) this.channels[place] = null;
  }

  /** The counter compares with a whole number of counts; CODAL rounds the low part down. */
  private signal(value: number): Pwm {
    const lowCounts = Math.floor(Math.fround(this.countTop * (1 - value / VALUE_STEPS)));
    return { periodUs: this.periodUs, dutyFraction: (this.countTop - lowCounts) / this.countTop };
  }
}

const DEFAULT_PERIOD_US = 20_000; // NRF52Pin.cpp: the unit starts at 50 Hz
const TICKS_PER_US = 16; // nRF52833 product specification, PWM: counts a 16 MHz clock
const COUNT_LIMIT = 32_768; // COUNTERTOP has 15 bits
const MAX_PRESCALER = 7; // divides by up to 128
const VALUE_STEPS = 1024; // NRF52Pin.cpp: full scale is 1024, so 1023 is not quite always high
