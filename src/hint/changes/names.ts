import type { Change } from './change';
import { readProgram, replaced, type Program } from './program';

/** Words that mean opposites, in names of the robots' libraries and in those that pupils give. */
const OPPOSITES: readonly (readonly [string, string])[] = [
  ...([['left', 'right'], ['forward', 'backward'], ['forwards', 'backwards'], ['min', 'max'], ['on', 'off']] as const),
  ...([['open', 'closed'], ['open', 'close'], ['up', 'down'], ['near', 'far'], ['front', 'back'], ['l', 'r']] as const),
  ...([['start', 'stop'], ['fast', 'slow'], ['first', 'last'], ['high', 'low'], ['dark', 'bright']] as const),
  ...([['links', 'rechts'], ['vor', 'zurück'], ['offen', 'zu'], ['nah', 'fern'], ['hell', 'dunkel']] as const),
  ...([['gauche', 'droite'], ['avancer', 'reculer'], ['avant', 'arrière'], ['clair', 'sombre']] as const),
  ...([['sinistra', 'destra'], ['avanti', 'indietro'], ['chiaro', 'scuro'], ['vicino', 'lontano']] as const),
  ...([['black', 'white'], ['schwarz', 'weiss'], ['noir', 'blanc'], ['nero', 'bianco']] as const),
]; // prettier-ignore

/** Names of the robots' libraries that stand for one another, besides opposites. */
const RELATED: readonly (readonly string[])[] = [
  ['forward', 'stop', 'backward', 'left', 'right'],
  ['leftArc', 'left', 'rightArc', 'right'],
  ['irL1', 'irL2', 'irM'],
  ['irR1', 'irR2', 'irM'],
];

/** Names of the robots' libraries that pupils drive with: a slip of the pen is near one of them. */
const LIBRARY = [
  ...['forward', 'backward', 'left', 'right', 'stop', 'leftArc', 'rightArc', 'setSpeed', 'delay', 'sleep'],
  ...['irLeft', 'irRight', 'irL1', 'irR1', 'irL2', 'irR2', 'irM', 'motL', 'motR', 'getDistance', 'setLED', 'setServo'],
  ...['read_digital', 'rotate', 'irLeftValue', 'irRightValue', 'fillRGB', 'setAlarm', 'range', 'print'],
];

/** The robots' libraries, and others that are on the boards. */
const ROBOTS = [
  ...['mbrobot', 'mbrobot_plus', 'mbrobot_plusV2', 'mbrobot_plusV3', 'callibot', 'callimk', 'mbbitbot', 'cutebot'],
  ...['mbrobotmot', 'callibotmot'],
];
const MODULES = [
  ...ROBOTS,
  'microbit',
  'calliopemini',
  'mbalarm',
  'mbled',
  'cbalarm',
  'time',
  'utime',
  'random',
  'math',
];

/** The names with an opposite meaning: `irLeft` → `irRight`. */
export function oppositesOf(name: string): readonly string[] {
  const parts = partsOf(name);
  const found: string[] = [];
  for (const [place, part] of parts.entries())
    for (const pair of OPPOSITES)
      for (const [one, other] of [pair, [pair[1], pair[0]] as const])
        if (part.toLowerCase() === one && (one.length > 1 || parts.length > 1))
          found.push([...parts.slice(0, place), inCaseOf(part, other), ...parts.slice(place + 1)].join(''));
  return [...new Set(found)];
}

/** The words of a name: `irLeft_2` → `ir`, `Left`, `_`, `2`. The oldest browsers' expressions do not look behind. */
const partsOf = (name: string): readonly string[] =>
  name
    .replace(/[a-z](?=[A-Z])|[A-Za-z](?=\d)|_/g, (end) => (end === '_' ? ' _ ' : `${end} `))
    .split(' ')
    .filter((part) => part !== '');

const inCaseOf = (model: string, word: string): string =>
  model === model.toUpperCase()
    ? word.toUpperCase()
    : /^[A-Z]/.test(model)
      ? word.charAt(0).toUpperCase() + word.slice(1)
      : word;

