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
    expect(names('w', 'v')).toEqual(['thickness differs']);
    expect(names('b', 'm')).toEqual(['shape', 'width', 'height', 'turn']);
    expect(names('t', 'c')).toEqual(['shape', 'width differs', 'height differs', 'turn']);
    expect(names('w', 'b')).toEqual([]);
    expect(names('w')).toEqual([]);
  });

  it('are changed in all of them by one edit', () => {
    const edit = withCommonField(scene, of('w', 'v', 's'), 'thickness', 20);
    expect(edit).toEqual({ type: 'replace', changes: [{ id: 'w', by: [{ ...scene.objects[0], thickness: 20 }] }] });
    const wide = withCommonField(scene, of('b', 'm'), 'width', 80)!;
    expect(applyEdit(scene, wide).objects.slice(2, 4)).toMatchObject([{ size: [80, 50] }, { size: [80, 50] }]);
    expect(withCommonField(scene, of('w', 'v'), 'thickness', Number.NaN)).toBeNull();
  });
});
