import { GESTURES } from '#board/sensors';

import type { MicrobitState, StateEntry } from './messages';

/** The board that has a fourth pad for fingers. */
const CALLIOPE = 'calliope-mini-3';

/** Ids of what a finger presses, by what the page calls it. */
const PRESSED: Readonly<Record<string, string>> = { a: 'buttonA', b: 'buttonB' };

/** The id of a button or a touch pad in the state. @param key `a`, `b`, `pinLogo`, `pin0` … */
export const pressedId = (key: string): string => PRESSED[key] ?? key;

interface Range {
  readonly min: number;
  readonly max: number;
  readonly start: number;
  readonly unit?: string;
  readonly lowThreshold?: number;
  readonly highThreshold?: number;
}

const PRESSABLE: Range = { min: 0, max: 1, start: 0 };
const ACCELERATION: Range = { min: -2000, max: 2000, start: 0, unit: 'mg' };
const FIELD: Range = { min: -2_000_000, max: 2_000_000, start: 0, unit: 'nT' };

/** Ranges in the order of the official simulator's state, with the names between them that are no range (its src/board/). */
const ORDER: readonly (readonly [id: string, range: Range | null])[] = [
  ['radio', null],
  ['buttonA', PRESSABLE],
  ['buttonB', PRESSABLE],
  ['pinLogo', PRESSABLE],
  ['pin0', PRESSABLE],
  ['pin1', PRESSABLE],
  ['pin2', PRESSABLE],
  ['pin3', PRESSABLE],
  ['accelerometerX', ACCELERATION],
  ['accelerometerY', ACCELERATION],
  ['accelerometerZ', ACCELERATION],
  ['gesture', null],
  ['compassX', FIELD],
  ['compassY', FIELD],
  ['compassZ', FIELD],
  ['compassHeading', { min: 0, max: 360, start: 0, unit: 'deg' }],
  ['lightLevel', { min: 0, max: 255, start: 127 }],
  ['dataLogging', null],
  ['temperature', { min: -5, max: 50, start: 21, unit: '°C' }],
  ['soundLevel', { min: 0, max: 255, start: 0, lowThreshold: 75, highThreshold: 150 }],
];

/** The state as a host has it: sensor values that outlive programs, and what the present program has made of radio and log. */
export class StateModel {
  private values: Readonly<Record<string, number>>;
  private gesture = 'none';
  private radio = { enabled: false, group: 0 };
  private logFull = false;

  /** @param values of sensors that were set already, by id */
  constructor(values: Readonly<Record<string, number>>) {
    this.values = values;
  }

  /** Every entry that this board has. */
  whole(board: string): MicrobitState {
    const ids = ORDER.map(([id]) => id).filter((id) => id !== 'pin3' || board === CALLIOPE);
    return Object.fromEntries(ids.map((id) => [id, this.entry(id)]));
  }

  /** One entry, whole; an empty state for an unknown id. */
  only(id: string): MicrobitState {
    return ORDER.some(([known]) => known === id) ? { [id]: this.entry(id) } : {};
  }

  /** What the sensor is set to. */
  valueOf(id: string): number | undefined {
    return this.values[id] ?? rangeOf(id)?.start;
  }

  /**
   * What `value` means for the sensor `id`: texts are whole numbers for all but the gesture.
   *
   * @returns `null` when there is no such sensor, or when the value is out of its range
   */
  read(id: string, value: number | string): number | string | null {
    if (id === 'gesture') return GESTURES.some((name) => name === value) ? value : null;
    const range = rangeOf(id);
    if (range === undefined) return null;
    const number = typeof value === 'number' ? value : Number.parseInt(value, 10);
    return number >= range.min && number <= range.max ? number : null;
  }

  set(id: string, value: number | string): void {
    if (id === 'gesture') this.gesture = String(value);
    else if (typeof value === 'number') this.values = { ...this.values, [id]: value };
  }

  /** @returns whether that is news */
  setRadio(enabled: boolean, group: number): boolean {
    if (this.radio.enabled === enabled && this.radio.group === group) return false;
    this.radio = { enabled, group };
    return true;
  }

  /** @returns whether that is news */
  setLogFull(logFull: boolean): boolean {
    if (this.logFull === logFull) return false;
    this.logFull = logFull;
    return true;
  }

  private entry(id: string): StateEntry {
    if (id === 'radio') return { type: 'radio', ...this.radio };
    if (id === 'dataLogging') return { type: 'dataLogging', logFull: this.logFull };
    if (id === 'gesture') return { type: 'enum', id, choices: [...GESTURES], value: this.gesture };
    const { start, ...range } = rangeOf(id) ?? PRESSABLE;
    return { type: 'range', id, ...range, value: this.values[id] ?? start };
  }
}

function rangeOf(id: string): Range | undefined {
  return ORDER.find(([known]) => known === id)?.[1] ?? undefined;
}
