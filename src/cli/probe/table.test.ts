import { describe, expect, it } from 'vitest';
import { parseProbe } from './table';

const problemOf = (...lines: readonly string[]): string => {
  const read = parseProbe(lines.join('\n'));
  return 'problem' in read ? read.problem : 'none';
};
const BEGIN = 'probe;begin;timing;1;micro:bit with nRF52833';

describe('the saved output of a board', () => {
  it('is read among greetings and prompts, with the line ends of any system', () => {
    const text = [
      '>>> ',
      BEGIN,
      'probe;row;us;im.copy();63.5',
      'hello',
      'probe;row;text;a;b;c; d',
      'probe;end;timing;2',
      '>>> ',
    ];
    const read = parseProbe(text.join('\r\n'));
    if ('problem' in read) throw new Error(read.problem);
    const [table] = read.tables;
    expect(table?.program).toBe('timing');
    expect(table?.machine).toBe('micro:bit with nRF52833');
    expect([...(table?.rows ?? [])]).toEqual([
      ['im.copy()', { unit: 'us', value: '63.5' }],
      ['a', { unit: 'text', value: 'b;c; d' }],
    ]);
  });

  it.each([
    [['hello'], 'there is no table of a probe in it. Save what docs/hardware/probe prints on the board.'],
    [[BEGIN, 'probe;row;us;x;1'], 'the table of timing is cut off after 1 rows: its end is missing. Run it again.'],
    [['probe;row;us;x;1'], 'line 1: a row before the beginning of its table. Save the whole output.'],
    [['probe;end;timing;0'], 'line 1: the end of a table without its beginning. Save the whole output.'],
    [
      ['probe;begin;timing;2;x'],
      "line 1: version 2 of a probe's table; this is made for 1. Take the programs that belong to it.",
    ],
    [[BEGIN, 'probe;row;parsec;x;1'], 'line 2: "parsec" is no unit. Known: us, ms, bytes, items, calls, text.'],
    [[BEGIN, 'probe;row;us;x'], 'line 2: a row without id or value: a part of the line is lost. Run it again.'],
    [[BEGIN, 'probe;row;us;x;fast'], 'line 2: "fast" is no number of us, for "x".'],
    [[BEGIN, 'probe;row;us;x;1', 'probe;row;us;x;2'], 'line 3: "x" stands twice in timing.'],
    [[BEGIN, 'probe;end;timing;3'], 'line 2: timing printed 3 rows, and 0 are here: lines are lost. Run it again.'],
    [[BEGIN, 'probe;end;floats;0'], 'line 2: floats ends, but timing has begun.'],
    [[BEGIN, BEGIN], 'line 2: timing begins before timing has ended. Run timing again.'],
    [['probe;row', 'x'], 'line 1: a row before the beginning of its table. Save the whole output.'],
    [['probe;cow;us'], 'line 1: "cow" is not begin, row or end.'],
  ])('says where something is wrong and what to do: %j', (lines, problem) => expect(problemOf(...lines)).toBe(problem));
});
