import type { RunSetup } from '#simulation/run-setup';

/** One run for the worker. */
export interface ProbeTask {
  readonly firmware: WebAssembly.Module;
  readonly setup: RunSetup;
  /** Simulated time at which the run is looked at, in ms. */
  readonly untilMs: number;
}

/** The outcome of a probe. */
export interface ProbeResult {
  readonly traceHash: string;
  /** The output of all devices, one after the other. */
  readonly console: string;
  readonly timeUs: number;
  /** The free heap of each device. */
  readonly heapFree: readonly number[];
  /** All that the boards said to its surroundings, in order: sounds, radio packets and rows of the data log, as JSON. */
  readonly told: readonly string[];
}

/** A sweep for the worker. */
export interface SweepTask {
  readonly firmware: WebAssembly.Module;
  /** The run that varies. */
  readonly setup: RunSetup;
  /** Each `WHAT=VALUES`. */
  readonly vary: readonly string[];
}

/** The result, the table of a sweep as one line of JSON, or what broke. */
export type ProbeAnswer = { readonly result: ProbeResult } | { readonly table: string } | { readonly problem: string };
