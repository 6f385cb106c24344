import { describe, expect, it } from 'vitest';
import { editProblem, parseEdit } from './check-edit';
import { applyEdit, type SceneEdit } from './edit';
import { defaultScene, type Block, type Scene, type Stroke, type Wall } from './scene';

const block = (id: string): Block => ({ type: 'block', id, at: [100, 100], size: [50, 50], angle: 0 });
const wall: Wall = { type: 'wall', id: 'w', from: [0, 0], to: [100, 0], thickness: 10 };
const stroke = (id: string, count: number): Stroke => ({
  ...{ type: 'stroke', id, width: 20, color: 'black' },
  points: Array.from({ length: count }, (_, index) => [index % 1000, 0] as const),
});
const scene: Scene = { ...defaultScene(), objects: [block('a'), stroke('s', 20_000), block('b')] };

describe('an edit from outside', () => {
  const good: readonly SceneEdit[] = [
    { type: 'add', objects: [wall, stroke('t', 2)] },
    { type: 'add', objects: [wall, stroke('t', 2)], at: [2, 0] },
    { type: 'remove', ids: ['a', 'b'] },
    { type: 'replace', changes: [{ id: 'a', by: [] }] },
    { type: 'robot', robot: { heading: 45, type: null } },
    { type: 'course', changes: { background: null, task: { seconds: 5, noTouch: true } } },
    { type: 'clear' },
    { type: 'all', edits: [{ type: 'clear' }, { type: 'all', edits: [] }] },
  ];
  it.each(good.map((edit) => [edit.type, edit] as const))('of type %s is read as it is', (_type, edit) => {
    expect(parseEdit(JSON.parse(JSON.stringify(edit)))).toEqual({ edit });
    expect(editProblem(scene, edit)).toBeNull();
  });

  it('gets its defaults as a file does, and brings nothing else along', () => {
    const parsed = parseEdit({ type: 'add', objects: [{ type: 'block', id: 'x', at: [1, 1], size: [9, 9] }] });
    expect(parsed).toEqual({ edit: { type: 'add', objects: [{ ...block('x'), at: [1, 1], size: [9, 9] }] } });
    const undefinedValues = { type: 'robot', robot: { at: undefined, heading: 90 } };
    expect(parseEdit(undefinedValues)).toStrictEqual({ edit: { type: 'robot', robot: { heading: 90 } } });
    expect(parseEdit({ type: 'course', changes: { name: undefined } })).toStrictEqual({
      edit: { type: 'course', changes: {} },
    });
  });

  const deep = (levels: number): unknown =>
    levels === 0 ? { type: 'clear' } : { type: 'all', edits: [deep(levels - 1)] };
  const bad: readonly [what: string, value: unknown, code: string, path: string][] = [
    ['nothing', undefined, 'missing', ''],
    ['a text', 'clear', 'wrong-type', ''],
    ['a list', [], 'wrong-type', ''],
    ['no type', {}, 'missing', 'type'],
    ['an unknown type', { type: 'explode' }, 'unknown-value', 'type'],
    ['a type of the prototype', { type: 'constructor' }, 'unknown-value', 'type'],
    ['a further property', { type: 'clear', objects: [] }, 'unknown-property', 'objects'],
    ['no objects', { type: 'add' }, 'missing', 'objects'],
    [
      'an object out of range',
      { type: 'add', objects: [{ ...wall, to: [1e9, 0] }] },
      'out-of-range',
      'objects[0].to[0]',
    ],
    [
      'a wall without length',
      { type: 'add', objects: [{ ...wall, to: [0, 0] }] },
      'wall-without-length',
      'objects[0].to',
    ],
    ['a place too few', { type: 'add', objects: [wall, stroke('t', 2)], at: [0] }, 'out-of-range', 'at'],
    ['half a place', { type: 'add', objects: [wall], at: [0.5] }, 'not-whole', 'at[0]'],
    ['a place below all', { type: 'add', objects: [wall], at: [-1] }, 'out-of-range', 'at[0]'],
    ['an id that is a number', { type: 'remove', ids: [3] }, 'wrong-type', 'ids[0]'],
    ['a replacement of text', { type: 'replace', changes: ['a'] }, 'wrong-type', 'changes[0]'],
    ['a replacement by nothing said', { type: 'replace', changes: [{ id: 'a' }] }, 'missing', 'changes[0].by'],
    ['a robot property of another name', { type: 'robot', robot: { x: 1 } }, 'unknown-property', 'robot.x'],
    ['a heading of NaN', { type: 'robot', robot: { heading: NaN } }, 'out-of-range', 'robot.heading'],
    ['objects by the course', { type: 'course', changes: { objects: [] } }, 'unknown-property', 'changes.objects'],
    ['a robot by the course', { type: 'course', changes: { robot: {} } }, 'unknown-property', 'changes.robot'],
    ['an arena of no size', { type: 'course', changes: { size: [0, 5] } }, 'out-of-range', 'changes.size[0]'],
    ['edits 5 deep', deep(5), 'too-many', 'edits[0].edits[0].edits[0].edits[0].edits'],
    [
      'edits 100,000 deep',
      JSON.parse(`${'{"type":"all","edits":['.repeat(100_000)}${']}'.repeat(100_000)}`),
      'too-many',
      'edits[0].edits[0].edits[0].edits[0].edits',
    ],
    ['2001 edits', { type: 'all', edits: Array(2001).fill({ type: 'clear' }) }, 'too-many', 'edits'],
    ['4001 ids', { type: 'remove', ids: Array(4001).fill('a') }, 'too-many', 'ids'],
    [
      '60,001 points',
      { type: 'add', objects: [stroke('x', 30_000), stroke('y', 30_001)] },
      'too-many',
      'objects[1].points',
    ],
  ];
  it.each(bad)('is refused: %s', (_what, value, code, path) => {
    const parsed = parseEdit(value);
    if (!('problems' in parsed)) throw new Error('accepted');
    expect(parsed.problems[0]).toMatchObject({ code, path });
    expect(parsed.problem).toBe(parsed.problems[0]?.message);
  });

  it('takes no property named __proto__', () => {
    const parsed = parseEdit(JSON.parse('{ "type": "robot", "robot": { "__proto__": { "scale": 99 } } }'));
    expect(parsed).toMatchObject({ problems: [{ code: 'unknown-property' }] });
  });
});

