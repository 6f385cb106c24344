import { optionOf, type Option } from '#core/option';
import words from './words';

/** The options of the two colour sensors that every robot may carry. Light: the page loads it before anything runs. */
export const colourOptions: readonly Option[] = (['colour', 'colourAhead'] as const).map((id) =>
  optionOf(id, words[id], ['none', 'tcs34725']),
);
