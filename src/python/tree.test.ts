import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';

import { createRng } from '#core/rng';
import { parsePython, readPython, readUpTo, type PythonText } from './tree';

const program = readFileSync('src/robots/maqueen-lite/library/mbrobot.py', 'utf8').slice(0, 4000);

/** All nodes with their places. */
function nodesOf({ tree }: PythonText): string {
  const nodes: string[] = [];
  tree.iterate({ enter: ({ name, from, to }) => void nodes.push(`${name} ${from}–${to}`) });
  return nodes.join('\n');
}

describe('the syntax tree of a program', () => {
  it('is the same object for the same text', () => {
    expect(readPython(program)).toBe(readPython(program.slice(0, 10) + program.slice(10)));
  });

  it('is the same whether the program was parsed as a whole or letter by letter', () => {
    for (let end = 0; end <= 400; end += 1) readPython(program.slice(0, end));
    for (const text of [program.slice(0, 400), program])
      expect(nodesOf(readPython(text))).toBe(nodesOf(parsePython(text)));
  });

  it('is the same as of a new text after a line was written, half written or removed, and the program is sound', () => {
    const rng = createRng(1);
    const lines = program.split('\n');
    for (let round = 0; round < 100; round += 1) {
      const place = rng.u32() % lines.length;
      const indent = /^ */.exec(lines[place] ?? '')?.[0] ?? '';
      lines.splice(
        place,
        0,
        `${indent}${['x = [1, (2, "a")]', 'display.', 'for i in range(3): x()', 'f("'][round % 4] ?? ''}`,
      );
      const text = lines.join('\n');
      const read = readPython(text);
      if (!read.hasErrors) expect([round, nodesOf(read)]).toEqual([round, nodesOf(parsePython(text))]);
      expect(read.hasErrors).toBe(parsePython(text).hasErrors);
      if (round % 4 !== 0) lines.splice(place, 1);
    }
  });

  it('up to a place has a name there, whatever stands behind it', () => {
    const source = readPython('while True:\n    display.show(1)\n    x = [');
    expect(nodesOf(readUpTo(source, 24))).toBe(nodesOf(parsePython('while True:\n    display._')));
  });
});
