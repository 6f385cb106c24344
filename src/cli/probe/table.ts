/**
 * The tables that the probes of `docs/hardware/probe` print, as in the saved output of a board:
 *
 *     probe;begin;<program>;<version>;<machine>
 *     probe;row;<unit>;<id>;<value>          value: the rest of the line
 *     probe;end;<program>;<number of rows>
 *
 * Other lines (greetings, prompts) are ignored.
 */
export interface ProbeTable {
  readonly program: string;
  /** As `os.uname()` calls the board. */
  readonly machine: string;
  /** By id. */
  readonly rows: ReadonlyMap<string, ProbeRow>;
}

/** One thing that was probed. */
export interface ProbeRow {
  readonly unit: Unit;
  readonly value: string;
}

/** Units of values: µs, ms, bytes, counts, or words. */
export const UNITS = ['us', 'ms', 'bytes', 'items', 'calls', 'text'] as const;
export type Unit = (typeof UNITS)[number];

/** The version of the tables that are read. */
const VERSION = '1';
/** Most rows of one table. Chosen: far more than any probe prints. */
const MOST_ROWS = 2000;

/** The tables in a text, or what is wrong with it: one line that names the place. */
export function parseProbe(text: string): { readonly tables: readonly ProbeTable[] } | { readonly problem: string } {
  const tables: ProbeTable[] = [];
  let open: Open | null = null;
  for (const [index, line] of text.split('\n').entries()) {
    const words = line.trim().split(';');
    if (words[0] !== 'probe') continue;
    const read: Step = step(open, words);
    if ('problem' in read) return { problem: `line ${String(index + 1)}: ${read.problem}` };
    if ('table' in read) tables.push(read.table);
    open = 'open' in read ? read.open : null;
  }
  if (open !== null)
    return {
      problem: `the table of ${open.program} is cut off after ${String(open.rows.size)} rows: its end is missing. Run it again.`,
    };
  if (tables.length === 0)
    return { problem: 'there is no table of a probe in it. Save what docs/hardware/probe prints on the board.' };
  return { tables };
}

interface Open extends ProbeTable {
  readonly rows: Map<string, ProbeRow>;
}

type Step = { readonly open: Open } | { readonly table: ProbeTable } | { readonly problem: string };

/** Takes one line of a table. */
function step(open: Open | null, [, kind, ...words]: readonly string[]): Step {
  switch (kind) {
    case 'begin':
      return begin(open, words);
    case 'row':
      return open === null
        ? { problem: 'a row before the beginning of its table. Save the whole output.' }
        : row(open, words);
    case 'end':
      return open === null
        ? { problem: 'the end of a table without its beginning. Save the whole output.' }
        : end(open, words);
    default:
      return { problem: `"${kind ?? ''}" is not begin, row or end.` };
  }
}

function begin(open: Open | null, [program = '', version = '', ...machine]: readonly string[]): Step {
  if (open !== null)
    return { problem: `${program} begins before ${open.program} has ended. Run ${open.program} again.` };
  if (version !== VERSION)
    return {
      problem: `version ${version || '(none)'} of a probe's table; this is made for ${VERSION}. Take the programs that belong to it.`,
    };
  return { open: { program, machine: machine.join(';'), rows: new Map() } };
}

function row(open: Open, [unit = '', id = '', ...value]: readonly string[]): Step {
  const known = UNITS.find((one) => one === unit);
  if (known === undefined) return { problem: `"${unit}" is no unit. Known: ${UNITS.join(', ')}.` };
  if (id === '' || value.length === 0)
    return { problem: 'a row without id or value: a part of the line is lost. Run it again.' };
  if (open.rows.has(id)) return { problem: `"${id}" stands twice in ${open.program}.` };
  if (open.rows.size >= MOST_ROWS) return { problem: `more than ${String(MOST_ROWS)} rows in ${open.program}.` };
  const text = value.join(';');
  if (known !== 'text' && !Number.isFinite(text === '' ? NaN : Number(text)))
    return { problem: `"${text}" is no number of ${known}, for "${id}".` };
  open.rows.set(id, { unit: known, value: text });
  return { open };
}

function end(open: Open, [program = '', count = '']: readonly string[]): Step {
  if (program !== open.program) return { problem: `${program} ends, but ${open.program} has begun.` };
  if (Number(count) !== open.rows.size)
    return {
      problem: `${program} printed ${count} rows, and ${String(open.rows.size)} are here: lines are lost. Run it again.`,
    };
  return { table: open };
}
