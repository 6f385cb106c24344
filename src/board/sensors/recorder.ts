import type { Clock } from '#core/clock';
import { exactSin } from '#core/exact-math';
import type { Stop } from '#core/stop';

const CHUNK_US = 20_000; // chosen: a recording arrives in pieces of this duration
const TONE_HZ = 440; // chosen: the sound of a microphone that only knows how loud it is
const SILENCE = 128; // microbithal_microphone.cpp: unsigned 8-bit samples
const FULL_SCALE = 127;
const FULL_LEVEL = 255;
/** The gain at which a level of 255 reaches full scale: main.cpp sets it at the start. */
export const MEDIUM_SENSITIVITY = 0.2;

/** The parameters of a recording, and its destination. */
export interface RecordingOrder {
  /** Samples a second, at least 1. */
  readonly rateHz: number;
  /** Room for this many samples. */
  readonly length: number;
  /** Receives the next samples, `offset` samples after the first. */
  readonly write: (offset: number, samples: Uint8Array) => void;
}

/**
 * Records 8-bit samples while simulated time passes. They are a tone of 440 Hz with the loudness of the moment, since
 * the sensor knows the loudness alone.
 */
export class Recorder {
  private order: RecordingOrder | null = null;
  private startUs = 0;
  private written = 0;
  private stopClock: Stop = () => undefined;

  /**
   * @param level the present loudness, 0 … 255
   * @param gain its present amplification; see `MEDIUM_SENSITIVITY`
   */
  constructor(
    private readonly clock: Clock,
    private readonly level: () => number,
    private readonly gain: () => number,
  ) {}

  get isRecording(): boolean {
    return this.order !== null;
  }

  /** Begins a recording and ends the current one. */
  start(order: RecordingOrder): void {
    this.stop();
    if (order.length <= 0) return;
    this.order = order;
    this.startUs = this.clock.nowUs;
    this.written = 0;
    this.next();
  }

  /** Ends; everything recorded up to now has been written. */
  stop(): void {
    this.catchUp();
    this.order = null;
    this.stopClock();
  }

  /** Call it before the sound level changes: the samples up to now have the old level. */
  catchUp(): void {
    const { order } = this;
    if (!order) return;
    const due = Math.min(Math.floor(((this.clock.nowUs - this.startUs) * order.rateHz) / 1_000_000), order.length);
    if (due <= this.written) return;
    order.write(this.written, this.samples(due - this.written, order.rateHz));
    this.written = due;
  }

  private next(): void {
    const { order } = this;
    if (!order) return;
    const endUs = this.startUs + Math.ceil((order.length * 1_000_000) / order.rateHz);
    this.stopClock = this.clock.at(Math.min(this.clock.nowUs + CHUNK_US, endUs), () => {
      this.catchUp();
      if (this.written >= order.length) this.order = null;
      else this.next();
    });
  }

  private samples(count: number, rateHz: number): Uint8Array {
    const loudness = ((this.level() / FULL_LEVEL) * this.gain()) / MEDIUM_SENSITIVITY;
    const peak = Math.min(1, loudness) * FULL_SCALE;
    return Uint8Array.from({ length: count }, (_, i) => {
      const turns = ((this.written + i) * TONE_HZ) / rateHz;
      return SILENCE + Math.round(peak * exactSin((turns - Math.floor(turns)) * 2 * Math.PI));
    });
  }
}
