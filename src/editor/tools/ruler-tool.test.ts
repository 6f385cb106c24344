import { describe, expect, it } from 'vitest';
import type { Point } from '#scene/scene';
import { rulerTool } from './ruler-tool';
import { contextOf, course, drag } from '../testing/desk';

const marks = (isDown: boolean, ...path: readonly Point[]) =>
  rulerTool.marks?.(drag(...path), contextOf(course()), isDown);

describe('ruler', () => {
  it('measures from where the drag began to where it is', () => {
    expect(marks(true, [100, 100], [400, 500])).toEqual([
      { type: 'measure', from: { x: 100, y: 100 }, to: { x: 400, y: 500 } },
    ]);
  });

  it('tells the place itself when it is tapped', () => {
    expect(marks(true, [100, 100], [101, 100])).toEqual([
      { type: 'measure', from: { x: 101, y: 100 }, to: { x: 101, y: 100 } },
    ]);
  });

  it('changes nothing, and shows nothing while the pointer only hovers', () => {
    expect(rulerTool.edit(drag([100, 100], [400, 500]), contextOf(course()))).toBeNull();
    expect(marks(false, [100, 100])).toEqual([]);
  });
});
