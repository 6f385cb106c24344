import { findBoard } from '#board/boards/index';
import { microbitV2 } from '#board/boards/microbit-v2';
import { GESTURES, GRAVITY_MG, padId } from '#board/sensors/sensors';

import type { MicrobitState, StateEntry } from './messages';

/** Ids of things to press, by the page's names for them. */
const PRESSED: Readonly<Record<string, string>> = { a: 'buttonA', b: 'buttonB' };

/** The id of a button or a touch pad in the state. @param key `a`, `b`, `pinLogo`, `pin0` … */
export const pressedId = (key: string): string => PRESSED[key] ?? key;

/** The limits of sensors that a program can change. */
export interface SensorLimits {
  /** Range of each axis of the accelerometer in both directions, in mg. */
  readonly accelerometerRangeMg: number;
  readonly soundThresholds: { readonly quiet: number; readonly loud: number };
}

interface Range {
  readonly min: number;
  readonly max: number;
  readonly start: number;
  readonly unit?: string;
  readonly lowThreshold?: number;
  readonly highThreshold?: number;
}

const PRESSABLE: Range = { min: 0, max: 1, start: 0 };
/** Initial values of the axes: the board lies on the table, display up. */
const AT_REST: Readonly<Record<string, number>> = { accelerometerX: 0, accelerometerY: 0, accelerometerZ: -GRAVITY_MG };
const AXES = Object.keys(AT_REST);
const SOUND = { min: 0, max: 255, start: 0 } as const;
const START_LIMITS: SensorLimits = { accelerometerRangeMg: 2000, soundThresholds: { quiet: 75, loud: 150 } };
const FIELD: Range = { min: -2_000_000, max: 2_000_000, start: 0, unit: 'nT' };

/**
 * Ranges in the order of the official simulator's state (its src/board/), and between them the names without a range,
 * or with one that programs change.
 */
const ORDER: readonly (readonly [id: string, range: Range | null])[] = [
  ['radio', null],
  ['buttonA', PRESSABLE],
  ['buttonB', PRESSABLE],
  ['pinLogo', PRESSABLE],
  ['pin0', PRESSABLE],
  ['pin1', PRESSABLE],
  ['pin2', PRESSABLE],
  ['pin3', PRESSABLE],
  ['accelerometerX', null],
  ['accelerometerY', null],
  ['accelerometerZ', null],
  ['gesture', null],
  ['compassX', FIELD],
  ['compassY', FIELD],
  ['compassZ', FIELD],
  ['compassHeading', { min: 0, max: 360, start: 0, unit: 'deg' }],
  ['lightLevel', { min: 0, max: 255, start: 127 }],
  ['dataLogging', null],
  ['temperature', { min: -5, max: 50, start: 21, unit: '°C' }],
  ['soundLevel', null],
];

/** The state in the host's form: sensor values (they survive programs), and the program's settings of radio and log. */
export class StateModel {
  private values: Readonly<Record<string, number>>;
  private gesture = 'none';
  private radio = { enabled: false, group: 0 };
  private logFull = false;
  private limits = START_LIMITS;

  /** @param values of sensors that were set before, by id */
  constructor(values: Readonly<Record<string, number>>) {
    this.values = values;
  }

  /** Every entry of this board. */
  whole(board: string): MicrobitState {
    const { pins } = findBoard(board) ?? microbitV2;
    const pads = pins.filter(({ touch }) => touch !== null).map(({ name }) => padId(name));
    const ids = ORDER.map(([id]) => id).filter((id) => !id.startsWith('pin') || pads.includes(id));
    return Object.fromEntries(ids.map((id) => [id, this.entry(id)]));
  }

  /** One entry, whole; an empty state for an unknown id. */
  only(id: string): MicrobitState {
    return ORDER.some(([known]) => known === id) ? { [id]: this.entry(id) } : {};
  }

  /**
   * The meaning of `value` for the sensor `id`: texts are whole numbers for all sensors except the gesture.
   *
   * @returns `null` for an unknown sensor, or a value out of its range
   */
  read(id: string, value: number | string): number | string | null {
    if (id === 'gesture') return GESTURES.some((name) => name === value) ? value : null;
    const range = this.rangeOf(id);
    if (range === undefined) return null;
    const number = typeof value === 'number' ? value : Number.parseInt(value, 10);
    return number >= range.min && number <= range.max ? number : null;
  }

  set(id: string, value: number | string): void {
    if (id === 'gesture') this.gesture = String(value);
    else if (typeof value === 'number') this.values = { ...this.values, [id]: value };
  }

  /** True if the button is pressed or the pad touched. */
  isDown(id: string): boolean {
    return (this.values[id] ?? 0) >= 0.5;
  }

  /** Applies the program's settings of its sensors; values beyond the range are clamped. @returns ids of changes */
  setLimits({ accelerometerRangeMg, soundThresholds: { quiet, loud } }: SensorLimits): readonly string[] {
    const before = this.limits;
    const isFurther = before.accelerometerRangeMg !== accelerometerRangeMg;
    const isOtherSound = before.soundThresholds.quiet !== quiet || before.soundThresholds.loud !== loud;
    if (!isFurther && !isOtherSound) return [];
    this.limits = { accelerometerRangeMg, soundThresholds: { quiet, loud } };
    if (isFurther) this.bringWithin(accelerometerRangeMg);
    return [...(isFurther ? AXES : []), ...(isOtherSound ? ['soundLevel'] : [])];
  }

  /** A program is over, and with it its settings of radio and sensors. */
  rest(): void {
    this.setRadio(false, 0);
    this.setLimits(START_LIMITS);
  }

  /** @returns whether that has changed */
  setRadio(enabled: boolean, group: number): boolean {
    if (this.radio.enabled === enabled && this.radio.group === group) return false;
    this.radio = { enabled, group };
    return true;
  }

  /** @returns whether that has changed */
  setLogFull(logFull: boolean): boolean {
    if (this.logFull === logFull) return false;
    this.logFull = logFull;
    return true;
  }

  private entry(id: string): StateEntry {
    if (id === 'radio') return { type: 'radio', ...this.radio };
    if (id === 'dataLogging') return { type: 'dataLogging', logFull: this.logFull };
    if (id === 'gesture') return { type: 'enum', id, choices: [...GESTURES], value: this.gesture };
    const { start, ...range } = this.rangeOf(id) ?? PRESSABLE;
    return { type: 'range', id, ...range, value: this.values[id] ?? start };
  }

  private bringWithin(rangeMg: number): void {
    const axes = AXES.flatMap((id): readonly [string, number][] => {
      const value = this.values[id];
      return value === undefined ? [] : [[id, Math.max(-rangeMg, Math.min(rangeMg, value))]];
    });
    this.values = { ...this.values, ...Object.fromEntries(axes) };
  }

  private rangeOf(id: string): Range | undefined {
    const { accelerometerRangeMg, soundThresholds } = this.limits;
    const start = AT_REST[id];
    if (start !== undefined) return { start, unit: 'mg', min: -accelerometerRangeMg, max: accelerometerRangeMg };
    if (id === 'soundLevel')
      return { ...SOUND, lowThreshold: soundThresholds.quiet, highThreshold: soundThresholds.loud };
    return ORDER.find(([known]) => known === id)?.[1] ?? undefined;
  }
}
