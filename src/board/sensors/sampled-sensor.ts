import type { Clock } from '#core/clock';
import type { Sensors } from './sensors';

/**
 * A sensor that the board reads once, when it is first asked, and then periodically: in between it gives the last
 * reading. No alarm is set for it; what is set outside is kept until its reading would have come.
 */
export class SampledSensor {
  /** When the first reading was taken; `null` before. */
  private firstUs: number | null = null;
  private reading = 0;
  /** What the sensor has felt since `rawSinceUs`. */
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

  /** As after a start: the next question takes a new reading. */
  reset(): void {
    this.firstUs = null;
  }

  private look(firstUs: number): void {
    const lastUs = this.clock.nowUs - ((this.clock.nowUs - firstUs) % this.periodUs);
    // What came in the very µs of a reading was too late for it (rule T3).
    if (lastUs > this.rawSinceUs) this.reading = this.raw;
  }
}
