import { readdirSync } from 'node:fs';
import { describe, expect, it } from 'vitest';

import type { Print } from './example';

/** The output of each example. */
const EXPECTED: Readonly<Record<string, readonly string[]>> = {
  'attachments-claw': ['held', 'the block comes along'],
  board: ['period 20000 µs', 'no signal'],
  'core-clock': ['1 s: 1', '2 s: 4', '3 s: 5', 'enough'],
  'device-check': ['line 2, column 7: f-string'],
  'devices-ultrasonic': ['echo 1455 µs long: 250 mm'],
  'editor-tool': ['{"type":"wall","id":"wall-1","from":[200,300],"to":[600,300],"thickness":10}'],
  'embed-host': ['answer 1: true', 'event files-changed', 'answer 2: true', 'event started'],
  'project-link': ['from mbrobot import *\nforward()', 'damaged'],
  'reference-complete': ['scroll'],
  'scene-edit': ['0 objects before, 1 after', 'read again: wall-1', 'size[0]: 10 is not within 200 … 10000.'],
  simulation: ['at x = 771 mm, y = 450 mm', 'trace 351b04b444db661eb16282d7247289cc4fa17cd0d3602ddce20b2b36fc19dcb2'],
  vm: ['0', '500', '1', '1000', '2', '1501', '11 LEDs are on'],
  world: ['on the line 0.05, beside it 1', 'the wall is 695 mm ahead', 'after a second something is 270 mm ahead'],
};

const examples = import.meta.glob<{ readonly main: (print: Print) => void | Promise<void> }>(
  ['./*.ts', '!./*.test.ts', '!./example.ts'],
  { eager: true },
);

describe('the examples for developers', () => {
  it('are all listed here', () => {
    const files = readdirSync('examples/dev').filter((name) => !/^example(s\.test)?\.ts$/.test(name));
    expect(
      Object.keys(EXPECTED)
        .map((name) => `${name}.ts`)
        .sort(),
    ).toEqual(files.filter((name) => name.endsWith('.ts')).sort());
  });

  it.each(Object.entries(examples))('%s runs and says what it should', async (path, { main }) => {
    const said: string[] = [];
    await main((line) => said.push(line));
    expect(said).toEqual(EXPECTED[path.slice(2, -3)]);
  });
});
