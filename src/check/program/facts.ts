import { argumentsOf, attributeOf } from '#python/expressions';
import { importsIn } from '#python/imports';
import { namesOf } from '#python/scopes';
import { readPython, textOf, type PythonText, type SyntaxNode } from '#python/tree';
import type { Fact } from '../task/task';
import { isTooDeep } from './depth';

/** Names of files → texts. */
export type Files = Readonly<Record<string, string>>;

/** A fact of a program, or where it does not hold. */
export interface FactFound {
  readonly holds: boolean;
  /** The value found instead: the number of lines, the longest wait in ms; `null`: there is none. */
  readonly found: number | null;
  /** The line in `file` where it does not hold; `null`: nowhere in particular. */
  readonly line: number | null;
}

/** Decides a fact about a program from its syntax tree. Code with mistakes is read as far as possible. */
export function findFact(fact: Fact, files: Files): FactFound {
  const programs = programsIn(files);
  switch (fact.type) {
    case 'loop':
      return found(programs.some((source) => anyNode(source, isLoop)));
    case 'calls':
      return found(programs.some((source) => callsIn(source, fact.name)));
    case 'lines': {
      const count = programs.reduce((sum, source) => sum + codeLines(source), 0);
      return { holds: count <= fact.most, found: count, line: null };
    }
    case 'delay':
      return delaysWithin(programs, fact.most);
  }
}

/** True if there is no code at all. */
export const isEmpty = (files: Files): boolean => programsIn(files).every((source) => codeLines(source) === 0);

const found = (holds: boolean): FactFound => ({ holds, found: null, line: null });

const programsIn = (files: Files): readonly PythonText[] =>
  Object.entries(files)
    .filter(([name]) => name.endsWith('.py'))
    .map(([, text]) => readPython(text))
    .map((source) => (isTooDeep(source) ? readPython('') : source));

function anyNode(source: PythonText, isIt: (node: SyntaxNode) => boolean): boolean {
  let isFound = false;
  source.tree.iterate({
    enter: (ref) => {
      isFound ||= isIt(ref.node);
      return !isFound;
    },
  });
  return isFound;
}

const isLoop = ({ name }: SyntaxNode): boolean => name === 'ForStatement' || name === 'WhileStatement';

/** True if it is called: `irLeft` by `irLeft.read_digital()`, `display.show` by itself, `show` by `display.show()`. */
function callsIn(source: PythonText, name: string): boolean {
  const others = aliasesIn(source);
  return anyNode(source, (node) => {
    if (node.name !== 'CallExpression' || node.firstChild === null) return false;
    const path = fullPath(source, node.firstChild, others);
    const wanted = name.split('.');
    return path.some((_, at) => wanted.every((part, place) => path[at + place] === part));
  });
}

/** The names of `a.b.c`; parts of it other than names are empty. */
function pathOf(source: PythonText, node: SyntaxNode): readonly string[] {
  if (node.name === 'VariableName') return [textOf(source, node)];
  const attribute = attributeOf(node);
  if (attribute === null) return [''];
  return [...pathOf(source, attribute.owner), textOf(source, attribute.property)];
}

type Aliases = ReadonlyMap<string, readonly string[]>;

/** The names of `a.b.c`, with `a` resolved. */
function fullPath(source: PythonText, node: SyntaxNode, others: Aliases): readonly string[] {
  const [first = '', ...rest] = pathOf(source, node);
  return [...(others.get(first) ?? [first]), ...rest];
}

/**
 * The names bound by imports and assignments: `left` by `from mbrobot import irLeft as left`, `wait` by `wait =
 * microbit.sleep`.
 */
function aliasesIn(source: PythonText): Aliases {
  const aliases = new Map<string, readonly string[]>();
  source.tree.iterate({
    enter: (ref) => {
      if (ref.name !== 'ImportStatement') return;
      for (const { module, symbol, nameNode } of importsIn(source, ref.node))
        if (nameNode !== null && symbol !== '*') aliases.set(textOf(source, nameNode), [symbol ?? module]);
    },
  });
  for (const [name, bound] of namesOf(source).bindings) {
    const [value] = bound.length === 1 ? bound : [];
    if (value?.kind !== 'value' || value.of !== 'itself') continue;
    const path = fullPath(source, value.node, aliases);
    if (path.every((part) => part !== '')) aliases.set(name, path);
  }
  return aliases;
}

/** Lines with code on them: neither empty nor a comment alone; a text over several lines counts with each. */
function codeLines({ text, tree }: PythonText): number {
  const lines = new Set<number>();
  const lineAt = lineFinder(text);
  tree.iterate({
    enter: ({ node, name, from, to }) => {
      if (name === 'Comment') return;
      if (node.firstChild !== null || from === to || text.slice(from, to).trim() === '') return;
      for (let line = lineAt(from); line <= lineAt(to - 1); line += 1) lines.add(line);
    },
  });
  return lines.size;
}

