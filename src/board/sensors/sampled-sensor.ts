import type { Clock } from '#core/clock';
import type { Sensors } from './sensors';

/**
 * A sensor that the board reads at its first use and then periodically; in between, it gives the last reading. It
 * sets no alarm: a value from outside is held back until its reading is due.
 */
export class SampledSensor {
  /** When the first reading was taken; `null` before it. */
  private firstUs: number | null = null;
  private reading = 0;
  /** The value of the sensor since `rawSinceUs`. */
  private raw: number;
  private rawSinceUs = 0;

  constructor(
    private readonly clock: Clock,
    sensors: Sensors,
    id: string,
    private readonly periodUs: number,
  ) {
    this.raw = sensors.get(id);
    sensors.onSet((changed) => {
      if (changed !== id) return;
      if (this.firstUs !== null) this.look(this.firstUs);
      this.raw = sensors.get(id);
      this.rawSinceUs = this.clock.nowUs;
    });
  }

  /** The last reading. */
  get value(): number {
    if (this.firstUs === null) {
      this.firstUs = this.clock.nowUs;
      this.reading = this.raw;
    }
    this.look(this.firstUs);
    return this.reading;
  }

  /** Back to the state after a start: the next call takes a new reading. */
  reset(): void {
    this.firstUs = null;
  }

  private look(firstUs: number): void {
    const lastUs = this.clock.nowUs - ((this.clock.nowUs - firstUs) % this.periodUs);
    // A value that arrives in the very µs of a reading is too late for it (rule T3).
    if (lastUs > this.rawSinceUs) this.reading = this.raw;
  }
}
