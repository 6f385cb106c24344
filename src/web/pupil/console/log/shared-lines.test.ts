import { describe, expect, it } from 'vitest';

import { SHARED_LINES, SharedLines } from './shared-lines';

function linesOf(...pieces: readonly (readonly [device: number, text: string])[]): SharedLines {
  const lines = new SharedLines();
  lines.startRun(1, 2);
  pieces.forEach(([device, text], at) => lines.write(text, device, at));
  lines.show();
  return lines;
}
const textsIn = ({ lines }: SharedLines) =>
  lines.value.slice(1).map(({ device, text, timeUs }) => [device, text, timeUs]);

describe('the lines of several devices', () => {
  it('stand in the order in which they end, each with its device and the time of its beginning', () => {
    const lines = linesOf([0, 'a'], [1, 'b\r\nc'], [0, 'd\n'], [1, '\n']);
    expect(textsIn(lines)).toEqual([[1, 'b', 1], [0, 'ad', 0], [1, 'c', 1]]); // prettier-ignore
  });

  it('begin with the number of the run; of one device those of the last run are kept', () => {
    expect(linesOf().lines.value.map(({ device, text }) => [device, text])).toEqual([[-1, '1']]);
    const lines = linesOf([0, 'a\n']);
    lines.startRun(2, 1);
    lines.write('b\n', 0, 0);
    lines.show();
    expect(lines.lines.value.map(({ device, text }) => [device, text])).toEqual([
      [-1, '2'],
      [0, 'b'],
    ]);
  });

  it('are the newest 300, whatever is printed, and none is longer than 500 characters', () => {
    const lines = linesOf([0, 'x\n'.repeat(2000)], [1, 'y'.repeat(1200)]);
    expect(lines.lines.value).toHaveLength(SHARED_LINES);
    expect([lines.isCut.value, linesOf([0, 'x\n']).isCut.value]).toEqual([true, false]);
    expect(lines.lines.value.slice(-2).map(({ text }) => text.length)).toEqual([500, 500]);
  });
});
