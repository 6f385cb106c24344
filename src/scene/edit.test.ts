import { describe, expect, it } from 'vitest';
import { applyEdit, freeId, type SceneEdit } from './edit';
import { defaultScene, type Block, type Scene, type Stroke } from './scene';

const block = (id: string, x = 100): Block => ({ type: 'block', id, at: [x, 100], size: [50, 50], angle: 0 });
const line: Stroke = {
  ...{ type: 'stroke', id: 's', width: 20, color: 'black' },
  points: [
    [0, 0],
    [100, 0],
  ],
};
const scene: Scene = { ...defaultScene(), objects: [block('a'), line, block('b', 200)] };
const idsAfter = (edit: SceneEdit): readonly string[] => applyEdit(scene, edit).objects.map(({ id }) => id);

describe('an edit', () => {
  it('adds on top', () => {
    expect(idsAfter({ type: 'add', objects: [block('c'), block('d')] })).toEqual(['a', 's', 'b', 'c', 'd']);
  });

  it('adds among the others, each where it says, one after the other', () => {
    const objects = [block('c'), block('d'), block('e')];
    expect(idsAfter({ type: 'add', objects, at: [0, 2, 99] })).toEqual(['c', 'a', 'd', 's', 'b', 'e']);
  });

  it('removes by id', () => {
    expect(idsAfter({ type: 'remove', ids: ['a', 'b'] })).toEqual(['s']);
  });

  it('puts pieces in the place of a line and keeps the order of painting', () => {
    const by = [
      { ...line, id: 's1' },
      { ...line, id: 's2' },
    ];
    expect(idsAfter({ type: 'replace', changes: [{ id: 's', by }] })).toEqual(['a', 's1', 's2', 'b']);
    expect(idsAfter({ type: 'replace', changes: [{ id: 's', by: [] }] })).toEqual(['a', 'b']);
  });

  it('clears all objects and keeps robot, task, size and background', () => {
    const after = applyEdit({ ...scene, task: { seconds: 30, noTouch: true } }, { type: 'clear' });
    expect(after).toEqual({ ...scene, task: { seconds: 30, noTouch: true }, objects: [] });
  });

  it('changes of robot and course only what it names', () => {
    expect(applyEdit(scene, { type: 'robot', robot: { heading: 90 } }).robot).toEqual({ ...scene.robot, heading: 90 });
    const after = applyEdit(scene, { type: 'course', changes: { name: 'Slalom', size: [2000, 900] } });
    expect(after).toEqual({ ...scene, name: 'Slalom', size: [2000, 900] });
  });

  it('does several parts one after the other', () => {
    const edits: SceneEdit[] = [
      { type: 'clear' },
      { type: 'add', objects: [block('x')] },
      { type: 'remove', ids: ['x'] },
    ];
    expect(idsAfter({ type: 'all', edits: edits.slice(0, 2) })).toEqual(['x']);
    expect(idsAfter({ type: 'all', edits })).toEqual([]);
  });

  it('leaves what it does not change the very same objects', () => {
    const after = applyEdit(scene, { type: 'replace', changes: [{ id: 'b', by: [block('b', 300)] }] });
    expect(after.objects[0]).toBe(scene.objects[0]);
    expect(after.objects[1]).toBe(line);
    expect(after.robot).toBe(scene.robot);
  });

  const nothing: readonly [what: string, edit: SceneEdit][] = [
    ['adding nothing', { type: 'add', objects: [] }],
    ['removing what is not there', { type: 'remove', ids: ['z'] }],
    ['replacing what is not there', { type: 'replace', changes: [{ id: 'z', by: [block('z')] }] }],
    ['replacing a block by an equal one', { type: 'replace', changes: [{ id: 'b', by: [block('b', 200)] }] }],
    ['a robot as it is', { type: 'robot', robot: { at: [600, 450], options: {} } }],
    [
      'a course as it is',
      { type: 'course', changes: { name: '', size: [1200, 900], task: { seconds: null, noTouch: false } } },
    ],
    [
      'doing nothing twice',
      {
        type: 'all',
        edits: [
          { type: 'robot', robot: {} },
          { type: 'course', changes: {} },
        ],
      },
    ],
  ];
  it.each(nothing)('gives the same course if it changes nothing: %s', (_what, edit) => {
    expect(applyEdit(scene, edit)).toBe(scene);
  });

  it('clearing an empty course gives the same course', () => {
    const empty = defaultScene();
    expect(applyEdit(empty, { type: 'clear' })).toBe(empty);
  });
});

describe('a free id', () => {
  it('is the lowest number that neither an object has nor is taken', () => {
    const walls: Scene = { ...scene, objects: [block('block-1'), block('block-3')] };
    expect(freeId(walls, 'block')).toBe('block-2');
    expect(freeId(walls, 'block', ['block-2'])).toBe('block-4');
    expect(freeId(walls, 'wall')).toBe('wall-1');
  });
});
