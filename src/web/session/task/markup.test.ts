import { describe, expect, it } from 'vitest';

import { blocksOf, spansOf } from './markup';

const text = (words: string) => ({ kind: 'text', text: words });

describe('the text of a task', () => {
  it('has paragraphs parted by empty lines; a single line break stays', () => {
    expect(blocksOf('Eins\nzwei\n\n\ndrei')).toEqual([
      { kind: 'text', lines: [[text('Eins')], [text('zwei')]] },
      { kind: 'text', lines: [[text('drei')]] },
    ]);
    expect(blocksOf(' \n')).toEqual([]);
  });

  it('has lists, with and without numbers, also right after a line', () => {
    expect(blocksOf('So:\n- links\n- rechts\n1. los\n2) halt')).toEqual([
      { kind: 'text', lines: [[text('So:')]] },
      { kind: 'list', lines: [[text('links')], [text('rechts')]] },
      { kind: 'numbers', lines: [[text('los')], [text('halt')]] },
    ]);
  });

  it('does not take a sum, a negative number or a year for a list', () => {
    expect(blocksOf('-5 Grad\n3.5 cm')).toEqual([{ kind: 'text', lines: [[text('-5 Grad')], [text('3.5 cm')]] }]);
  });

  it('has bold words and code', () => {
    expect(spansOf('die **schwarze Linie**: `irLeft`!')).toEqual([
      text('die '),
      { kind: 'bold', text: 'schwarze Linie' },
      text(': '),
      { kind: 'code', text: 'irLeft' },
      text('!'),
    ]);
  });

  it('leaves marks alone that are not closed, and all marks in code', () => {
    expect(spansOf('2 ** 3 und `a')).toEqual([text('2 ** 3 und `a')]);
    expect(spansOf('`a ** b ** c`')).toEqual([{ kind: 'code', text: 'a ** b ** c' }]);
  });

  it('has a place for the picture, and no other picture, no link and no element', () => {
    expect(blocksOf('![Der Plan](picture)')).toEqual([{ kind: 'picture', words: 'Der Plan' }]);
    for (const line of [
      '![x](https://example.org/x.png)',
      '[hier](javascript:alert(1))',
      '<script>alert(1)</script>',
      '<img src=x onerror=alert(1)>',
    ])
      expect(blocksOf(line)).toEqual([{ kind: 'text', lines: [[text(line)]] }]);
  });

  it('is read in no time, however it tries not to be', () => {
    for (const part of ['**', '`', '![', '- ', '1. ', '*a', '[](', ' '])
      expect(blocksOf(part.repeat(100_000)).length).toBeLessThan(2);
  });

  it('may have any number of list lines', () => {
    // One step for each pair of them would never end.
    const [list] = blocksOf('- a **b** c\n'.repeat(200_000));
    expect(list?.kind === 'list' && list.lines.length).toBe(200_000);
  });
});
