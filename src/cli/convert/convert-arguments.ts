import { extname } from 'node:path';
import { hexBoards, type HexBoard } from '#hex/firmware';

/** The forms into which work is converted. */
export const forms = ['project', 'course', 'program', 'files', 'hex', 'link', 'webtigerpython'] as const;
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
  /** Hexes with the MicroPython for a hex. */
  readonly firmware: readonly string[];
  /** The board of a hex; `null`: all that the firmware is for. */
  readonly board: HexBoard | null;
  /** Further files for a hex. */
  readonly files: readonly string[];
}

/** The options of `convert` that take a value and belong to no other command, without `--`. */
export const convertTexts = ['out', 'as'] as const;
const forHex = ['firmware', 'board', 'file'] as const;
const known: readonly string[] = [...convertTexts, ...forHex, 'json'];

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
    return { problem: `--out: ${out} does not end in .json (a project), .py (a program), .hex (for a board) or / (a folder). Say what it shall be: --as ${forms.join('|')}.` }; // prettier-ignore
  if (as === 'files' && out === null) return { problem: '--as files: say which folder takes them: --out folder/' };
  const hex = hexOf(as, given);
  return 'problem' in hex ? hex : { input, as, out, json: set.has('json'), ...hex };
}

/** The options of a hex, or what is wrong with them. */
function hexOf(
  as: Form | null,
  given: ReadonlyMap<string, readonly string[]>,
): Pick<ConvertOptions, 'firmware' | 'board' | 'files'> | { readonly problem: string } {
  // prettier-ignore
  const [firmware = [], files = []] = [given.get('firmware'), given.get('file')];
  const strange = as === 'hex' ? undefined : forHex.find((name) => given.has(name));
  if (strange !== undefined) return { problem: `--${strange} is for a hex only: --as hex --firmware FILE.hex` };
  if (as === 'hex' && firmware.length === 0)
    return { problem: 'A hex needs MicroPython. Give any hex that a Python editor saved for this board: --firmware FILE.hex' }; // prettier-ignore
  const wanted = given.get('board')?.at(-1) ?? null;
  const board = hexBoards.find((id) => id === wanted) ?? null;
  if (board === null && wanted !== null)
    return { problem: `--board: "${wanted}" is not known. Known: ${hexBoards.join(', ')}.` };
  return { firmware, board, files };
}

/** The form that the ending of a file says. */
function formOf(out: string | null): Form | null {
  if (out === null) return null;
  if (/[/\\]$/.test(out)) return 'files';
  const endings: Readonly<Record<string, Form>> = { '.json': 'project', '.py': 'program', '.hex': 'hex' };
  return endings[extname(out).toLowerCase()] ?? null;
}
