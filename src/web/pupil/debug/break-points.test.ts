import { describe, expect, it } from 'vitest';
import { BreakPoints } from './break-points';

/** The store of a tab. */
function tab(kept: string | null = null) {
  let text = kept;
  return { getItem: () => text, setItem: (_: string, value: string) => void (text = value), text: () => text };
}

describe('break points', () => {
  it('are set and taken away by the same press, line by line and file by file', () => {
    const points = new BreakPoints(null);
    points.toggle('A/main.py', 7);
    points.toggle('A/main.py', 3);
    points.toggle('B/main.py', 3);
    expect(points.of('A/main.py')).toEqual([3, 7]);
    points.toggle('A/main.py', 3);
    expect(points.lines.value).toEqual({ 'A/main.py': [7], 'B/main.py': [3] });
    points.toggle('A/main.py', 7);
    expect(points.lines.value).toEqual({ 'B/main.py': [3] });
  });

  it('are there after a reload', () => {
    const store = tab();
    new BreakPoints(store).toggle('/main.py', 2);
    expect(new BreakPoints(store).of('/main.py')).toEqual([2]);
    new BreakPoints(store).clear();
    expect(new BreakPoints(store).lines.value).toEqual({});
  });

  it.each([
    ['what is no JSON', '{'],
    ['a list', '[3]'],
    ['lines that are none', '{"/main.py":[0,"x"]}'],
  ])('do without %s in the store', (_, text) => {
    expect(new BreakPoints(tab(text)).of('/main.py')).toEqual([]);
  });

  it('are one if they land on the same line', () => {
    const points = new BreakPoints(null);
    points.set('/main.py', [4, 2, 4, 0]);
    expect(points.of('/main.py')).toEqual([2, 4]);
  });

  it('last until the page is closed where the store is full', () => {
    const full = {
      getItem: () => null,
      setItem: () => {
        throw new Error('full');
      },
    };
    const points = new BreakPoints(full);
    points.toggle('/main.py', 1);
    expect(points.of('/main.py')).toEqual([1]);
  });
});
