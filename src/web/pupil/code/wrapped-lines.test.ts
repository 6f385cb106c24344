import { describe, expect, it } from 'vitest';

import { restColumn } from './wrapped-lines';

describe('a line that is too long for the pane', () => {
  it('goes on two columns further in than it begins', () => {
    expect(restColumn('# a long comment', 4)).toBe(2);
    expect(restColumn('        leftArc(0.06)  # the line is on the left', 4)).toBe(10);
    expect(restColumn('\tforward()', 4)).toBe(6);
  });

  it('keeps room for its words however far in it begins', () => {
    expect(restColumn(`${' '.repeat(60)}forward()`, 4)).toBe(18);
  });
});
