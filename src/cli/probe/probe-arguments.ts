import { command, type Problem } from '../commands/about';

/** The request to `parcours probe compare`. */
export interface ProbeOptions {
  /** The saved output of a board. */
  readonly board: string;
  /** The table of another board; `null`: the same programs are run here. */
  readonly other: string | null;
}

export const probeCompareAbout = command({
  summary: 'compares what a real board printed with the simulated one',
  usage: ['BOARD.csv [OTHER.csv]'],
  text: [
    "What a real board printed under the programs of docs/hardware/probe, beside what the simulated one prints, or beside another board's. The rows that differ are named.",
  ],
  words: [
    { name: 'BOARD.csv', path: 'reads' },
    { name: 'OTHER.csv', path: 'reads' },
  ],
  options: {},
  exits: { 0: 'all rows are alike', 1: 'some rows differ', 2: 'something is wrong with the command or a file' },
  examples: ['probe compare board.csv'],
  read: readProbe,
});

/** Reads the words after `parcours probe compare`. */
function readProbe([board, other, ...more]: readonly string[]): ProbeOptions | Problem {
  if (board === undefined) return { problem: 'Which output of a board? For example: parcours probe compare board.csv' };
  if (more[0] !== undefined) return { problem: `Two tables at most: what is "${more[0]}"?` };
  return { board, other: other ?? null };
}
