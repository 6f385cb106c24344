import type { Change } from './change';
import { isImport, plain, simple, stepOf } from './lines';
import { oppositeCodes } from './names';
import { numbersOf, type NumberPlace } from './numbers';
import { readProgram, type Program } from './program';

/** Statements that pupils forget, if the program has none like them. */
const USUAL = [
  ...['stop()', 'forward()', 'backward()', 'left()', 'right()', 'delay(1000)', 'delay(300)', 'delay(2000)'],
  ...['setSpeed(50)', 'setSpeed(40)', 'setSpeed(30)', 'setSpeed(100)', 'setSpeed(20)', 'delay(20)', 'break'],
];

/**
 * A line more, the likely ones first, without a look at whether the program is still one (`isRight`): one of the program once more, the opposite of
 * one, a usual one.
 *
 * @param suspects the lines from the most likely on
 */
export function missingChanges(program: Program, suspects: readonly number[] = []): readonly Change[] {
  const statements = statementsOf(program);
  const likelihood = likelihoodIn(program);
  const latest = new Set(suspects.slice(0, LATEST));
  const opposites = new Map(simple(program).map(({ code }) => [code, oppositeCodes(code)]));
  const found = placesIn(program).flatMap((place) =>
    statements.filter(hasMeaningAt(place)).map((statement) => {
      const isOpposite = [place.after, place.before].some((code) => opposites.get(code)?.includes(statement.code));
      return {
        place,
        statement,
        likely: likelihood(place, statement) + (isOpposite ? 3 : 0) + (latest.has(place.line) ? 2 : 0),
      };
    }),
  );
  return found
    .sort((one, other) => other.likely - one.likely || one.statement.rank - other.statement.rank)
    .map(({ place, statement }): Change => ({
      ...plain('missing', place.line),
      ...{ before: [], after: [`${place.indent}${statement.code}`] },
    }));
}

/** True of a statement that has a meaning at a place. */
const hasMeaningAt =
  ({ line, indent }: Place) =>
  ({ within }: Statement): boolean =>
    within === undefined || (line > within[0] && line <= within[1] + 1 && indent !== '');

/** The most uses of what is never used that are tried before other kinds. Chosen: the places in a function. */
const MOST_UNUSED = 12;

/** The uses of what is defined and never used: something is missing for sure, or too much. */
export function unusedChanges(program: Program, suspects: readonly number[]): readonly Change[] {
  const codes = new Set(unusedIn(program).map(({ code }) => code));
  if (codes.size === 0) return [];
  return missingChanges(program, suspects)
    .filter(({ after: [line = ''] }) => codes.has(line.trim()))
    .slice(0, MOST_UNUSED);
}

/** Number of the likeliest lines before which a line more is likelier. Chosen: what lacks lies shortly before the end of a run. */
const LATEST = 3;

/** Waits where one is surely missing: the robot is told to drive, and in the next line to stop or to drive otherwise. */
export function waitChanges(program: Program): readonly Change[] {
  const roleOf = rolesIn(program);
  const waits = statementsOf(program).filter(({ code }) => roleOf(code) === 'wait');
  const unused = waits.filter(({ rank }) => rank === UNUSED);
  return placesIn(program)
    .filter(({ after, before }) => roleOf(after) === 'drive' && ['drive', 'stop'].includes(roleOf(before)))
    .flatMap(({ line, indent }) =>
      [...new Set([...unused, ...waits])].map(({ code }) => ({
        ...plain('missing', line),
        ...{ before: [], after: [`${indent}${code}`] },
      })),
    );
}

