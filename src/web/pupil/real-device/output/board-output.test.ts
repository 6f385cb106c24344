import { describe, expect, it } from 'vitest';

import { BoardOutput } from './board-output';

const textOf = (output: BoardOutput): string => output.all.map(({ text }) => text).join('');

describe('the output of a real board', () => {
  it('has the time since the program started', () => {
    const output = new BoardOutput();
    output.end(1000);
    output.write('23\r\n', 1500);
    expect(output.all).toEqual([{ device: 0, text: '23\r\n', timeUs: 500_000 }]);
  });

  it('begins anew with the next program, once that says something', () => {
    const output = new BoardOutput();
    output.write('old', 0);
    output.end(100);
    expect(textOf(output)).toBe('old');
    output.write('new', 200);
    expect([textOf(output), output.start]).toEqual(['new', 2]);
  });

  it('has no signs that the flasher has filled the line with', () => {
    const output = new BoardOutput();
    output.write('\0\0\0', 0);
    output.write('\0a', 1);
    expect(output.all).toEqual([{ device: 0, text: 'a', timeUs: 1000 }]);
  });

  it('keeps the end of a long output, and counts what is gone', () => {
    const output = new BoardOutput();
    for (let line = 0; line < 1000; line++) output.write('x'.repeat(500), line);
    expect([output.all.length, output.gone]).toEqual([400, 600]);
  });
});
