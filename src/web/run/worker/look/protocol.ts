/**
 * The messages between the page and a worker that looks into a run that has been: it runs it again, up to the moment that
 * is asked for. The newest wish wins; one that a newer one has overtaken gets no answer.
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

/** What somebody wants to see of a run. */
export type LookWish =
  | { readonly kind: 'moment'; readonly at: Instant }
  /** The line that begins before a moment. */
  | { readonly kind: 'back'; readonly at: Instant }
  /** Where the program is after a step from a moment, if it comes there before `untilUs`. */
  | { readonly kind: 'step'; readonly at: Instant; readonly step: LineStep; readonly untilUs: number }
  /** The line that has raised the error by which the program ended at this moment. */
  | { readonly kind: 'error'; readonly at: Instant; readonly line: number | null }
  /** The line that has set something at this moment: its beginning, or the moment if it had been at work for long. */
  | { readonly kind: 'line'; readonly at: Instant; readonly place: CodeLine };

/** Whose lines are asked for: of all outputs as they are at a moment, or of a line in the console. */
export interface WhyWish {
  readonly device: number;
  readonly timeUs: number;
  /** For a line in the console: how many of the device have this same time and come before. */
  readonly printed?: number;
}

/** A moment as it was. */
export interface Look extends Instant {
  readonly snapshot: Snapshot;
  readonly variables: Variables;
}

/** From the page to the worker. */
export type ToLooker =
  /** The run to look into: its set-up, with all that was done to it. Comes again when more was done. */
  | { readonly type: 'look-into'; readonly firmware: WebAssembly.Module; readonly setup: RunSetup }
  | { readonly type: 'look'; readonly ask: number; readonly wish: LookWish }
  | { readonly type: 'why'; readonly ask: number; readonly wish: WhyWish }
  /** Somebody may want to see what was shortly before this moment: what that takes is made ready. */
  | { readonly type: 'look-near'; readonly at: Instant };

/** From the worker to the page. `look`: `null` if there is no such moment. */
export type FromLooker =
  | { readonly type: 'looked'; readonly ask: number; readonly look: Look | null }
  /** One for each output that was ever set; of a line in the console, one or none. */
  | { readonly type: 'caused'; readonly ask: number; readonly causes: readonly Cause[] }
  | { readonly type: 'look-failed'; readonly message: string };
