import { describe, expect, it } from 'vitest';
import { pushed } from './tool-pointers';

describe('the picture', () => {
  it('moves along when the crosshair comes within 40 px of its edge, and else stays', () => {
    expect([pushed(10, 600), pushed(300, 600), pushed(590, 600)]).toEqual([30, 0, -30]);
  });
});
