import type { Change } from './change';
import { isImport, plain, simple, stepOf } from './lines';
import { oppositeCodes } from './names';
import type { Program } from './program';

/** Statements that pupils forget, if the program has none like them. */
const USUAL = [
  ...['stop()', 'forward()', 'backward()', 'left()', 'right()', 'delay(1000)', 'delay(300)', 'delay(2000)'],
  ...['setSpeed(50)', 'setSpeed(40)', 'setSpeed(30)', 'setSpeed(100)', 'setSpeed(20)', 'delay(20)', 'break'],
];

/**
 * A line more, the likely ones first, without a look at whether the program is still one (`isRight`): one of the program once more, the opposite of
 * one, a usual one.
 */
export function missingChanges(program: Program): readonly Change[] {
  const statements = statementsOf(program);
  const pairs = pairsIn(program);
  const found = placesIn(program).flatMap((place) =>
    statements.map((statement) => ({ place, statement, likely: likelihood(pairs, place, statement) })),
  );
  return found
    .sort((one, other) => other.likely - one.likely || one.statement.rank - other.statement.rank)
    .map(({ place, statement }): Change => ({
      ...plain('missing', place.line),
      ...{ before: [], after: [`${place.indent}${statement.code}`] },
    }));
}

/** A place for a line more. */
interface Place {
  readonly line: number;
  readonly indent: string;
  /** The statements before and after it. */
  readonly after: string;
  readonly before: string;
}

/** A statement that may be missing; those of the program come first. */
interface Statement {
  readonly code: string;
  readonly rank: number;
}

function statementsOf(program: Program): readonly Statement[] {
  const own = simple(program).map(({ code }) => code);
  const opposite = own.flatMap(oppositeCodes);
  const unused = unusedIn(program);
  const ranked = [own, unused, opposite, USUAL].flatMap((codes, rank) => codes.map((code) => ({ code, rank })));
  const first = new Map<string, Statement>();
  for (const one of ranked) if (!first.has(one.code)) first.set(one.code, one);
  return [...first.values()].filter(({ code }) => !/^(return|global|pass)\b/.test(code));
}

/** Uses of what is defined and never used. */
function unusedIn(program: Program): readonly string[] {
  const names = program.nodes('VariableName', 'PropertyName').map((node) => program.textOf(node));
  const isOnce = (name: string): boolean => names.filter((one) => one === name).length === 1;
  const constants = [...new Set(names)].filter((name) => /^[A-Z][A-Z\d_]+$/.test(name) && isOnce(name));
  const functions = program
    .nodes('FunctionDefinition')
    .flatMap((node) => node.getChild('VariableName') ?? [])
    .map((node) => program.textOf(node))
    .filter(isOnce);
  const parameters = program
    .nodes('ParamList')
    .flatMap((node) => node.getChildren('VariableName'))
    .map((node) => program.textOf(node))
    .filter(isOnce);
  return [
    ...constants.map((name) => `delay(${name})`),
    ...[...functions, ...parameters].map((name) => `${name}()`),
    ...parameters.map((name) => `delay(${name})`),
  ];
}

/** Before each line of code, as far in as it, and at the end of each block as far in as the block. */
function placesIn({ lines }: Program): readonly Place[] {
  const coded = lines.filter(({ kind }) => kind !== 'other');
  const places = coded.flatMap((line, at): readonly Place[] => {
    if (isImport(line) || /^(elif|else)\b/.test(line.text.trim())) return [];
    const last = coded[at - 1];
    const beside = { line: line.number, after: last?.code ?? '', before: line.code };
    const here = { ...beside, indent: line.indent };
    const isDeeper = last !== undefined && last.kind === 'simple' && last.indent.length > line.indent.length;
    return isDeeper
      ? [
          { ...beside, indent: last.indent, before: '' },
          { ...here, after: '' },
        ]
      : [here];
  });
  const last = coded.at(-1);
  const inBlocks = coded.flatMap((line, at): readonly Place[] => {
    const before = coded[at - 1];
    const isBranch = /^(elif|else)\b/.test(line.text.trim()) && before?.kind === 'simple';
    return isBranch ? [{ line: line.number, indent: before.indent, after: before.code, before: '' }] : [];
  });
  const ends = last === undefined ? [] : [...new Set([last.indent, ''])];
  const number = (last?.number ?? 0) + 1;
  return [
    ...places,
    ...inBlocks,
    ...ends.map((indent) => ({ line: number, indent, after: last?.indent === indent ? last.code : '', before: '' })),
  ];
}

/** Statements that follow one another somewhere, with a line break between them. */
function pairsIn({ lines }: Program): ReadonlyMap<string, number> {
  const coded = lines.filter(({ kind }) => kind !== 'other');
  const pairs = new Map<string, number>();
  for (const [place, { code, indent, kind }] of coded.entries()) {
    const next = coded[place + 1];
    if (kind !== 'simple' || next?.kind !== 'simple' || next.indent !== indent) continue;
    for (const pair of [`${code}\n${next.code}`, `${shapeOf(code)}\n${shapeOf(next.code)}`])
      pairs.set(pair, (pairs.get(pair) ?? 0) + 1);
  }
  return pairs;
}

/** A statement without its values: `delay(650)` is like `delay(20)`, and `left()` like `right()`. */
const shapeOf = (code: string): string => {
  const role = roleOf(code);
  return role === '' ? code.replace(/\(.*\)$/, '()') : role;
};

type Role = 'drive' | 'wait' | 'stop' | '';

/** Says what a statement does with the robot. */
function roleOf(code: string): Role {
  if (/^(forward|backward|left|right|leftArc|rightArc|mot[LR]\.rotate|direction|arc)\(/.test(code)) return 'drive';
  if (/^(delay|sleep)\(/.test(code)) return 'wait';
  return /^stop\(/.test(code) ? 'stop' : '';
}

/** How well a statement fits to those before and after it: by what follows what elsewhere, and by what it does. */
function likelihood(pairs: ReadonlyMap<string, number>, { after, before }: Place, { code, rank }: Statement): number {
  const has = (one: string, other: string): boolean => pairs.has(`${one}\n${other}`);
  const exact = (has(after, code) ? 3 : 0) + (has(code, before) ? 3 : 0);
  const alike = has(shapeOf(after), shapeOf(code)) || has(shapeOf(code), shapeOf(before)) ? 2 : 0;
  const [one, role, other] = [roleOf(after), roleOf(code), roleOf(before)];
  const isWait = role === 'wait' && one === 'drive' && other !== 'wait';
  const isDrive = role === 'drive' && one !== 'drive' && other === 'wait';
  const lacks = isWait || isDrive ? 5 : 0;
  const isDoubled = code === after || code === before;
  return exact + alike + lacks + (isDoubled ? 1 : 0) + (rank === 1 ? 4 : 0) - rank;
}

/** `else` with one statement, after an `if` without it. */
export function elseChanges(program: Program): readonly Change[] {
  const step = stepOf(program);
  const codes = statementsOf(program).filter(({ code }) => /^[\w.]+\(.*\)$/.test(code));
  return program.nodes('IfStatement').flatMap((node) => {
    if (node.getChild('else') !== null) return [];
    const head = program.lines[program.lineAt(node.from) - 1];
    const end = program.lineAt(Math.max(node.from, program.source.text.slice(0, node.to).trimEnd().length - 1)) + 1;
    if (head === undefined) return [];
    return codes.map(({ code }) => ({
      ...plain('missing', end),
      ...{ before: [], after: [`${head.indent}else:`, `${head.indent}${step}${code}`] },
    }));
  });
}
