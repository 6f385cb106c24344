import type { Language } from '#core/languages';
import { unseenShown } from '#core/unseen';
import { filledIn } from '#core/words';

import type { Note } from './note';
import words from './words';

/** A note as a sentence. */
export const noteText = ({ code, params }: Note, language: Language): string =>
  unseenShown(filledIn(words.notes[code][language], params));
