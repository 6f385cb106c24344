import { describe, expect, it } from 'vitest';

import { peekAt } from './peek';

const program = 'a\nb\nc\nd\ne\nf\ng\n\n';
const seen = (around: number, count = 3): string =>
  peekAt(program, around, count)
    .map(({ number, text }) => `${number}${text}`)
    .join(' ');

describe('some lines of the program', () => {
  it('are the first ones while nothing runs', () => {
    expect(seen(0)).toBe('1a 2b 3c');
  });

  it('are those round the line that runs, at the edges as many', () => {
    expect([seen(1), seen(4), seen(7)]).toEqual(['1a 2b 3c', '3c 4d 5e', '5e 6f 7g']);
  });

  it('are all where there are fewer', () => {
    expect(peekAt('x\n', 1, 5)).toEqual([{ number: 1, text: 'x' }]);
  });
});