/** The numbers of a line more, to be tried with others. */
export function numbersInLine(line: Change): readonly NumberPlace[] {
  const [text = ''] = line.after;
  const code = text.trim();
  return numbersOf(readProgram(code)).map((place) => ({
    ...place,
    line: line.line,
    to: (wanted) => {
      const other = place.to(wanted)?.after[0];
      return other === undefined ? null : { ...line, after: [text.replace(code, () => other)] };
    },
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
  /** The lines of the only function in which it has a meaning; left out: it has one everywhere. */
  readonly within?: readonly [from: number, to: number];
}

function statementsOf(program: Program): readonly Statement[] {
  // A constant has its value already.
  const own = simple(program).flatMap(({ code }) => (/^[A-Z][A-Z\d_]+ *=[^=]/.test(code) ? [] : [code]));
  const opposite = own.flatMap(oppositeCodes);
  const unused = unusedIn(program);
  const ranked = [own, [], opposite, USUAL].flatMap((codes, rank): readonly Statement[] =>
    rank === UNUSED ? unused : codes.map((code) => ({ code, rank })),
  );
  const first = new Map<string, Statement>();
  for (const one of ranked) if (!first.has(one.code)) first.set(one.code, one);
  return [...first.values()].filter(({ code }) => !/^(return|global|pass)\b/.test(code));
}

/** Rank of what is defined and never used. */
const UNUSED = 1;

/** Uses of what is defined and never used. */
function unusedIn(program: Program): readonly Statement[] {
  const names = program.nodes('VariableName', 'PropertyName').map((node) => program.textOf(node));
  const isOnce = (name: string): boolean => names.filter((one) => one === name).length === 1;
  const constants = [...new Set(names)].filter((name) => /^[A-Z][A-Z\d_]+$/.test(name) && isOnce(name));
  const functions = program.nodes('FunctionDefinition').map((node) => ({
    name: node.getChild('VariableName'),
    parameters: node.getChild('ParamList')?.getChildren('VariableName') ?? [],
    within: [program.lineAt(node.from), program.lineAt(node.to - 1)] as const,
  }));
  const called = functions.flatMap(({ name }) => (name === null ? [] : [program.textOf(name)])).filter(isOnce);
  const inFunctions = functions.flatMap(({ parameters, within }) =>
    parameters
      .map((node) => program.textOf(node))
      .filter(isOnce)
      .flatMap((name) => [`${name}()`, `delay(${name})`].map((code) => ({ code, rank: UNUSED, within }))),
  );
  const everywhere = [...constants.map((name) => `delay(${name})`), ...called.map((name) => `${name}()`)];
  return [...everywhere.map((code) => ({ code, rank: UNUSED })), ...inFunctions];
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

type Role = 'drive' | 'wait' | 'stop' | '';
type RoleOf = (code: string) => Role;

/** Says what the statements of a program do with the robot. A parameter that is called is a way to drive. */
function rolesIn(program: Program): RoleOf {
  const parameters = parametersOf(program);
  return (code) => {
    if (/^(forward|backward|left|right|leftArc|rightArc|mot[LR]\.rotate)\(/.test(code)) return 'drive';
    if (parameters.has(/^\w+(?=\()/.exec(code)?.[0] ?? '')) return 'drive';
    if (/^(delay|sleep)\(/.test(code)) return 'wait';
    return /^stop\(/.test(code) ? 'stop' : '';
  };
}

/** The names of all functions' parameters. */
const parametersOf = (program: Program): ReadonlySet<string> =>
  new Set(
    program
      .nodes('ParamList')
      .flatMap((node) => node.getChildren('VariableName'))
      .map((node) => program.textOf(node)),
  );

/** How well a statement fits to those before and after it: by what follows what elsewhere, and by what it does. */
function likelihoodIn(program: Program): (place: Place, statement: Statement) => number {
  const roleOf = rolesIn(program);
  /** A statement without its values: `delay(650)` is like `delay(20)`, and `left()` like `right()`. */
  const shapeOf = (code: string): string => roleOf(code) || code.replace(/\(.*\)$/, '()');
  const pairs = pairsIn(program, shapeOf);
  const moves = movesIn(program, roleOf);
  const isMove = (code: string): boolean => moves.has(/^\w+(?=\()/.exec(code)?.[0] ?? '');
  const has = (one: string, other: string): boolean => pairs.has(`${one}\n${other}`);
  return ({ after, before }, { code, rank }) => {
    const exact = (has(after, code) ? 3 : 0) + (has(code, before) ? 3 : 0);
    const [isAlikeAfter, isAlikeBefore] = [has(shapeOf(after), shapeOf(code)), has(shapeOf(code), shapeOf(before))];
    const alike = isAlikeAfter && isAlikeBefore ? 4 : isAlikeAfter || isAlikeBefore ? 2 : 0;
    const [one, role, other] = [roleOf(after), roleOf(code), roleOf(before)];
    const isWait = role === 'wait' && one === 'drive' && other !== 'wait';
    const isDrive = role === 'drive' && one !== 'drive' && other === 'wait';
    const lacks = isWait || isDrive ? 5 : 0;
    const isDoubled = code === after || code === before;
    // Among moves of its own a program lacks a move rather than a part of one.
    const amongMoves = isMove(code) && (isMove(after) || isMove(before)) ? 4 : 0;
    return exact + alike + lacks + amongMoves + (isDoubled ? 1 : 0) + (rank === UNUSED ? 4 : 0) - rank;
  };
}

/** The names of the program's own functions that drive. */
function movesIn(program: Program, roleOf: RoleOf): ReadonlySet<string> {
  const driving = program.nodes('FunctionDefinition').filter((node) => {
    const [from, to] = [program.lineAt(node.from), program.lineAt(node.to - 1)];
    return program.lines.slice(from, to).some(({ code }) => roleOf(code) === 'drive');
  });
  return new Set(driving.map((node) => node.getChild('VariableName')).map((name) => name && program.textOf(name) || '')); // prettier-ignore
}

/** Statements that follow one another somewhere, with a line break between them, as they are and by their shapes. */
function pairsIn({ lines }: Program, shapeOf: (code: string) => string): ReadonlySet<string> {
  const coded = lines.filter(({ kind }) => kind !== 'other');
  const pairs = new Set<string>();
  for (const [place, { code, indent, kind }] of coded.entries()) {
    const next = coded[place + 1];
    if (kind !== 'simple' || next?.kind !== 'simple' || next.indent !== indent) continue;
    pairs.add(`${code}\n${next.code}`).add(`${shapeOf(code)}\n${shapeOf(next.code)}`);
  }
  return pairs;
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
