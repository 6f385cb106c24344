import { describe, expect, it } from 'vitest';

import { movedLines } from './moved-lines';

const RAN = 'for i in range(9):\n    print(i)\n    delay(100)\nprint("end")\n';
const all = (after: string): readonly (number | null)[] => [1, 2, 3, 4].map((line) => movedLines(RAN, after).now(line));

describe('lines of a program that has been edited since it ran', () => {
  it('have moved with what was inserted above them, between them, and at several places', () => {
    expect(all(RAN)).toEqual([1, 2, 3, 4]);
    expect(all(`# a\n# b\n# c\n${RAN}`)).toEqual([4, 5, 6, 7]);
    expect(all(`# a\n${RAN.replace('    delay', '    x = i\n    delay')}# end\n`)).toEqual([2, 3, 5, 6]);
  });

  it('are none where they were changed or taken away', () => {
    expect(all(RAN.replace('print(i)', 'print("new", i)'))).toEqual([1, null, 3, 4]);
    expect(all(RAN.replace('    print(i)\n', ''))).toEqual([1, null, 2, 3]);
    expect(all('')).toEqual([null, null, null, null]);
    expect(movedLines(RAN, RAN).now(99)).toBeNull();
  });

  it('lead back to the line that ran, as break points need it', () => {
    const moved = movedLines(RAN, `# a\n${RAN.replace('delay(100)', 'delay(200)')}`);
    expect([1, 2, 3, 4, 5].map((line) => moved.before(line))).toEqual([null, 1, 2, null, 4]);
  });
});
