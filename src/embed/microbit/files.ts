import { FILE_BYTES, MAIN, nameProblem, projectLimits, type SourceFile } from '#project/project';

/** The files of a `flash` in the page's form. */
export interface FlashedFiles {
  /** `main.py` first. */
  readonly files: readonly SourceFile[];
  /** The files that the page cannot hold, in English sentences; `null` for none. */
  readonly leftOut: string | null;
}

/**
 * The files of a `flash` in the page's form: `main.py` first; if it is missing, an empty one, after which the REPL
 * comes at once as on the board. The page keeps a program as text, in files with usual names. Other files are left out,
 * so that the program runs as far as it does without them.
 *
 * @returns a problem in one English sentence if the page cannot hold `main.py` itself
 */
export function filesOf(filesystem: Readonly<Record<string, Uint8Array>>): FlashedFiles | { readonly problem: string } {
  const main = fileOf(MAIN, filesystem[MAIN] ?? new Uint8Array(), []);
  if (typeof main === 'string') return { problem: `${MAIN} ${main}.` };
  const files = [main];
  const leftOut: string[] = [];
  for (const [name, bytes] of Object.entries(filesystem)) {
    if (name === MAIN) continue;
    const file = fileOf(name, bytes, files);
    if (typeof file !== 'string') files.push(file);
    else if (leftOut.length < MOST_NAMED) leftOut.push(`${quoted(name)} is left out: it ${file}.`);
  }
  return { files, leftOut: leftOut.length === 0 ? null : leftOut.join(' ') };
}

/** Number of left-out files that are reported by name. Chosen: the first ones show what is wrong with all. */
const MOST_NAMED = 5;

/** One file, or why the page cannot hold it beside `others`: a phrase that follows its name. */
function fileOf(name: string, bytes: Uint8Array, others: readonly SourceFile[]): SourceFile | string {
  if (others.length >= projectLimits.files) return `is one too many; the limit is ${String(projectLimits.files)}`;
  const problem = nameProblem(name, others);
  if (problem !== null) return `has a name that cannot be (${problem})`;
  if (bytes.length > FILE_BYTES) return `has ${String(bytes.length)} bytes; the limit is ${String(FILE_BYTES)}`;
  const text = textOf(bytes);
  return text === null ? 'is no UTF-8 text' : { name, text };
}

const quoted = (name: string): string => JSON.stringify(name.length > 60 ? `${name.slice(0, 60)}…` : name);

function textOf(bytes: Uint8Array): string | null {
  try {
    return new TextDecoder('utf-8', { fatal: true }).decode(bytes);
  } catch {
    return null;
  }
}
