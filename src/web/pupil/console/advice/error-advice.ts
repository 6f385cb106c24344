import type { AtTable } from '#advice/at-table';
import { adviceFor as adviceOf, type Advice as AdviceOf, type Failure } from '#advice/advice';
import type { Source } from '#advice/syntax-advice';

import type { TextKey, TextValues } from '../../../kit/i18n/texts';

export type { Failure } from '#advice/advice';

/** An explanation of an error in the pupil's language: a text's name and what goes into it. */
export interface Advice extends Omit<AdviceOf, 'key' | 'values'> {
  readonly key: TextKey;
  readonly values: TextValues;
}

/** All that an explanation is made of. */
export interface ErrorReport {
  readonly failure: Failure;
  /** The pupil's file and the line that the exception names. */
  readonly source: Source | null;
  readonly table: AtTable | null;
}

/**
 * The explanation of an exception for pupils.
 *
 * @param table what is plugged in. With it, a robot that does not answer can be explained.
 */
export const adviceFor: (failure: Failure, source?: Source | null, table?: AtTable | null) => Advice = adviceOf;
