import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { deviceWith } from '../run/testing/run-program';
import { readFrames } from './frames';
import type { Inspected } from './inspected';
import { watchLines } from './line-watch';
import { readVariables } from './variables';

/** A random program with what CPython 3.11 tells of its run, by sys.settrace. */
interface Traced {
  readonly program: string;
  /** The lines that begin, one after the other; without `pass`, `try` and `except`, which have no bytecode of their own. */
  readonly lines: string;
  /** The variables at some of these moments, by name. */
  readonly variables: Readonly<Record<string, string>>;
}

const programs = readFileSync('src/vm/debug/testing/cpython-traces.jsonl', 'utf8')
  .trimEnd()
  .split('\n')
  .map((line) => JSON.parse(line) as Traced);

/** The same of our run. */
function traceOf({ program, lines, variables }: Traced): Omit<Traced, 'program'> {
  const source = program.split('\n');
  const count = lines.split(' ').length;
  const seen: number[] = [];
  const values: [string, string][] = [];
  const { vm } = deviceWith(program);
  vm.hold.watch = watchLines(
    () => vm.inspected,
    ({ kind, line, depth }) => {
      if (kind !== 'line' || /^\s*(pass|try|except)/.test(source[line - 1] ?? '')) return false;
      if (readFrames(vm.inspected)[0]?.code.name === '<listcomp>') return false;
      if (String(seen.length) in variables) values.push([String(seen.length), textOf(vm.inspected, depth)]);
      seen.push(line);
      return seen.length === count;
    },
  );
  vm.resume(60_000_000);
  return { lines: seen.join(' '), variables: Object.fromEntries(values) };
}

function textOf(vm: Inspected, depth: number): string {
  const { stack, globals } = readVariables(vm);
  const own = (depth === 0 ? globals : (stack[0]?.locals ?? [])).filter(({ value }) => value.type !== 'function');
  const sorted = own.sort((a, b) => (a.name < b.name ? -1 : 1));
  return sorted.map(({ name, value }) => `${name}=${value.text}`).join(', ');
}

describe('lines and variables, compared with CPython', () => {
  it(`are the same in ${programs.length} random programs`, () => {
    const different = programs.filter((traced) => {
      const { lines, variables } = traceOf(traced);
      return lines !== traced.lines || JSON.stringify(variables) !== JSON.stringify(traced.variables);
    });
    expect(different.map((traced) => ({ ...traced, ours: traceOf(traced) })).slice(0, 2)).toEqual([]);
    expect(different.length).toBe(0);
  });
});
