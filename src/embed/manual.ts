import type { GenericSchema } from 'valibot';

/** One kind of message of a dialect, for the manual. */
export interface ManualMessage {
  /** Its name: the value of `type` or `kind`. */
  readonly name: string;
  /** `in`: sent by the host; `out`: sent by the page. */
  readonly direction: 'in' | 'out';
  /** The fields, each with a `v.description`; fields common to all messages of the dialect may be left out. */
  readonly schema: GenericSchema;
  /** Its purpose and its effect, in one or two sentences. */
  readonly about: string;
  /** The fields of its answer, if it has one. */
  readonly answer?: GenericSchema;
  /** The version of the app that brought it, if it is younger than the dialect. */
  readonly since?: string;
}

/** The export `manual` of a dialect's `manual.ts`; `scripts/manual.mjs` makes tables from it. */
export interface DialectManual {
  readonly title: string;
  readonly version: string;
  readonly messages: readonly ManualMessage[];
}
