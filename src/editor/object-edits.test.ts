import { describe, expect, it } from 'vitest';
import { createRng } from '#core/rng';
import { editProblem } from '#scene/check-edit';
import { applyEdit } from '#scene/edit';
import { boundsOf } from '#scene/kinds/index';
import { boundsMeet } from '#scene/outline';
import type { Scene, SceneObject } from '#scene/scene';
import { added, withField, withRobotField } from './object-edits';
import { fieldsOf } from './kinds/index';
import { robotFields, type FieldName, type FieldValue } from './object-fields';
import { block, checkpoint, course, footprint, mover, stroke, target, wall } from './testing/desk';
import { randomCourse } from './testing/random-course';
import { usualToolOptions } from './tools/tool-options';

function changed(
  object: SceneObject,
  name: FieldName,
  value: FieldValue,
  ...others: readonly SceneObject[]
): Scene | null {
  const scene = course(object, ...others);
  const edit = withField(scene, object.id, name, value);
  return edit && applyEdit(scene, edit);
}

const start: SceneObject = {
  ...{ type: 'start', id: 'start-1', at: [300, 300], heading: 0, robot: null, options: {}, name: '', color: null },
};

const first = (...args: Parameters<typeof changed>): SceneObject | undefined => changed(...args)?.objects[0];

describe('changing an object by numbers', () => {
  it('moves a block, sizes it and turns it by degrees', () => {
    expect(first(block('b', [300, 300]), 'x', 412)).toEqual(block('b', [412, 300]));
    expect(first(block('b', [300, 300]), 'breadth', 80)).toMatchObject({ size: [50, 80] });
    expect(first(block('b', [300, 300]), 'turn', 135)).toEqual(block('b', [300, 300], 3));
  });

  it('moves each end of a wall alone, but never both to one place', () => {
    expect(first(wall('w', [100, 100], [200, 100]), 'x', 150)).toEqual(wall('w', [150, 100], [200, 100]));
    expect(first(wall('w', [100, 100], [200, 100]), 'endY', 300)).toEqual(wall('w', [100, 100], [200, 300]));
    expect(changed(wall('w', [100, 100], [200, 100]), 'endX', 100)).toBeNull();
  });

  it('moves a drawn line as a whole and the ends of a straight one', () => {
    expect(first(stroke('s', [0, 0], [10, 0], [10, 10]), 'x', 100)).toEqual(stroke('s', [100, 0], [110, 0], [110, 10]));
    expect(first(stroke('s', [0, 0], [10, 0]), 'x', 5)).toEqual(stroke('s', [5, 0], [10, 0]));
    expect(first(stroke('s', [0, 0], [10, 0]), 'color', 'green')).toMatchObject({ color: 'green' });
  });

  it('moves a mover with its track, and changes what it does', () => {
    expect(first(mover('m', [100, 100], [300, 100]), 'y', 200)).toEqual(mover('m', [100, 200], [300, 200]));
    expect(first(mover('m', [100, 100], [300, 100]), 'way', 'chases')).toMatchObject({ to: [100, 100], chases: {} });
    expect(first(mover('m', [100, 100], [300, 100]), 'spiked', true)).toMatchObject({ spiked: true });
  });

  it('makes what stands lower or higher; the usual height of its kind is left out, and nothing that lies flat has one', () => {
    expect(first(wall('w', [0, 0], [200, 0]), 'height', 30)).toEqual({ ...wall('w', [0, 0], [200, 0]), height: 30 });
    expect(first({ ...wall('w', [0, 0], [200, 0]), height: 30 } as SceneObject, 'height', 250)).toEqual(
      wall('w', [0, 0], [200, 0]),
    );
    expect(first(block('b', [300, 300]), 'height', 1)).toMatchObject({ height: 5 });
    expect(first(mover('m', [100, 100], [300, 100]), 'height', 60)).toMatchObject({ height: 60 });
    expect(changed(block('b', [300, 300]), 'height', 60)).toBeNull();
    expect(changed(target('t', [300, 300]), 'height', 60)).toBeNull();
    const low = { ...block('b', [300, 300]), height: 30 } as SceneObject;
    expect(first(low, 'type', 'spikes')).toMatchObject({ type: 'spikes', height: 30 });
  });

  it('rounds, keeps within what a course may hold, and refuses what is no number', () => {
    expect(first(block('b', [300, 300]), 'x', 99.6)).toEqual(block('b', [100, 300]));
    expect(first(block('b', [300, 300]), 'length', -5)).toMatchObject({ size: [5, 50] });
    expect(first(block('b', [300, 300]), 'length', 1e9)).toMatchObject({ size: [5000, 50] });
    expect(changed(block('b', [300, 300]), 'x', NaN)).toBeNull();
    expect(changed(block('b', [300, 300]), 'x', '12')).toBeNull();
    expect(changed(block('b', [300, 300]), 'x', 300)).toBeNull();
    expect(changed(block('b', [300, 300]), 'speed', 100)).toBeNull();
  });

  it('makes a block a fixed block or spikes, and a zone another zone', () => {
    expect(first(block('b', [300, 300], 1), 'type', 'spikes')).toEqual({
      ...block('b', [300, 300], 1),
      type: 'spikes',
    });
    expect(first(target('t', [300, 300]), 'type', 'checkpoint', checkpoint('c', [0, 0], 3))).toMatchObject({
      type: 'checkpoint',
      number: 4,
    });
    expect(first(checkpoint('c', [0, 0], 3), 'type', 'forbidden')).toMatchObject({ type: 'forbidden', number: 0 });
    expect(changed(block('b', [300, 300]), 'type', 'target')).toBeNull();
  });

  it('swaps the numbers of two checkpoints', () => {
    expect(changed(checkpoint('a', [0, 0], 1), 'number', 2, checkpoint('b', [500, 0], 2))?.objects).toEqual([
      checkpoint('a', [0, 0], 2),
      checkpoint('b', [500, 0], 1),
    ]);
  });

  it('leaves a course that can be saved, whatever is set to whatever', () => {
    const rng = createRng(4);
    const values = [
      -1e9,
      -3,
      0,
      0.5,
      1,
      44,
      777.7,
      1e9,
      Infinity,
      NaN,
      true,
      false,
      '',
      'red',
      'target',
      'spikes',
      'a\nb',
    ];
    let done = 0;
    for (let run = 0; run < 40; run += 1) {
      const scene = randomCourse(rng, 8);
      for (const object of scene.objects)
        for (const { name } of fieldsOf(object))
          for (const value of values) {
            const edit = withField(scene, object.id, name, value);
            if (!edit) continue;
            done += 1;
            expect(editProblem(scene, edit)).toBeNull();
            expect(applyEdit(scene, edit)).not.toEqual(scene);
          }
    }
    expect(done).toBeGreaterThan(1000);
  });
});

