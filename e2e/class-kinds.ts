/**
 * A class with a hand-in of every kind, and what a class's results say as the line of `--json`. Vite's runner loads it
 * (`kindsInNode`): Playwright's own loader takes none of the words that it needs.
 */
import { check } from '../src/check/check';
import { projectOfHandIn, type Said, type SaidRemark } from '../src/check/hand-in/hand-in';
import { handInOf } from '../src/check/hand-in/read-hand-in';
import { classResult, type NamedResult } from '../src/check/report/class-result';
import { jsonOf } from '../src/check/report/texts';
import { firmware, sceneWith, targetAt } from '../src/check/testing/tasks';
import { taskOf } from '../src/check/task/read-task';
import { withoutSecrets } from '../src/check/task/write-task';
import type { ClassTask } from '../src/check/task/task';
import { linkOf } from '../src/project/link/link';
import { projectToText } from '../src/project/file';
import type { Project } from '../src/project/project';

const IMPORTS = 'from mbrobot import *\n';
const START = `${IMPORTS}forward()\n`;
const RIGHT = `${START}while getDistance() > 15:\n    delay(50)\nstop()\n`;
const wall = { type: 'wall', id: 'w', from: [900, 200], to: [900, 700], thickness: 10 } as const;
const line = { type: 'stroke', id: 's', points: [[100, 100], [400, 100]], width: 20, color: 'black' } as const; // prettier-ignore

/** Halt before the wall, wherever robot and wall are. */
const whole: Project = {
  files: [{ name: 'main.py', text: START }],
  scene: sceneWith([targetAt(760, 450), wall]),
  course: null,
  task: {
    version: 1,
    id: 'wall',
    checks: [
      ...[{ type: 'goals' }, { type: 'stop', seconds: 1 }, { type: 'touches', most: 0 }, { type: 'loop', points: 2 }],
      ...[{ type: 'lines', most: 6, needed: false }],
    ],
    worlds: [
      { id: 'visible', hidden: false },
      { id: '2', start: { at: [400, 450] } },
      { id: '3', seed: 3, reality: 0.5 },
    ],
    ...{ seconds: 8, stars: [5, 6], locks: { lines: [1] } },
  },
};

interface Kind {
  readonly name: string;
  readonly text: string;
  readonly remarks?: readonly SaidRemark[];
  readonly scene?: Project['scene'];
  /** False statements of the hand-in. */
  readonly lies?: Partial<Said>;
  readonly isCut?: boolean;
}

/** Right, wrong, by heart, endless, with errors, helped, on another course, copied, damaged, of another task. */
const kinds: readonly Kind[] = [
  { name: 'Ada', text: RIGHT },
  { name: 'Ben', text: `${START}for i in range(32):\n    delay(100)\nstop()\n` },
  { name: 'Cem', text: `${START}while getDistance() > 50:\n    delay(50)\nstop()\n` },
  { name: 'Dora', text: `${IMPORTS}while True:\n    pass\n` },
  { name: 'Emil', text: `${IMPORTS}while True:\n    print('Hallo')\n` },
  { name: 'Finn', text: `${IMPORTS}all = []\nwhile True:\n    all.append(bytearray(1000))\n` },
  { name: 'Gül', text: `${START}while getDistance() > 15\n    delay(50)\n` },
  { name: 'Hana', text: `${IMPORTS}while True:\n    delay(100)\n`, remarks: ['hand'] },
  { name: 'Ivo', text: RIGHT.replace('15', '14'), scene: sceneWith([targetAt(760, 450), wall, line]) },
  { name: 'Zoë 🤖 «7b»', text: RIGHT.replace('while', '# so geht es\n\nwhile') },
  { name: 'Kai', text: RIGHT, isCut: true },
  { name: 'Lea', text: RIGHT.replace('15', '13'), lies: { task: 'another' } },
  { name: 'Max', text: START },
  { name: 'Nina', text: RIGHT.replace(IMPORTS, 'from mbrobot import forward, getDistance, delay, stop\n') },
  { name: '', text: RIGHT.replace('15', '50'), lies: { alias: 'Ada', verdict: 'passed', hash: '0123456789abcdef' } },
];

/** The task as its teacher has it, and the e-mail with what was handed in, as the pupils' pages write it. */
export async function aClass(): Promise<{ readonly task: string; readonly work: string; readonly mail: string }> {
  const lines: string[] = [];
  for (const kind of kinds) lines.push(`${kind.name}${kind.name === '' ? '\n' : ': '}${await linkTo(kind)}`);
  const task = projectToText(whole);
  const project: unknown = JSON.parse(task);
  return {
    task,
    work: JSON.stringify({ version: 1, project, open: 'main.py', previous: [] }),
    mail: `Guten Tag, hier sind alle.\n\n${lines.join('\n')}\n`,
  };
}

async function linkTo({ name, text, scene, remarks = [], lies, isCut = false }: Kind): Promise<string> {
  const theirs = withoutSecrets({ ...whole, files: [{ name: 'main.py', text }], scene: scene ?? whole.scene });
  const read = handInOf(theirs);
  if ('problem' in read) throw new Error(read.problem);
  const [run] = (await check(taskIn(theirs), read.handIn, { firmware: firmware() })).worlds;
  const verdict = run?.passed === true ? 'passed' : 'failed';
  const said: Said = { task: 'wall', alias: name, verdict, tries: 2, hash: run?.hash ?? '', remarks, ...lies };
  const made = linkOf(projectOfHandIn({ project: theirs, hasCourse: true, said }), {
    courses: () => null,
    program: true,
  });
  const link = `https://example.org/#${made?.fragment ?? ''}`;
  return isCut ? link.slice(0, -9) : link;
}

function taskIn(project: Project): ClassTask {
  const read = taskOf(project);
  if ('task' in read) return read.task;
  throw new Error(read.problem);
}

/** The line of `--json` of what a page has found. */
export const lineOf = (rows: readonly NamedResult[]): string =>
  jsonOf(classResult('wall', rows, 'de'), taskIn(whole), 'de');