describe('whether an edit suits a course', () => {
  const table: readonly [what: string, edit: SceneEdit, code: string, path: string][] = [
    ['removing what is not there', { type: 'remove', ids: ['a', 'z'] }, 'unknown-id', 'ids[1]'],
    ['removing it twice', { type: 'remove', ids: ['a', 'a'] }, 'unknown-id', 'ids[1]'],
    ['replacing what is not there', { type: 'replace', changes: [{ id: 'z', by: [] }] }, 'unknown-id', 'changes[0].id'],
    ['an id that another has', { type: 'add', objects: [block('a')] }, 'duplicate-id', 'objects[0].id'],
    ['an id twice', { type: 'add', objects: [block('x'), block('x')] }, 'duplicate-id', 'objects[1].id'],
    [
      'pieces with the id of another',
      { type: 'replace', changes: [{ id: 'a', by: [block('b')] }] },
      'duplicate-id',
      'changes[0].by[0].id',
    ],
    ['too many points', { type: 'add', objects: [stroke('x', 20_000), stroke('y', 20_001)] }, 'too-many', 'objects[1]'],
    [
      'a figure out of range',
      { type: 'add', objects: [{ ...wall, thickness: 0 }] },
      'out-of-range',
      'objects[0].thickness',
    ],
    [
      'a second step that no longer fits',
      { type: 'all', edits: [{ type: 'clear' }, { type: 'remove', ids: ['a'] }] },
      'unknown-id',
      'edits[1].ids[0]',
    ],
  ];
  it.each(table)('is found out: %s', (_what, edit, code, path) => {
    expect(editProblem(scene, edit)).toMatchObject({ code, path });
  });

  it('counts what was there: 2000 objects and not one more', () => {
    const blocks = Array.from({ length: 1997 }, (_, index) => block(`n${index}`));
    const full = applyEdit(scene, { type: 'add', objects: blocks });
    expect(editProblem(scene, { type: 'add', objects: blocks })).toBeNull();
    expect(editProblem(full, { type: 'add', objects: [block('x')] })).toMatchObject({
      code: 'too-many',
      message: 'objects[0]: with it there would be 2001 objects; there may be 2000.',
    });
    expect(editProblem(full, { type: 'replace', changes: [{ id: 'a', by: [block('x')] }] })).toBeNull();
  });

  it('lets pieces take the id of what they replace, and lets two swap', () => {
    expect(
      editProblem(scene, { type: 'replace', changes: [{ id: 's', by: [stroke('s', 5), stroke('t', 5)] }] }),
    ).toBeNull();
    const swap: SceneEdit = {
      type: 'replace',
      changes: [
        { id: 'a', by: [block('b')] },
        { id: 'b', by: [block('a')] },
      ],
    };
    expect(editProblem(scene, swap)).toBeNull();
  });

  it('lets all objects of a full course be moved in one step', () => {
    const objects = Array.from({ length: 2000 }, (_, index) => stroke(`s${index}`, 30));
    const moved: SceneEdit = { type: 'replace', changes: objects.map((object) => ({ id: object.id, by: [object] })) };
    expect(editProblem({ ...scene, objects }, moved)).toBeNull();
  });
});
