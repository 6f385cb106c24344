import { describe, expect, it } from 'vitest';
import { BREAK_POINTS, withWidths } from './break-points';

describe('a break point', () => {
  it('is written by its name, also turned round and beside another condition', () => {
    expect(withWidths('(--phone)')).toBe('(max-width: 599px)');
    expect(withWidths('not (--narrow)')).toBe('not all and (max-width: 767px)');
    expect(withWidths('(--phone), (max-height: 679px)')).toBe('(max-width: 599px), (max-height: 679px)');
    expect(withWidths('(hover: hover)')).toBe('(hover: hover)');
  });

  it('must be one of four', () => {
    expect(Object.keys(BREAK_POINTS)).toHaveLength(4);
    expect(() => withWidths('(--watch)')).toThrow('There is no break point watch.');
    expect(() => withWidths('not (--one-pane)')).toThrow('cannot be turned round');
  });
});
