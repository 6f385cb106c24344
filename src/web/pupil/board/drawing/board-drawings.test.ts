import { describe, expect, it } from 'vitest';
import { boardTypes } from '#board/boards/index';
import { drawingOf } from './board-drawings';

describe('the drawings of the boards', () => {
  it('are one of its own for each board type', () => {
    expect(new Set(boardTypes.map(({ id }) => drawingOf(id))).size).toBe(boardTypes.length);
  });

  it('fall back on the micro:bit for a board without a drawing', () => {
    expect(drawingOf('none-yet')).toBe(drawingOf('microbit-v2'));
  });
});
