import { describe, expect, it } from 'vitest';
import { applyEdit } from '#scene/edit';
import { commonFields, withCommonField } from './common-fields';
import { block, checkpoint, course, mover, stroke, target, wall } from './testing/desk';
import type { Selection } from './tools/tool';

const of = (...ids: readonly string[]): Selection => ({ ids, robot: false });
const thick = { ...wall('v', [0, 50], [100, 50]), thickness: 20 } as ReturnType<typeof wall>;
const scene = course(
  wall('w', [0, 0], [100, 0]),
  thick,
  block('b', [300, 300]),
  mover('m', [400, 400], [500, 400]),
  stroke('s', [0, 0], [100, 0]),
  target('t', [600, 600]),
  checkpoint('c', [700, 700], 1),
);
const names = (...ids: readonly string[]): readonly string[] =>
  commonFields(scene, of(...ids)).map(({ field, isMixed }) => (isMixed ? `${field.name} differs` : field.name));

describe('fields of several things', () => {
  it('are those that all have, without their places; it is told where the values differ', () => {
    expect(names('w', 'v')).toEqual(['thickness differs', 'height']);
    expect(names('b', 'm')).toEqual(['shape', 'length', 'breadth', 'turn', 'height differs']);
    expect(names('t', 'c')).toEqual(['shape', 'length differs', 'breadth differs', 'turn']);
    expect(names('w', 'b')).toEqual(['height differs']);
    expect(names('w', 's')).toEqual([]);
    expect(names('w')).toEqual([]);
  });

  it('are changed in all of them by one edit', () => {
    const edit = withCommonField(scene, of('w', 'v', 's'), 'thickness', 20);
    expect(edit).toEqual({ type: 'replace', changes: [{ id: 'w', by: [{ ...scene.objects[0], thickness: 20 }] }] });
    const wide = withCommonField(scene, of('b', 'm'), 'length', 80)!;
    expect(applyEdit(scene, wide).objects.slice(2, 4)).toMatchObject([{ size: [80, 50] }, { size: [80, 50] }]);
    expect(withCommonField(scene, of('w', 'v'), 'thickness', Number.NaN)).toBeNull();
  });

  it('make all as high as each other, whatever they are; what is usual for one of them is left out there', () => {
    const edit = withCommonField(scene, of('w', 'b', 'm'), 'height', 60)!;
    const [wall, , block, mover] = applyEdit(scene, edit).objects;
    expect([wall, mover]).toMatchObject([{ height: 60 }, { height: 60 }]);
    expect(block).toEqual(scene.objects[2]);
  });
});
