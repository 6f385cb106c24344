/**
 * The messages between the page and a worker that inspects a past run: it repeats the run up to the requested moment.
 * The newest request wins; one that a newer one has replaced gets no answer.
 */
import type { Cause } from '#simulation/causes/causes';
import type { CodeLine } from '#simulation/causes/output';
import type { RunSetup } from '#simulation/run-setup';
import type { Snapshot } from '#simulation/snapshot';
import type { LineStep } from '#vm/debug/stops';
import type { Variables } from '#vm/debug/variables';

/** A moment of a run: a time of a device's clock. */
export interface Instant {
  /** Place of the device. */
  readonly device: number;
  readonly timeUs: number;
  /** A line begins there: the moment is just before its first bytecode. */
  readonly isLine: boolean;
}

/** The requested view of a run. */
export type LookWish =
  | { readonly kind: 'moment'; readonly at: Instant }
  /** The line that begins before a moment. `within`: the line in whose midst the moment is, which does not count. */
  | { readonly kind: 'back'; readonly at: Instant; readonly within?: CodeLine | null }
  /** Position of the program after a step from a moment, if it is reached before `untilUs`. */
  | { readonly kind: 'step'; readonly at: Instant; readonly step: LineStep; readonly untilUs: number }
  /** The line that has raised the error by which the program ended at this moment. */
  | { readonly kind: 'error'; readonly at: Instant; readonly line: number | null }
  /** The line that has set something at this moment: its beginning, or the moment if it had been at work for long. */
  | { readonly kind: 'line'; readonly at: Instant; readonly place: CodeLine };

/** The question for lines: of all outputs at a moment, or of a line in the console. */
export interface WhyWish {
  readonly device: number;
  readonly timeUs: number;
  /** For a line in the console: number of the device's lines with the same time before it. */
  readonly printed?: number;
}

/** A moment of a run, with its picture and the device's variables. */
export interface Look extends Instant {
  readonly snapshot: Snapshot;
  readonly variables: Variables;
}

/** From the page to the worker. */
export type ToLooker =
  /** The run to inspect: its set-up, with all its inputs. Sent again when there are more. */
  | { readonly type: 'look-into'; readonly firmware: WebAssembly.Module; readonly setup: RunSetup }
  | { readonly type: 'look'; readonly ask: number; readonly wish: LookWish }
  | { readonly type: 'why'; readonly ask: number; readonly wish: WhyWish }
  /** The time shortly before this moment may be requested next: prepares for it. */
  | { readonly type: 'look-near'; readonly at: Instant };

/** From the worker to the page. `look`: `null` if there is no such moment. */
export type FromLooker =
  | { readonly type: 'looked'; readonly ask: number; readonly look: Look | null }
  /** One for each output that was ever set; of a line in the console, one or none. */
  | { readonly type: 'caused'; readonly ask: number; readonly causes: readonly Cause[] }
  | { readonly type: 'look-failed'; readonly message: string };
