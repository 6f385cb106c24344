import type { GenericSchema } from 'valibot';

/** One kind of message of a dialect, for the manual. */
export interface ManualMessage {
  /** What names it: the value of `type` or `kind`. */
  readonly name: string;
  /** `in`: the host says it; `out`: the page does. */
  readonly direction: 'in' | 'out';
  /** The fields, each with a `v.description`; what every message of the dialect has may be left out. */
  readonly schema: GenericSchema;
  /** What it is for and what comes of it, in a sentence or two. */
  readonly about: string;
  /** Likewise the fields of its answer, where it has one. */
  readonly answer?: GenericSchema;
}

/** What a dialect's `manual.ts` exports as `manual`; `scripts/manual.mjs` makes tables of it. */
export interface DialectManual {
  readonly title: string;
  readonly version: string;
  readonly messages: readonly ManualMessage[];
}
