import type { Feature } from '#core/board-api';
import type { RuleId, Severity } from './rule-table';

/** A place in a pupil's program that runs here and not on the device, or not in the same way. */
export interface Finding {
  readonly file: string;
  /** Counted from 1, as in the device's messages. */
  readonly line: number;
  /** Counted from 1, in UTF-16 units. */
  readonly column: number;
  /** The place in the file's text: first character and the one after the last, never beyond its line's end. */
  readonly from: number;
  readonly to: number;
  readonly rule: RuleId;
  /** The name in question: `splitlines`, `math.inf`; empty if the rule says it all. */
  readonly name: string;
  /** Python code that works on the device; empty if the rule's text names the way out. */
  readonly instead: string;
  readonly severity: Severity;
}

/** The target of the program. */
export interface Device {
  /** Names that its firmware has and micro:bit firmware v2.1.2 does not. */
  readonly features: readonly Feature[];
  /** Version of its MicroPython, such as `[1, 18, 0]`. */
  readonly micropython: readonly [number, number, number];
}
