import { describe, expect, it } from 'vitest';
import { fileName } from './save-file';

describe('the name of a saved picture', () => {
  it('is that of the course, without what file systems do not allow', () => {
    expect(fileName('Linienfolger 1', 'png')).toBe('Linienfolger 1.png');
    expect(fileName('A/B: «C»?\n.', 'svg')).toBe('AB «C».svg');
    expect(fileName('../..', 'pdf')).toBe('parcours.pdf');
    expect(fileName('', 'pdf')).toBe('parcours.pdf');
    expect(fileName('🚗'.repeat(100), 'pdf')).toBe(`${'🚗'.repeat(60)}.pdf`);
  });
});
