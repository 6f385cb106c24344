import { SPEEDS, type Speed } from '#simulation/pace';
import { isOn } from './address';
import { LOADINGS, THEMES } from './attribute-problem';
import { ParcoursMethods } from './methods';

/** The values that a script can set an attribute to; `null` removes it. */
export type Wished = string | number | null;

/** A speed as an attribute has it. */
export type SpeedText = `${Speed}`;
type Theme = (typeof THEMES)[number];
type Loading = (typeof LOADINGS)[number];

/** The attributes of the element as properties, because frameworks may set either. */
export abstract class ParcoursAttributes extends ParcoursMethods {
  /** Address of Parcours: its folder, or one of its pages. */
  get src(): string | null {
    return this.getAttribute('src');
  }
  set src(value: string | null) {
    this.write('src', value);
  }
  /** Shown parts, separated by commas: `bar`, `code`, `board`, `arena`, `tools`, `console`; or `all`. */
  get show(): string | null {
    return this.getAttribute('show');
  }
  set show(value: string | null) {
    this.write('show', value);
  }
  /** `system`, `light` or `dark`. */
  get theme(): Theme | null {
    return this.oneOf('theme', THEMES);
  }
  set theme(value: Theme | null) {
    this.write('theme', value);
  }
  /** Simulated seconds per second: 0.25, 0.5, 1, 2, 4, 8, or `max`. */
  get speed(): SpeedText | null {
    return this.oneOf('speed', SPEEDS.map(textOf));
  }
  set speed(value: Speed | SpeedText | null) {
    this.write('speed', value);
  }
  /** Id of a robot, `none`, or `auto`. */
  get robot(): string | null {
    return this.getAttribute('robot');
  }
  set robot(value: string | null) {
    this.write('robot', value);
  }
  /** Id of a microcomputer, or `auto`. */
  get board(): string | null {
    return this.getAttribute('board');
  }
  set board(value: string | null) {
    this.write('board', value);
  }
  /** Which of the used robots it is, 1 … 9999. */
  get seed(): string | null {
    return this.getAttribute('seed');
  }
  set seed(value: Wished) {
    this.write('seed', value);
  }
  /** How much the robot resembles a used one, 0 … 1. */
  get reality(): string | null {
    return this.getAttribute('reality');
  }
  set reality(value: Wished) {
    this.write('reality', value);
  }
  /** Id of a ready course that is opened without its program. */
  get world(): string | null {
    return this.getAttribute('world');
  }
  set world(value: string | null) {
    this.write('world', value);
  }
  /** Id of a ready course that is opened with its program. */
  get task(): string | null {
    return this.getAttribute('task');
  }
  set task(value: string | null) {
    this.write('task', value);
  }
  /** Permissions of the frame, as of an `iframe`. */
  get allow(): string | null {
    return this.getAttribute('allow');
  }
  set allow(value: string | null) {
    this.write('allow', value);
  }
  /** `lazy` (default): loads when it comes into view or receives a command; `eager`: at once. */
  get loading(): Loading | null {
    return this.oneOf('loading', LOADINGS);
  }
  set loading(value: Loading | null) {
    this.write('loading', value);
  }
  /** Number of `snapshot` events a second, 0 … 60; 0 if left out. */
  get snapshotHz(): string | null {
    return this.getAttribute('snapshot-hz');
  }
  set snapshotHz(value: Wished) {
    this.write('snapshot-hz', value);
  }
  /** No sound. */
  get muted(): boolean {
    return isOn(this.getAttribute('muted'));
  }
  set muted(value: boolean) {
    this.write('muted', value ? '' : null);
  }
  /** In a frame without an origin of its own, from the single file: without storage. */
  get sandboxed(): boolean {
    return isOn(this.getAttribute('sandboxed'));
  }
  set sandboxed(value: boolean) {
    this.write('sandboxed', value ? '' : null);
  }

  /** An attribute of which few values make sense; `null` also for another one. */
  private oneOf<T extends string>(name: string, known: readonly T[]): T | null {
    const value = this.getAttribute(name);
    return known.find((one) => one === value) ?? null;
  }

  private write(name: string, value: string | number | null | undefined): void {
    if (value === null || value === undefined) this.removeAttribute(name);
    else this.setAttribute(name, String(value));
  }
}

/**
 * Adopts properties that a framework has set before the element's code arrived: they would hide those of the class.
 *
 * @param element one that has just become an element of this class
 */
export function takeEarlyProperties(element: HTMLElement): void {
  const early = new Map(Object.entries(element));
  for (let made: unknown = Object.getPrototypeOf(element); isOurs(made); made = Object.getPrototypeOf(made)) {
    for (const [name, property] of Object.entries(Object.getOwnPropertyDescriptors(made))) {
      if (!isSettable(property) || !early.has(name)) continue;
      Reflect.deleteProperty(element, name);
      Reflect.set(element, name, early.get(name));
    }
  }
}

const textOf = (speed: Speed): SpeedText => `${speed}`;

const isSettable = (property: PropertyDescriptor): boolean => 'set' in property && property.set !== undefined;

const isOurs = (made: unknown): made is ParcoursMethods => made instanceof ParcoursMethods;
