import { describe, expect, it } from 'vitest';

import { allTools, toolLetters, toolOfLetter } from './tool-list';

describe('the letters of the tools', () => {
  it('are all different, one for each of the twelve tools', () => {
    expect(allTools).toHaveLength(12);
    expect(new Set(Object.values(toolLetters)).size).toBe(12);
  });
  it('choose the tool they stand for', () => {
    expect(toolOfLetter('p')).toBe('pen');
    expect(toolOfLetter('h')).toBe('hand');
    expect(toolOfLetter('q')).toBeUndefined();
  });
});
