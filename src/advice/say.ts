import type { Texts } from '#core/languages';
import { filledIn, inEvery } from '#core/words';
import type { Advice } from './advice';
import adviceWords from './words';

export { adviceWords };

/** An explanation in all languages; `null`: none. */
export function adviceTexts({ key, values }: Advice): Texts | null {
  if (key === 'error.other') return null;
  const name = key.slice('error.'.length) as keyof typeof adviceWords;
  return inEvery((language) => filledIn(adviceWords[name][language], values));
}