/** Other names in the place of those of a program: opposites, what a slip of the pen may have been, its other constants. */
export function nameChanges(program: Program): readonly Change[] {
  const own = program.nodes('VariableName', 'PropertyName').map((node) => program.textOf(node));
  const known = new Set([...own, ...LIBRARY]);
  return [
    ...moduleChanges(program, (name) => (MODULES.includes(name) ? [] : MODULES.filter((one) => isNear(name, one)))),
    ...renamed(program, (name) => [
      ...oppositesOf(name).filter((one) => known.has(one)),
      ...(LIBRARY.includes(name) ? [] : [...LIBRARY, ...own].filter((one) => isNear(name, one))),
      ...constantsLike(name, own),
    ]),
  ];
}

/** Other modules in the place of those that a program imports from. */
const moduleChanges = (program: Program, others: (name: string) => readonly string[]): readonly Change[] =>
  program.nodes('ImportStatement').flatMap((node) => {
    const name = node.getChild('VariableName');
    if (name === null) return [];
    const { from, to } = name;
    return others(program.textOf(name)).flatMap((by) => replaced(program, 'name', [{ from, to, by }]) ?? []);
  });

/** Names in the place of others with which they are less often confused: they do another thing, or stand in the line already. */
export const relatedNameChanges = (program: Program): readonly Change[] => [
  ...moduleChanges(program, (name) => (/robot|bot|calli|mk/i.test(name) ? ROBOTS.filter((one) => one !== name) : [])),
  ...renamed(program, (name) => RELATED.filter((names) => names.includes(name)).flat()),
  ...allRenamed(program, oppositesOf),
];

/** Those of `allRenamed` by which no name comes twice into a line. */
const renamed: typeof allRenamed = (program, others) =>
  allRenamed(program, others).filter(({ before, after }) => wordsTwice(after) <= wordsTwice(before));

/** How often a name stands in a line once more. */
function wordsTwice([line = '']: readonly string[]): number {
  const words = line.match(/[A-Za-z_]\w*/g) ?? [];
  return words.length - new Set(words).size;
}

const allRenamed = (program: Program, others: (name: string) => readonly string[]): readonly Change[] =>
  usedNames(program).flatMap((node) => {
    const name = program.textOf(node);
    const names = [...new Set(others(name))].filter((one) => one !== name);
    return names.flatMap((by) => replaced(program, 'name', [{ from: node.from, to: node.to, by }]) ?? []);
  });

/** Those that are used, not those that are defined: an opposite definition is the same program. */
function usedNames(program: Program) {
  return program.nodes('VariableName', 'PropertyName').filter((node) => {
    const { parent } = node;
    const isDefined =
      parent?.name === 'ParamList' ||
      (parent?.name === 'FunctionDefinition' && parent.getChild('VariableName')?.from === node.from) ||
      parent?.name === 'ImportStatement';
    return !isDefined;
  });
}

/** The other constants of a program in the place of one. */
const constantsLike = (name: string, own: readonly string[]): readonly string[] =>
  /^[A-Z][A-Z\d_]*$/.test(name) ? [...new Set(own)].filter((one) => /^[A-Z][A-Z\d_]*$/.test(one)) : [];

/** True if the names differ by a slip: one letter more, less or another, two exchanged, or only by their case. */
function isNear(one: string, other: string): boolean {
  if (one === other || Math.min(one.length, other.length) < LEAST) return false;
  if (one.toLowerCase() === other.toLowerCase()) return true;
  let start = 0;
  while (start < Math.min(one.length, other.length) && one[start] === other[start]) start += 1;
  let end = 0;
  while (end < Math.min(one.length, other.length) - start && one.at(-1 - end) === other.at(-1 - end)) end += 1;
  const [a, b] = [one.slice(start, one.length - end), other.slice(start, other.length - end)];
  return Math.max(a.length, b.length) <= 1 || (a.length === 2 && a === (b[1] ?? '') + (b[0] ?? ''));
}

/** Chosen: shorter names differ by a letter without being slips. */
const LEAST = 4;

/** The simple statements of a program with the opposites of each: `left()` → `right()`. */
export const oppositeCodes = (code: string): readonly string[] => {
  const all = code.replace(/[A-Za-z_]\w*/g, (name) => oppositesOf(name)[0] ?? name);
  return [...nameChanges(readProgram(code)).flatMap(({ after }) => after), all].filter((one) => one !== code);
};
