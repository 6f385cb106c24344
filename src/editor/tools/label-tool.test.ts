import { describe, expect, it } from 'vitest';
import { oneLine } from '../kinds/label';
import { labelTool } from './label-tool';
import { contextOf, course, drag, newObjects, used } from '../testing/desk';

const put = (labelText: string, x = 300) =>
  newObjects(course(), used(labelTool, drag([x, 401]), contextOf(course(), { labelText, labelHeight: 40 })));

describe('label', () => {
  it('puts the chosen words with their middle where it is tapped', () => {
    expect(put('Start')).toEqual([
      { type: 'label', id: 'label-1', at: [300, 400], text: 'Start', height: 40, angle: 0 },
    ]);
  });

  it('does nothing without words, or outside the arena', () => {
    expect(put('')).toEqual([]);
    expect(put('  \n ')).toEqual([]);
    expect(put('Start', -20)).toEqual([]);
  });

  it('makes one line of several, of at most 100 characters, without halving a sign', () => {
    expect(oneLine(' eins\n zwei\u2028drei ')).toBe('eins zwei drei');
    expect(oneLine('x'.repeat(300))).toHaveLength(100);
    expect(oneLine(`${'x'.repeat(99)}😀`)).toBe('x'.repeat(99));
  });
});
