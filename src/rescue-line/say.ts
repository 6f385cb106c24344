import type { Language } from '#core/languages';
import { unseenShown } from '#core/unseen';
import { filledIn } from '#core/words';
import type { MapNote } from './notes';
import words from './words';

/** A note on a map as a sentence. */
export const mapNoteText = ({ code, params }: MapNote, language: Language): string =>
  unseenShown(filledIn(words.notes[code][language], params));
