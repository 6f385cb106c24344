import type { Language } from '#core/languages';
import { filledIn } from '#core/words';
import { shownName, type NamedResult } from '#check/report/class-result';
import { shownNames } from '#check/report/names';
import { contentOf, type Source } from '#intake/sources';
import words from './words';

/**
 * Hand-ins for which `NAME=FILE` says which of their files is the program; NAME as it is, or as it is shown.
 *
 * @returns or what is wrong: nobody is called like that
 */
export function withTaken(
  sources: readonly Source[],
  take: readonly string[],
): readonly Source[] | { readonly problem: string } {
  const chosen = new Map<string, string>();
  const shown = shownNames(sources.map(({ name }) => name));
  const fileIn = (wish: string, name = ''): string | null =>
    wish.startsWith(`${name}=`) ? wish.slice(name.length + 1) : null;
  for (const wish of take) {
    const at = sources.findIndex(
      ({ name }, place) => fileIn(wish, name) !== null || fileIn(wish, shown[place]) !== null,
    );
    const source = sources[at];
    if (source === undefined)
      return { problem: `--take: "${wish}" is not like "NAME=main.py" with the name of a hand-in.` };
    chosen.set(source.name, fileIn(wish, source.name) ?? fileIn(wish, shown[at]) ?? '');
  }
  return sources.map((source) => {
    const file = chosen.get(source.name);
    return file === undefined ? source : { name: source.name, read: () => contentWith(source, file) };
  });
}

/** The hand-in with this file as its program; if it has no such file, it still asks. */
async function contentWith(source: Source, file: string): ReturnType<typeof contentOf> {
  const content = await contentOf(source);
  const choice = 'problem' in content ? content.choices?.find((one) => one.file === file) : undefined;
  return choice === undefined ? content : { handIn: choice.handIn };
}

/** How to say which file is the program, where somebody has to; `null`: it is known of all. */
export function howToTake(handIns: readonly NamedResult[], language: Language): string | null {
  for (const one of handIns) {
    const several = one.result.remarks.find(({ params }) => params['why'] === 'several');
    const [file] = String(several?.params['files'] ?? '').split(', ');
    if (several !== undefined) return filledIn(words.take[language], { name: shownName(one), file: file ?? '' });
  }
  return null;
}
