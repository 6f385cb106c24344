import { extname } from 'node:path';
import { hexBoards, type HexBoard } from '#hex/firmware';
import { leagueRules, type LeagueRules } from '#scene/league/league';
import { rulesOf } from '../run-arguments';
import { command, type Given, type Options, type Problem } from '../commands/about';
import { notKnown } from '../commands/nearest';

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
  /** The rules of a scored line; `null`: the course's own. */
  readonly rules: LeagueRules | null;
  /** Hexes with the MicroPython for a hex. */
  readonly firmware: readonly string[];
  /** The board of a hex; `null`: all that the firmware is for. */
  readonly board: HexBoard | null;
  /** Further files for a hex. */
  readonly files: readonly string[];
}

/** Options that only a hex has. */
const forHex = ['firmware', 'board', 'file'] as const;

const options = {
  out: {
    value: 'PATH',
    path: 'writes',
    help: 'where it goes (default: here); .json: a project, .py: a program, .hex: a hex, folder/: all its files',
  },
  as: { value: 'FORM', choices: forms, help: 'what it shall be; webtigerpython is a link for it' },
  rules: {
    value: 'NAME',
    choices: leagueRules,
    help: 'for a rescue line: the rules by which its points are counted; default: those of the course, for a map line-2025',
  },
  firmware: {
    value: 'FILE.hex',
    path: 'reads',
    isRepeated: true,
    help: 'for a hex: any hex of MicroPython for the board, cleaned of its files; several, or a universal one, give a universal hex',
  },
  board: { value: 'NAME', choices: hexBoards, help: 'for a hex: one of its boards alone' },
  file: { value: 'DRIVER.py', path: 'reads', isRepeated: true, help: 'for a hex: a further file on the board' },
  json: { help: 'one line: kind, program, robot, board, scene and notes' },
} as const satisfies Options;

export const convertAbout = command({
  summary: 'turns one form of work into another, or says what it is',
  usage: ['IN [--as FORM] [--out PATH] [options]', 'IN --as hex --firmware FILE.hex [--out PATH] [options]'],
  text: [
    'IN is a program (.py), a project or a course, a hex of a micro:bit or Calliope mini, a link of Parcours or of WebTigerPython (also in a file), a course file of WebTigerPython, a map of the editor for RoboCup Junior Rescue Line, the id of a ready course. What cannot be taken over is told.',
  ],
  words: [{ name: 'IN', choices: 'courses', path: 'reads' }],
  options,
  exits: {
    0: 'done',
    2: 'it is none of these, or cannot be had in that form, such as a hex that has too little room: then the missing bytes are told',
  },
  examples: [
    'convert "https://webtigerpython.ethz.ch/#?code=…" --out anna.json',
    'convert MAP.json --as course --rules line-entry-2026 --out line.json',
    'convert main.py --as hex --firmware my-board.hex --out main.hex',
  ],
  read: readConvert,
});

type ConvertGiven = Given<typeof options>;

/** Reads the words after `parcours convert`. */
function readConvert([input, ...more]: readonly string[], given: ConvertGiven): ConvertOptions | Problem {
  if (input === undefined)
    return { problem: `What shall be converted? For example: parcours ${convertAbout.examples[0] ?? ''}` };
  if (more[0] !== undefined) return { problem: `One thing at a time: what is "${more[0]}"?` };
  const [wanted, out] = [given.last('as'), given.last('out')];
  const as = wanted === null ? formOf(out) : (forms.find((form) => form === wanted) ?? null);
  if (as === null && wanted !== null) return { problem: notKnown('as', wanted, forms) };
  if (as === null && out !== null)
    return { problem: `--out: ${out} does not end in .json (a project), .py (a program), .hex (for a board) or / (a folder). Say what it shall be: --as ${forms.join('|')}.` }; // prettier-ignore
  if (as === 'files' && out === null) return { problem: '--as files: say which folder takes them: --out folder/' };
  const hex = hexOf(as, given);
  if ('problem' in hex) return hex;
  const rules = rulesOf(given.last('rules'));
  return 'problem' in rules ? rules : { input, as, out, json: given.has('json'), ...rules, ...hex };
}

/** The options of a hex, or what is wrong with them. */
function hexOf(as: Form | null, given: ConvertGiven): Pick<ConvertOptions, 'firmware' | 'board' | 'files'> | Problem {
  const [firmware, files] = [given.all('firmware'), given.all('file')];
  const strange = as === 'hex' ? undefined : forHex.find((name) => given.has(name));
  if (strange !== undefined) return { problem: `--${strange} is for a hex only: --as hex --firmware FILE.hex` };
  if (as === 'hex' && firmware.length === 0)
    return { problem: 'A hex needs MicroPython. Give any hex that a Python editor saved for this board: --firmware FILE.hex' }; // prettier-ignore
  const wanted = given.last('board');
  const board = hexBoards.find((id) => id === wanted) ?? null;
  if (board === null && wanted !== null) return { problem: notKnown('board', wanted, hexBoards) };
  return { firmware, board, files };
}

/** The form that the ending of a file says. */
function formOf(out: string | null): Form | null {
  if (out === null) return null;
  if (/[/\\]$/.test(out)) return 'files';
  const endings: Readonly<Record<string, Form>> = { '.json': 'project', '.py': 'program', '.hex': 'hex' };
  return endings[extname(out).toLowerCase()] ?? null;
}
