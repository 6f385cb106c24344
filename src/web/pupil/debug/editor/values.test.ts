import { describe, expect, it } from 'vitest';
import { nameAt } from './values';

const at = (marked: string): string | null => nameAt(marked.replace('|', ''), marked.indexOf('|'))?.name ?? null;

describe('the name that the mouse points at', () => {
  it('is found from its first letter to its last', () => {
    expect(['|speed = 3', 'sp|eed = 3', 'speed| = 3'].map(at)).toEqual(['speed', 'speed', 'speed']);
    expect(at('n = größe_2|')).toBe('größe_2');
  });

  it('is none in numbers, signs and spaces', () => {
    expect(['x  =| 12', 'x = 1|2', 'x =  |  3'].map(at)).toEqual([null, null, null]);
  });

  it('is none after a dot: an attribute is no variable of that name', () => {
    expect(at('robot.sp|eed')).toBeNull();
    expect(at('ro|bot.speed')).toBe('robot');
  });
});