describe('changing the start of the robot by numbers', () => {
  const set = (name: FieldName, value: number) => {
    const edit = withRobotField(course(), name, value, footprint);
    return edit && applyEdit(course(), edit).robot;
  };

  it('knows its place, heading and size', () => {
    expect(robotFields(course()).map(({ name }) => name)).toEqual(['x', 'y', 'heading', 'scale']);
    expect(set('x', 700)).toMatchObject({ at: [700, 450] });
    expect(set('heading', -90)).toMatchObject({ heading: -90 });
    expect(set('scale', 1.234)).toMatchObject({ scale: 1.23 });
  });

  it('has a name and a colour where it is one of several', () => {
    const several = course(start);
    const set = (name: FieldName, value: FieldValue, scene = several) => {
      const edit = withRobotField(scene, name, value, footprint);
      return edit && applyEdit(scene, edit);
    };
    expect(
      robotFields(several)
        .map(({ name }) => name)
        .slice(-2),
    ).toEqual(['name', 'robotColor']);
    const named = set('name', 'Ada')!;
    expect(named.robot).toEqual({ ...several.robot, name: 'Ada' });
    expect(set('robotColor', 'teal', named)?.robot).toEqual({ ...several.robot, name: 'Ada', color: 'teal' });
    expect(set('name', '', named)).toEqual(several);
    expect(set('robotColor', 'auto')).toBeNull();
  });

  it('keeps all of the robot inside', () => {
    expect(set('x', 9000)).toMatchObject({ at: [1140, 450] });
    expect(set('y', -9000)).toMatchObject({ at: [600, 30] });
  });
});

describe('adding without a pointer', () => {
  const kinds: readonly SceneObject['type'][] = [
    'wall',
    'block',
    'fixed-block',
    'stroke',
    'target',
    'checkpoint',
    'forbidden',
    'spikes',
    'mover',
    'label',
  ];

  it.each(kinds)('%s: finds room for ten in the arena, none over another or over the robot', (kind) => {
    let scene: Scene = { ...course(), size: [3000, 2000], robot: { ...course().robot, at: [1500, 1000] } };
    for (let i = 0; i < 10; i += 1) {
      const one = added(scene, kind, usualToolOptions, footprint);
      if (!one) throw new Error('no room');
      expect(editProblem(scene, one.edit)).toBeNull();
      scene = applyEdit(scene, one.edit);
      expect(one.selection.ids).toEqual([scene.objects[i]?.id]);
    }
    const robot = { minX: 1460, minY: 970, maxX: 1560, maxY: 1030 };
    const all = [...scene.objects.map(boundsOf), robot];
    all.forEach((bounds, i) => all.slice(i + 1).forEach((other) => expect(boundsMeet(bounds, other)).toBe(false)));
  });

  it('puts a thing into the middle when nothing stands there', () => {
    const scene = { ...course(), robot: { ...course().robot, at: [100, 100] as const } };
    expect(added(scene, 'block', usualToolOptions, footprint)?.edit).toEqual({
      type: 'add',
      objects: [block('block-1', [600, 450])],
    });
  });

  it('puts it into the middle of an arena that is full', () => {
    const scene: Scene = {
      ...course(target('t', [100, 100])),
      size: [200, 200],
      robot: { ...course().robot, at: [100, 100] },
    };
    expect(added(scene, 'block', usualToolOptions, footprint)?.edit).toMatchObject({ objects: [{ at: [100, 100] }] });
  });
});
