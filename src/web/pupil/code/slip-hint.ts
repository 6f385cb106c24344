import type { TextKey, TextValues } from '../../kit/i18n/texts';

/** A slip that the editor shows before the program runs. */
export interface SlipHint {
  readonly from: number;
  readonly to: number;
  readonly key: TextKey;
  readonly values: TextValues;
  /** The change that a button makes; `null` if it is not certain. */
  readonly change: { readonly from: number; readonly to: number; readonly insert: string } | null;
}