/** Returns a function from a place to its line, from 1. */
function lineFinder(text: string): (place: number) => number {
  const starts = [0];
  for (let at = text.indexOf('\n'); at >= 0; at = text.indexOf('\n', at + 1)) starts.push(at + 1);
  return (place) => {
    let [low, high] = [0, starts.length];
    while (low < high) {
      const middle = (low + high) >> 1;
      if ((starts[middle] ?? 0) <= place) low = middle + 1;
      else high = middle;
    }
    return low;
  };
}

/** Milliseconds in the unit of each call that waits. */
const WAITS: Readonly<Record<string, number>> = { delay: 1, sleep: 1, sleep_ms: 1, sleep_us: 0.001 };
/** Modules whose `sleep` counts seconds. */
const IN_SECONDS = ['time', 'utime'];

function delaysWithin(programs: readonly PythonText[], most: number): FactFound {
  let longest: { readonly ms: number; readonly line: number } = { ms: 0, line: 0 };
  for (const source of programs) {
    const secondsHere = sleepsInSeconds(source);
    const others = aliasesIn(source);
    const lineAt = lineFinder(source.text);
    source.tree.iterate({
      enter: ({ node }) => {
        const ms = node.name === 'CallExpression' ? waitOf(source, node, others, secondsHere) : null;
        if (ms !== null && ms > longest.ms) longest = { ms, line: lineAt(node.from) };
      },
    });
  }
  const holds = longest.ms <= most;
  return { holds, found: longest.ms, line: holds ? null : longest.line };
}

/** Duration of a call that waits, if its value is known. */
function waitOf(source: PythonText, call: SyntaxNode, others: Aliases, secondsHere: boolean): number | null {
  const { firstChild: callee } = call;
  const path = callee === null ? [] : fullPath(source, callee, others);
  const name = path.at(-1) ?? '';
  const unit = Object.hasOwn(WAITS, name) ? (WAITS[name] ?? 1) : null;
  const [first] = argumentsOf(source, call);
  const value = unit === null || first?.value === null || first === undefined ? null : numberOf(source, first.value);
  if (unit === null || value === null) return null;
  const isInSeconds = name === 'sleep' && (path.length > 1 ? IN_SECONDS.includes(path[0] ?? '') : secondsHere);
  return value * (isInSeconds ? 1000 : unit);
}

/** True with `from time import sleep`, after which a plain `sleep` counts seconds. */
function sleepsInSeconds(source: PythonText): boolean {
  return anyNode(
    source,
    (node) =>
      node.name === 'ImportStatement' &&
      importsIn(source, node).some(
        ({ module, symbol }) => IN_SECONDS.includes(module) && (symbol === 'sleep' || symbol === '*'),
      ),
  );
}

/** Longest chain of names that are followed to a value. */
const MOST_NAMES = 20;

/** The value of a number, of a name for one, or of a sum and the like of them; `null`: known only at run time. */
function numberOf(source: PythonText, node: SyntaxNode, names = 0): number | null {
  if (node.name === 'VariableName') return names < MOST_NAMES ? namedNumber(source, node, names + 1) : null;
  if (node.name === 'Number') return finite(Number(textOf(source, node).replaceAll('_', '')));
  if (node.name === 'ParenthesizedExpression') {
    const inner = node.firstChild?.nextSibling;
    return inner ? numberOf(source, inner, names) : null;
  }
  if (node.name !== 'BinaryExpression') return null;
  const { firstChild: left, lastChild: right } = node;
  const sign = left?.nextSibling;
  if (!left || !right || !sign) return null;
  const [a, b] = [numberOf(source, left, names), numberOf(source, right, names)];
  if (a === null || b === null) return null;
  const values: Readonly<Record<string, number>> = { '+': a + b, '-': a - b, '*': a * b, '/': a / b };
  const operator = textOf(source, sign);
  return Object.hasOwn(values, operator) ? finite(values[operator] ?? NaN) : null;
}

/** The number last assigned to a name before it is used here; `null` if anything else is ever assigned to it. */
function namedNumber(source: PythonText, node: SyntaxNode, names: number): number | null {
  const name = textOf(source, node);
  const isUpdated = ({ name: kind, firstChild }: SyntaxNode): boolean =>
    kind === 'UpdateStatement' && firstChild !== null && textOf(source, firstChild) === name;
  if (anyNode(source, isUpdated)) return null;
  let [last, first]: (number | null)[] = [null, null];
  for (const given of namesOf(source).bindings.get(name) ?? []) {
    if (given.kind !== 'value' || given.of !== 'itself') return null;
    const value = numberOf(source, given.node, names);
    if (value === null) return null;
    first ??= value;
    if (given.node.to <= node.from) last = value;
  }
  return last ?? first ?? null;
}

const finite = (value: number): number | null => (Number.isFinite(value) ? value : null);
