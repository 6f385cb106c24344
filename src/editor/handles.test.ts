import { describe, expect, it } from 'vitest';
import { handleAt, handlesOf } from './handles';
import type { SceneObject } from '#scene/scene';
import { block, course, footprint, mover, stroke, wall } from './testing/desk';
import type { Selection } from './tools/tool';

const scene = course(
  wall('w', [100, 100], [400, 100]),
  block('b', [300, 300], 2),
  mover('m', [700, 700], [900, 700]),
  stroke('line', [100, 500], [400, 500]),
  stroke('drawn', [100, 600], [200, 700], [300, 600]),
  stroke('dot', [50, 50]),
);
const of = (ids: readonly string[], robot = false): Selection => ({ ids, robot });
const kinds = (selection: Selection): readonly string[] =>
  handlesOf(scene, selection, footprint, 10).map(({ kind, id }) => `${kind} ${String(id)}`);

describe('handles', () => {
  it('are the ends and a knob of a wall', () => {
    expect(handlesOf(scene, of(['w']), footprint, 10)).toEqual([
      { kind: 'from', at: { x: 100, y: 100 }, id: 'w' },
      { kind: 'to', at: { x: 400, y: 100 }, id: 'w' },
      { kind: 'rotate', at: { x: 250, y: 125 }, id: 'w' },
    ]);
  });

  it('turn with a block: its own corners, its sides, and a knob above it', () => {
    const handles = handlesOf(scene, of(['b']), footprint, 5);
    expect(handles).toHaveLength(9);
    expect(handles).toContainEqual({ kind: 'size', at: { x: 275, y: 325 }, id: 'b', side: [1, 1] });
    expect(handles).toContainEqual({ kind: 'size', at: { x: 275, y: 300 }, id: 'b', side: [0, 1] });
    expect(handles.at(-1)).toEqual({ kind: 'rotate', at: { x: 265, y: 300 }, id: 'b' });
  });

  it('are fewer on what is small under the pointer: four corners, then one', () => {
    const sizes = (reachMm: number) =>
      handlesOf(scene, of(['b']), footprint, reachMm).filter(({ kind }) => kind === 'size').length;
    expect([8, 9, 16, 17, 22].map(sizes)).toEqual([8, 4, 4, 1, 1]);
    const wide = course(block('b', [300, 300]), { ...block('c', [500, 500]), size: [300, 20] } as SceneObject);
    expect(handlesOf(wide, of(['c']), footprint, 10).flatMap(({ side }) => (side ? [side] : []))).toEqual([
      [-1, 1],
      [0, 1],
      [1, 1],
    ]);
  });

  it('are also the stops of a mover, where it can have more, and the ends of a straight line', () => {
    expect(kinds(of(['m'])).slice(-4)).toEqual(['rotate m', 'point m', 'add m', 'add m']);
    expect(kinds(of(['line']))).toEqual(['from line', 'to line', 'rotate line']);
    expect(new Set(kinds(of(['drawn'])))).toEqual(new Set(['size drawn', 'rotate drawn']));
    expect(kinds(of(['dot']))).toEqual([]);
  });

  it('stand before the robot, if there is one', () => {
    expect(handlesOf(scene, of([], true), footprint, 10)).toEqual([
      { kind: 'rotate', at: { x: 680, y: 450 }, id: null },
    ]);
    expect(handlesOf(scene, of([], true), [], 10)).toEqual([]);
  });

  it('are eight around several, and one knob above them', () => {
    const handles = handlesOf(scene, of(['w', 'b']), footprint, 10);
    expect(handles).toHaveLength(9);
    expect(handles).toContainEqual({ kind: 'size', at: { x: 100, y: 95 }, id: 'w', side: [-1, -1] });
    expect(handles.at(-1)).toEqual({ kind: 'rotate', at: { x: 250, y: 345 }, id: 'w' });
    expect(kinds(of(['b'], true)).at(-1)).toBe('rotate b');
    expect(kinds(of([]))).toEqual([]);
  });

  it('are taken hold of within reach, the nearest first', () => {
    expect(handleAt(scene, of(['w']), footprint, { x: 405, y: 108 }, 10)?.kind).toBe('to');
    expect(handleAt(scene, of(['w']), footprint, { x: 420, y: 108 }, 10)).toBeNull();
    expect(handleAt(scene, of(['w']), footprint, { x: 250, y: 118 }, 10)?.kind).toBe('rotate');
  });
});
