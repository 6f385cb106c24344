import { extname } from 'node:path';

/** The forms into which work is converted. */
export const forms = ['project', 'course', 'program', 'link', 'webtigerpython'] as const;
export type Form = (typeof forms)[number];

/** The request to `parcours convert`. */
export interface ConvertOptions {
  /** A file, an address, the text of a course, the id of a ready course. */
  readonly input: string;
  /** `null`: nothing is made, only told. */
  readonly as: Form | null;
  /** `null`: to the terminal. */
  readonly out: string | null;
  readonly json: boolean;
}

/** The options of `convert` that take a value and belong to no other command, without `--`. */
export const convertTexts = ['out', 'as'] as const;
const known: readonly string[] = [...convertTexts, 'json'];

const EXAMPLE = 'For example: parcours convert "https://webtigerpython.ethz.ch/#?code=…" --out anna.json';

/** Reads the words after `parcours convert`, or says what is wrong with them. */
export function parseConvert(
  [input, ...more]: readonly string[],
  given: ReadonlyMap<string, readonly string[]>,
  set: ReadonlySet<string>,
): ConvertOptions | { readonly problem: string } {
  if (input === undefined) return { problem: `What shall be converted? ${EXAMPLE}` };
  if (more.length > 0) return { problem: `One thing at a time: what is "${more[0] ?? ''}"?` };
  const strange = [...given.keys(), ...set].find((name) => !known.includes(name));
  if (strange !== undefined)
    return { problem: `--${strange} is not for convert. Known: ${known.map((name) => `--${name}`).join(', ')}.` };
  const last = (name: (typeof convertTexts)[number]): string | null => given.get(name)?.at(-1) ?? null;
  const [wanted, out] = [last('as'), last('out')];
  const as = wanted === null ? formOf(out) : (forms.find((form) => form === wanted) ?? null);
  if (as === null && wanted !== null) return { problem: `--as: "${wanted}" is not known. Known: ${forms.join(', ')}.` };
  if (as === null && out !== null)
    return { problem: `--out: ${out} does not end in .json (a project) or .py (a program). Say what it shall be: --as ${forms.join('|')}.` }; // prettier-ignore
  return { input, as, out, json: set.has('json') };
}

/** The form that the ending of a file says. */
function formOf(out: string | null): Form | null {
  const ending = out === null ? '' : extname(out).toLowerCase();
  return ending === '.json' ? 'project' : ending === '.py' ? 'program' : null;
}
