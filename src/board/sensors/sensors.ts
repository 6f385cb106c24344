import type { Stop } from '#core/stop';
import { GESTURE_NAMES } from './gestures';

/** Something a finger can hold down: a button or a touch pad. */
export interface Pressable {
  press(): void;
  release(): void;
  readonly isDown: boolean;
}

/** A sensor as a panel shows it. */
export type SensorInfo =
  | {
      readonly id: string;
      readonly kind: 'range';
      readonly min: number;
      readonly max: number;
      readonly start: number;
      /** Empty for a plain number. */
      readonly unit: string;
    }
  | { readonly id: string; readonly kind: 'choice'; readonly choices: readonly string[]; readonly start: string };

interface Range {
  readonly min: number;
  readonly max: number;
  readonly start: number;
  readonly unit: string;
}

/** Gravity as measured by an accelerometer at rest, in its own mg (codal-core Accelerometer.h). */
export const GRAVITY_MG = 1024;

/**
 * Ranges, start values and ids as in the official simulator (micropython-microbit-v2-simulator, src/board/), except
 * for gravity: this board rests on the table, display up, while the official one is in free fall (all axes 0).
 */
const RANGES: Readonly<Record<string, Range>> = {
  accelerometerX: { min: -2000, max: 2000, start: 0, unit: 'mg' },
  accelerometerY: { min: -2000, max: 2000, start: 0, unit: 'mg' },
  accelerometerZ: { min: -2000, max: 2000, start: -GRAVITY_MG, unit: 'mg' },
  compassX: { min: -2_000_000, max: 2_000_000, start: 0, unit: 'nT' },
  compassY: { min: -2_000_000, max: 2_000_000, start: 0, unit: 'nT' },
  compassZ: { min: -2_000_000, max: 2_000_000, start: 0, unit: 'nT' },
  compassHeading: { min: 0, max: 360, start: 0, unit: 'deg' },
  temperature: { min: -5, max: 50, start: 21, unit: '°C' },
  lightLevel: { min: 0, max: 255, start: 127, unit: '' },
  soundLevel: { min: 0, max: 255, start: 0, unit: '' },
};

const PRESSABLE: Range = { min: 0, max: 1, start: 0, unit: '' };
const NO_GESTURE = 'none';

/** The values of `gesture`; `none` for no gesture. Same source. */
export const GESTURES: readonly string[] = [
  NO_GESTURE,
  ...GESTURE_NAMES.filter((name) => name !== '' && name !== '2g'), // the official simulator has no 2g
];

/** Sensor id of a touch pad, by the Python name of its pin: `pin0`, and `pinLogo` for `pin_logo`. */
export const padId = (pin: string): string => pin.replace(/_(.)/, (_, letter: string) => letter.toUpperCase());

/**
 * The board's sensor values, set from outside.
 *
 * Ids: accelerometerX/Y/Z (mg), compassX/Y/Z (nT), compassHeading (degrees), temperature (°C), lightLevel, soundLevel,
 * gesture (a name), and 0 or 1 for everything that can be pressed: buttonA, buttonB, pinLogo, pin0 …
 */
export class Sensors {
  private readonly values = new Map<string, number>();
  /** Measure values when they are asked for, by sensor id. */
  private readonly measures = new Map<string, () => number>();
  private readonly ranges = new Map<string, Range>(Object.entries(RANGES));
  private readonly listeners: ((id: string) => void)[] = [];
  private gesture = NO_GESTURE;

  /** @param pressables everything that can be pressed, by sensor id */
  constructor(private readonly pressables: ReadonlyMap<string, Pressable>) {
    for (const [id, range] of Object.entries(RANGES)) this.values.set(id, range.start);
  }

  /** The present value. @throws RangeError for an unknown id */
  get(id: 'gesture'): string;
  get(id: string): number;
  get(id: string): number | string {
    if (id === 'gesture') return this.gesture;
    const measure = this.measures.get(id);
    if (measure !== undefined) return measure();
    const pressable = this.pressables.get(id);
    if (pressable) return pressable.isDown ? 1 : 0;
    const value = this.values.get(id);
    if (value === undefined) throw new RangeError(unknown(id, this.ids));
    return value;
  }

  /**
   * The problem with a value: an unknown id, or outside its range. Names id, value and range; `null`: it can be set.
   */
  problemOf(id: string, value: number | string): string | null {
    if (id === 'gesture') {
      const isGesture = typeof value === 'string' && GESTURES.includes(value);
      return isGesture ? null : `Sensor ${id}: ${JSON.stringify(value)} is none of ${GESTURES.join(', ')}.`;
    }
    const range = this.pressables.has(id) ? PRESSABLE : this.ranges.get(id);
    if (!range) return unknown(id, this.ids);
    if (typeof value === 'number' && value >= range.min && value <= range.max) return null;
    const span = `${range.min} … ${range.max} ${range.unit}`.trim();
    return `Sensor ${id}: ${JSON.stringify(value)} is not a number within ${span}.`;
  }

  /** Has a value measured whenever it is asked for, until it is set; listeners hear nothing of it. Within its range. */
  measure(id: string, read: () => number): void {
    this.measures.set(id, read);
  }

  /** True while a value is measured: nobody has set it since. */
  isMeasured(id: string): boolean {
    return this.measures.has(id);
  }

  /** Sets a value. @throws RangeError with the words of `problemOf` */
  set(id: string, value: number | string): void {
    const problem = this.problemOf(id, value);
    if (problem !== null) throw new RangeError(problem);
    this.measures.delete(id);
    const pressable = this.pressables.get(id);
    if (id === 'gesture') this.gesture = String(value);
    else if (!pressable) this.values.set(id, Number(value));
    else if (Number(value) >= 0.5) pressable.press();
    else pressable.release();
    for (const tell of [...this.listeners]) tell(id);
  }

  /** Changes the range of a sensor; a value beyond it is clamped. @throws RangeError for an id without a range */
  limit(id: string, min: number, max: number): void {
    const range = this.ranges.get(id);
    if (!range) throw new RangeError(unknown(id, [...this.ranges.keys()]));
    this.ranges.set(id, { ...range, min, max });
    this.values.set(id, Math.max(min, Math.min(max, this.values.get(id) ?? range.start)));
  }

  /** The nearest value within the sensor's present range; a sensor without a range takes the value as it is. */
  nearest(id: string, value: number | string): number | string {
    const range = this.ranges.get(id);
    return range === undefined || typeof value !== 'number' ? value : Math.max(range.min, Math.min(range.max, value));
  }

  /** All sensors with their present ranges: for panels and files. In the order of `ids`. */
  describe(): readonly SensorInfo[] {
    return this.ids.map((id) => {
      if (id === 'gesture') return { id, kind: 'choice', choices: GESTURES, start: NO_GESTURE };
      return { id, kind: 'range', ...(this.ranges.get(id) ?? PRESSABLE) };
    });
  }

  /** Every id this board knows. */
  get ids(): readonly string[] {
    return [...this.values.keys(), 'gesture', ...this.pressables.keys()];
  }

  /** Reports the id of everything that was set, also when the value is the same as before (a second shake counts). */
  onSet(listener: (id: string) => void): Stop {
    this.listeners.push(listener);
    return () => {
      const place = this.listeners.indexOf(listener);
      if (place >= 0) this.listeners.splice(place, 1);
    };
  }
}

const unknown = (id: string, ids: readonly string[]): string =>
  `There is no sensor ${JSON.stringify(id)}. Known are ${ids.join(', ')}.`;
