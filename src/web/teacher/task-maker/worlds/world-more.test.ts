import { describe, expect, it } from 'vitest';
import { courseOfWorld } from '#check/task/world-course';
import { plainWorld, type WorldVariant } from '#check/task/task';
import { sceneWith, targetAt } from '#check/testing/tasks';
import { parseEdit } from '#scene/check-edit';
import { readInputs } from '#tape/read-setup';
import { freshInput, inputKinds, inputRows, withInput, worldGestures, worldSensors } from './world-inputs';
import { objectEdit, objectRows, withObject } from './world-objects';

const wall = { type: 'wall', id: 'w', from: [500, 300], to: [500, 600], thickness: 10 } as const;
const scene = sceneWith([targetAt(700, 450), wall]);
const worldWith = (...edits: WorldVariant['edits']): WorldVariant => ({ ...plainWorld, edits });

describe('an object in a world', () => {
  it('is left out, or moved, and read again from its edit', () => {
    const moved = { ...wall, from: [550, 280], to: [550, 580] } as const;
    const world = worldWith(objectEdit('t', null), objectEdit('w', moved));
    for (const edit of world.edits) expect(parseEdit(JSON.parse(JSON.stringify(edit)))).toHaveProperty('edit');
    expect(objectRows(scene, world)).toEqual([
      { place: 0, id: 't', made: null, by: null },
      { place: 1, id: 'w', made: moved, by: [50, -20] },
    ]);
    expect(courseOfWorld(scene, world)).toMatchObject({ scene: { objects: [moved] } });
  });

  it('is no row if it is changed together with others', () =>
    expect(objectRows(scene, worldWith({ type: 'remove', ids: ['t', 'w'] }, { type: 'clear' }))).toEqual([]));

  it('has one edit, however often it is changed, and none once it is as in the course', () => {
    const other = { ...wall, thickness: 20 };
    const once = worldWith(...withObject(scene, worldWith({ type: 'clear' }), 'w', null));
    const twice = worldWith(...withObject(scene, once, 'w', other));
    expect(twice.edits).toEqual([{ type: 'clear' }, objectEdit('w', other)]);
    expect(withObject(scene, twice, 'w', wall)).toEqual([{ type: 'clear' }]);
  });
});

describe('what happens in a world', () => {
  it('offers light, sound, temperature, heading and tilt, and what the board feels', () => {
    expect(worldSensors.map(({ id }) => id)).toEqual(['accelerometerX', 'accelerometerY', 'accelerometerZ', 'compassHeading', 'temperature', 'lightLevel', 'soundLevel']); // prettier-ignore
    expect(worldGestures).toContain('shake');
  });

  it.each(inputKinds)('“%s” is written as inputs of a run, and read again', (kind) => {
    const row = freshInput(kind, 2_000_000);
    const inputs = withInput([], [], row);
    expect(readInputs(JSON.parse(JSON.stringify(inputs)))).toEqual(inputs);
    expect(inputRows(inputs)).toEqual([{ ...row, places: inputs.map((_, place) => place) }]);
    expect(withInput(inputs, [0, 1], null)).toEqual([]);
  });

  it('is in the order of time, also where presses overlap', () => {
    const a = withInput([], [], { ...freshInput('button a', 1_000_000), heldUs: 3_000_000 });
    const both = withInput(a, [], freshInput('button b', 2_000_000));
    expect(both.map(({ timeUs }) => timeUs)).toEqual([1_000_000, 2_000_000, 2_200_000, 4_000_000]);
    expect(inputRows(both).map(({ kind, heldUs, places }) => [kind, heldUs, places])).toEqual([
      ['button a', 3_000_000, [0, 3]],
      ['button b', 200_000, [1, 2]],
    ]);
  });

  it('keeps what the page cannot show', () => {
    const edit = { timeUs: 0, action: { type: 'arena-senses', on: true } } as const;
    const other = { timeUs: 5, device: 'B', action: { type: 'serial', text: 'x' } } as const;
    const inputs = withInput([edit, other], [], freshInput('radio', 3));
    expect(inputRows(inputs)).toHaveLength(1);
    expect(withInput(inputs, inputRows(inputs)[0]!.places, null)).toEqual([edit, other]);
  });
});
