import { defaultScene } from '#scene/scene';
import type { ProbeOptions } from './probe-arguments';
import { readLimited } from '../read-files';
import { supervise } from '../supervise';
import { refuse } from '../results-out';
import { createTerminal, type Terminal } from '../terminal';
import { compareTables, type Comparison, type Difference } from './compare';
import { keptIn, probes } from './programs';
import { parseProbe, type ProbeTable } from './table';
import { feelingInputs } from '#simulation/feeling';
import { soloRun } from '#simulation/run-setup';

/** Largest file that is read. Chosen: a hundred tables. */
const MOST_BYTES = 4_000_000;
/** Longest simulated time of one probe: those of sounds take a minute. */
const MOST_US = 300_000_000;

/**
 * Carries out `parcours probe compare`.
 *
 * @returns the exit code: 0 all rows are alike, 1 some are not, 2 bad usage or a bad file
 */
export async function compareProbes({ board, other }: ProbeOptions, terminal: Terminal): Promise<0 | 1 | 2> {
  const tables = readTables(board);
  if ('problem' in tables) return refuse(tables.problem, terminal);
  const others = other === null ? await runHere(tables.tables) : readTables(other);
  if ('problem' in others) return refuse(others.problem, terminal);
  const comparisons: Comparison[] = [];
  for (const table of tables.tables) {
    const same = others.tables.find(({ program }) => program === table.program);
    if (same === undefined) terminal.line(`${table.program}: not in ${other ?? 'the simulation: it needs two boards'}`);
    else comparisons.push(compareTables(table, same));
  }
  for (const comparison of comparisons) tell(comparison, terminal);
  return comparisons.every(({ differences }) => differences.length === 0) ? 0 : 1;
}

type Read = { readonly tables: readonly ProbeTable[] } | { readonly problem: string };

function readTables(path: string): Read {
  const read = readLimited(path, MOST_BYTES);
  if ('problem' in read) return read;
  const parsed = parseProbe(read.text);
  if ('problem' in parsed) return { problem: `${path}: ${parsed.problem}` };
  const unknown = parsed.tables.find(({ program }) => probes[program] === undefined && program !== 'radio');
  if (unknown !== undefined)
    return { problem: `${path}: "${unknown.program}" is no probe. Known: ${Object.keys(probes).join(', ')}, radio.` };
  return parsed;
}

/** Runs the programs of these tables on the simulation of their board. */
async function runHere(tables: readonly ProbeTable[]): Promise<Read> {
  const found: ProbeTable[] = [];
  for (const { program, machine } of tables) {
    const probe = probes[program];
    if (probe === undefined) continue; // radio needs a second board
    const board = /calliope/i.test(machine) ? 'calliope-mini-3' : 'microbit-v2';
    const files = { 'main.py': probe.source };
    const { robot } = probe;
    const inputs = feelingInputs([{ name: program, robot }]); // as `parcours run` has it
    const setup = soloRun({ scene: defaultScene(), files, robot, board, seed: 1, reality: 0, inputs });
    const silent = createTerminal({ write: () => undefined }, { write: () => undefined }, true);
    const task = {
      setup,
      untilUs: MOST_US,
      untilProgramEnds: true,
      untilVerdict: false,
      traceFile: null,
      logFile: null,
      tapeFile: null,
      replay: null,
    };
    const outcome = await supervise(task, silent);
    if (outcome.type !== 'ran') return { problem: `${program} could not run here: ${outcome.problem}` };
    const parsed = parseProbe(outcome.consoles[0] ?? '');
    if ('problem' in parsed) return { problem: `${program}, run here: ${parsed.problem}` };
    found.push(...parsed.tables);
  }
  return { tables: found };
}

function tell({ program, rows, differences }: Comparison, terminal: Terminal): void {
  terminal.line(`${program}: ${String(rows - differences.length)} of ${String(rows)} rows are alike`);
  for (const one of differences) terminal.line(lineOf(program, one));
}

/** `  im.copy()  board 63 us, here 41 us (−35 %)  → src/…` */
function lineOf(program: string, { id, unit, board, here, more }: Difference): string {
  const value = (text: string | null): string => {
    if (text === null) return 'nothing';
    return unit === 'text' ? text : `${text} ${unit}`;
  };
  const share = more === null ? '' : ` (${more < 0 ? '−' : '+'}${String(Math.round(100 * Math.abs(more)))} %)`;
  return `  ${id}   board: ${value(board)}   here: ${value(here)}${share}   → ${keptIn(program, id)}`;
}
