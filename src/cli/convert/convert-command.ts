import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { withLinesBack } from '#intake/lines-back';
import { hardwareOf } from '#intake/webtigerpython';
import { filesByName, MAIN } from '#project/project';
import { scoredBy } from '#rescue-line/scored-by';
import type { Scene } from '#scene/scene';
import { serializeScene } from '#scene/serialize';
import type { Hardware } from '#simulation/hardware';
import { NO_ROBOT } from '#simulation/run-setup';
import { isSameFile, writeProblem } from '../outputs';
import { shortened } from '../read-work';
import { reasonOf } from '../reason-of';
import { refuse } from '../results-out';
import type { Terminal } from '../terminal';
import { writeOutput } from '../write-output';
import type { ConvertOptions } from './convert-arguments';
import type { Made } from './made';
import { makeForm } from './make-form';
import { readInput, type Input } from './read-input';

/**
 * Carries out `parcours convert`.
 *
 * @param write puts text on stdout as it is
 * @returns the exit code: 0 success, 2 something that cannot be read, made or written
 */
export async function convert(
  options: ConvertOptions,
  terminal: Terminal,
  write: (text: string) => void,
): Promise<0 | 2> {
  const { input: word, as, out, json } = options;
  const unwritable = out === null || as === 'files' ? null : writeProblem({ option: '--out', path: out });
  if (unwritable !== null) return refuse(unwritable, terminal);
  const read = await readInput(word);
  if ('problem' in read) return refuse(read.problem, terminal);
  const input = withRules(read, options.rules);
  const made = as === null ? null : await makeForm(input, as, options);
  if (made !== null && 'problem' in made) return refuse(`${shortened(word)}: ${made.problem}`, terminal);
  if (made !== null && out !== null) {
    const failed = writeOut(out, made, word);
    if (failed !== null) return refuse(`--out: ${out}: ${failed}`, terminal);
  }
  const hardware = hardwareOf(input.work);
  const unfit = 'problem' in hardware ? [`It cannot run as it is: ${hardware.problem}`] : [];
  const notes = [...input.notes, ...(made?.notes ?? []), ...unfit];
  if (json) {
    const text = made !== null && out === null ? { text: made.text } : {};
    const asItCame = input.rewritten?.length ? ['The program stands here as it came.'] : [];
    terminal.line(JSON.stringify({ ...asJson(input, hardware), notes: [...notes, ...asItCame], ...text }));
    return 0;
  }
  for (const note of notes) terminal.message(`parcours: ${note}`);
  if (made === null) for (const line of summaryOf(input, hardware)) terminal.line(line);
  else if (out === null) write(made.text);
  return 0;
}

const withRules = (input: Input, rules: ConvertOptions['rules']): Input =>
  rules === null || input.work.scene === null
    ? input
    : { ...input, work: { ...input.work, scene: scoredBy(input.work.scene, rules) } };

/** @returns why it was not written; `null`: it was */
function writeOut(out: string, { text, files }: Made, word: string): string | null {
  const all = files?.map((file) => [join(out, file.name), file.text] as const) ?? [[out, text] as const];
  if (all.some(([path]) => isSameFile(path, word))) return 'is the file that is read. Choose another name.';
  try {
    if (files !== undefined) mkdirSync(out, { recursive: true });
    for (const [path, content] of all) writeOutput(path, content);
    return null;
  } catch (error) {
    return reasonOf(error);
  }
}

type Chosen = Hardware | { readonly problem: string };

/** The ids of robot and board; `null`: there is none. */
const idsOf = (hardware: Chosen): { readonly robot: string | null; readonly board: string | null } =>
  'problem' in hardware
    ? { robot: null, board: null }
    : { robot: hardware.robot?.id ?? null, board: hardware.board.id };

const asJson = ({ kind, hex, work: { files, scene }, rewritten = [] }: Input, hardware: Chosen) => ({
  kind,
  ...(hex && { made: hex.made, boards: hex.boards }),
  program:
    files.length === 0 && kind === 'course'
      ? { [MAIN]: '' }
      : filesByName(files.map((file) => withLinesBack(file, rewritten))),
  ...idsOf(hardware),
  scene: scene === null ? null : (JSON.parse(serializeScene(scene)) as unknown),
});

/** Lines for people. */
function summaryOf({ kind, hex, work: { files, scene } }: Input, hardware: Chosen): readonly string[] {
  const linesOf = (text: string): number => text.replace(/\n$/, '').split('\n').length;
  const programs = files.map(({ name, text }) => `${name} (${linesOf(text)} lines)`);
  const { robot, board } = idsOf(hardware);
  return [
    hex === undefined
      ? `This is a ${kind}.`
      : `This is a hex (${hex.made})${hex.boards.length === 0 ? '' : ` for ${hex.boards.join(', ')}`}.`,
    ...(programs.length > 0 ? [`Program: ${programs.join(', ')}`] : []),
    ...(board === null ? [] : [`Hardware: robot ${robot ?? NO_ROBOT}, board ${board}`]),
    ...(scene === null ? [] : [`Course: ${courseText(scene)}`]),
    'Say --as project, course, program, files, hex, link or webtigerpython to get it in that form, and --out FILE to save it.',
  ];
}

function courseText({ name, size, objects }: Scene): string {
  const counts = new Map<string, number>();
  for (const { type } of objects) counts.set(type, (counts.get(type) ?? 0) + 1);
  const things = Array.from(counts, ([type, count]) => `${count} × ${type}`);
  return [...(name === '' ? [] : [name]), `${size[0]} × ${size[1]} mm`, ...things].join(', ');
}
