import type { Language } from '#core/languages';
import type { CheckResult, ReasonCode } from '../result';
import words from './words';

/** A ready sentence for the note on a hand-in. */
export type BlockId = keyof typeof words.blocks;

/** The sentence that helps with a reason; `null`: none fits a program that could not be run. */
const blockOf: Readonly<Record<ReasonCode, BlockId | null>> = {
  ...{ time: 'time', forbidden: 'touch', spikes: 'touch', touched: 'touch', robot: 'touch', left: 'way', open: 'way' },
  ...{ helped: 'hand', empty: 'still', unmoved: 'still', waits: 'still' },
  ...{ stop: 'stop', whole: 'stop', heading: 'stop', reach: 'way', stay: 'stop', laps: 'way', checkpoints: 'way' },
  ...{ belongs: 'way', covered: 'way', tiles: 'way', score: 'way', touches: 'touch', slow: 'time', early: 'early' },
  ...{ display: 'shows', light: 'shows', sound: 'shows', console: 'shows', radio: 'shows', log: 'shows' },
  ...{ loop: 'loop', calls: 'calls', lines: 'short', delay: 'delay' },
  ...{ exception: 'error', panic: 'error', stuck: 'loop', long: null, refused: null, broken: null, unloaded: null },
};

/** The sentences for a result: one for each kind of what does not hold, or praise. */
export function blocksFor({ passed, checks, worlds }: CheckResult): readonly BlockId[] {
  const reasons = [...worlds, ...checks].flatMap(({ reason }) => (reason === null ? [] : [blockOf[reason.code]]));
  const found = [...new Set(reasons)].filter((id) => id !== null);
  return passed && found.length === 0 ? ['good'] : found;
}

/** A sentence in a language, and the few words on its button. */
export const blockText = (id: BlockId, language: Language): { readonly chip: string; readonly text: string } => ({
  chip: words.blocks[id].chip[language],
  text: words.blocks[id].text[language],
});

/** A note with a sentence more; one that is in it already is not added twice. */
export const withBlock = (note: string, text: string): string =>
  note.includes(text) ? note : `${note.trimEnd()} ${text}`.trim();
