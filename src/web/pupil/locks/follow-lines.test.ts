import { describe, expect, it } from 'vitest';
import { followLines } from './follow-lines';

const START = ['import robot', '', 'def turn():', '    left(90)', '', 'turn()'];
/** The places of lines 3, 4 and 6 after a change of the program, and the texts of those that are gone. */
const after = (change: (lines: string[]) => unknown) => {
  const now = [...START];
  change(now);
  return followLines(START.join('\n'), now.join('\n'), [3, 4, 6]);
};

describe('locks of lines in a start program that goes on being written', () => {
  it('move with their lines when some are put in or taken out above them', () => {
    expect(after((lines) => lines.unshift('# a task', ''))).toEqual({ lines: [5, 6, 8], lost: [] });
    expect(after((lines) => lines.splice(1, 1))).toEqual({ lines: [2, 3, 5], lost: [] });
    expect(after((lines) => lines.splice(4, 0, '    delay(1)'))).toEqual({ lines: [3, 4, 7], lost: [] });
  });

  it('stay where something is written below them', () => {
    expect(after((lines) => lines.push('stop()'))).toEqual({ lines: [3, 4, 6], lost: [] });
  });

  it('stay on a line that is written anew, indented, or cut in two', () => {
    expect(after((lines) => (lines[3] = '    right(45)'))).toEqual({ lines: [3, 4, 6], lost: [] });
    expect(after((lines) => lines.splice(2, 2, '    def turn():', '        left(90)'))).toEqual({ lines: [3, 4, 6], lost: [] }); // prettier-ignore
    expect(after((lines) => lines.splice(3, 1, '    left', '(90)'))).toEqual({ lines: [3, 4, 7], lost: [] });
    expect(after((lines) => lines.splice(4, 2, '    turn()'))).toEqual({ lines: [3, 4, 5], lost: [] });
  });

  it('follow lines that change places with free ones', () => {
    expect(after((lines) => lines.splice(0, 4, 'def turn():', '    left(90)', 'import robot', ''))).toEqual({ lines: [1, 2, 6], lost: [] }); // prettier-ignore
  });

  it('are lost with their lines, and the texts are told; blank ones are no loss', () => {
    expect(after((lines) => lines.splice(3, 1))).toEqual({ lines: [3, 5], lost: ['    left(90)'] });
    expect(followLines('a()\n\nb()', 'a()\nb()', [1, 2])).toEqual({ lines: [1], lost: [] });
  });

  it('are all lost to another program, even of as many lines', () => {
    const other = ['while True:', '  pass', 'x = 1', 'y = 2', 'z = 3', 'print(x + y + z)'].join('\n');
    expect(followLines(START.join('\n'), other, [3, 4, 6])).toEqual({ lines: [], lost: ['def turn():', '    left(90)', 'turn()'] }); // prettier-ignore
  });

  it('come back with their lines, such as when a cut is taken back or pasted elsewhere', () => {
    const cut = START.toSpliced(3, 1);
    expect(followLines(cut.join('\n'), START.join('\n'), [3, 5], ['    left(90)'])).toEqual({
      lines: [3, 4, 6],
      lost: [],
    });
    const elsewhere = [...cut, '    left(90)'].join('\n');
    expect(followLines(cut.join('\n'), elsewhere, [3, 5], ['    left(90)'])).toEqual({ lines: [3, 5, 6], lost: [] });
  });
});
