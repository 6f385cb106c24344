import type { Texts } from '#core/languages';

/** A message about the page itself, at its foot; one that asks something stays until it is answered. */
export interface PageMessage {
  /** A message takes the place of an earlier one of its kind. */
  readonly kind: 'update' | 'no-storage' | 'may-be-refused';
  readonly text: Texts;
  readonly actions: readonly { readonly text: Texts; readonly run: () => void }[];
  /** The label of the button that closes the message. */
  readonly close: Texts;
}
