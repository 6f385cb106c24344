import { describe, expect, it } from 'vitest';
import { applyEdit } from '#scene/edit';
import { parseScene } from '#scene/parse';
import { defaultScene, type Scene } from '#scene/scene';
import { serializeScene } from '#scene/serialize';
import { layTile, nextPlace, type ShelfTile } from './build-line';

const bare: Scene = { ...defaultScene(), robot: { ...defaultScene().robot, at: [200, 120], heading: 10 } };
const laid = (kinds: readonly ShelfTile[], scene = bare): Scene =>
  kinds.reduce((course, kind) => applyEdit(course, layTile(course, kind) ?? expect.fail(`no room for ${kind}`)), scene);
const way = ({ league }: Scene) => league?.tiles.map(({ at, heading }) => [...at, heading]);

describe('a line that is built from tiles of the shelf', () => {
  it('begins on the tile where the robot stands, which then stands in its middle and heads along it', () => {
    const scene = laid(['straight']);
    expect(scene).toMatchObject({ robot: { at: [150, 150], heading: 0 }, task: { seconds: 480 } });
    expect(way(scene)).toEqual([[150, 150, 0]]);
  });

  it('goes on where the last tile leads, and each tile lies as the robot comes', () => {
    const scene = laid(['straight', 'gap', 'left', 'checkpoint', 'left', 'obstacle', 'end']);
    expect(way(scene)).toEqual([[150, 150, 0], [450, 150, 0], [750, 150, 90], [750, 450, 90], [750, 750, 180], [450, 750, 180], [150, 750, 180]]); // prettier-ignore
    expect(scene.league?.tiles.map(({ gaps, obstacles, checkpoint }) => [gaps, obstacles, checkpoint]).flat().filter((one) => one !== undefined)).toEqual([1, true, 1]); // prettier-ignore
    const upwards = scene.objects.find(({ id }) => id === 'stroke-5');
    expect(upwards).toMatchObject({ points: [[750, 300], [750, 600]] }); // prettier-ignore
    expect(scene.objects).toContainEqual(expect.objectContaining({ type: 'paper', color: 'red', at: [150, 750], size: [25, 300] })); // prettier-ignore
    expect(parseScene(serializeScene(scene))).toEqual({ scene });
  });

  it('has a green mark before a crossing, on the side to which it turns', () => {
    const scene = laid(['straight', 'toLeft']);
    expect(scene.objects).toContainEqual(expect.objectContaining({ type: 'paper', color: 'green', at: [428, 173] }));
    expect(way(scene)?.at(-1)).toEqual([450, 150, 90]);
  });

  it('ends at the edge of the arena, at itself and behind its end', () => {
    expect(nextPlace(laid(['straight', 'straight', 'straight', 'straight']))).toBeNull();
    expect(nextPlace(laid(['straight', 'left', 'left', 'left']))).toBeNull();
    expect(layTile(laid(['straight', 'end']), 'straight')).toBeNull();
  });
});
