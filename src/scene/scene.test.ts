import { describe, expect, it } from 'vitest';
import { parseScene } from './parse';
import { defaultScene, sceneLimits } from './scene';
import { serializeScene } from './serialize';
import { background, changed, full, label, mover, sceneOf, wall, withObject, zone } from './testing/full-scene';

describe('a course file', () => {
  it('is read with all its properties', () => {
    const scene = sceneOf(full);
    expect(scene.robot).toEqual({ type: 'maqueen-lite', at: [600, 450], heading: 90, scale: 1.5, options: {} });
    expect(scene.objects.map((object) => object.id)).toEqual(['a1', 'a2', 'a3', 'a4']);
  });

  it('may leave out everything that has a default', () => {
    expect(sceneOf({ format: 'parcours-scene', version: 1 })).toEqual(defaultScene());
    const scene = sceneOf({
      format: 'parcours-scene',
      version: 1,
      size: [1000, 800],
      objects: [
        { id: 'w', type: 'wall', from: [0, 0], to: [100, 0] },
        { id: 'b', type: 'block', at: [100, 100], size: [50, 50] },
        { id: 's', type: 'stroke', points: [[10, 10]] },
      ],
    });
    expect(scene.robot.at).toEqual([500, 400]);
    expect(scene.objects).toMatchObject([{ thickness: 10 }, { angle: 0 }, { width: 20, color: 'black' }]);
  });

  it('is the same after writing and reading it again', () => {
    const scene = sceneOf(full);
    const text = serializeScene(scene);
    expect(parseScene(text)).toEqual({ scene });
    expect(serializeScene(sceneOf(JSON.parse(text)))).toBe(text);
  });

  it('is written without its defaults, one object per line', () => {
    expect(serializeScene(defaultScene())).toBe(
      '{\n  "format": "parcours-scene",\n  "version": 2,\n  "size": [1200, 900],\n  "robot": { "at": [600, 450] },\n  "objects": []\n}\n',
    );
    expect(serializeScene(sceneOf(withObject(wall)))).toContain(
      '\n    { "id": "w", "type": "wall", "from": [0, 0], "to": [100, 0] }\n  ]\n',
    );
  });

  it('keeps the options of the robot, in the order of their names', () => {
    const text = serializeScene(sceneOf({ ...full, robot: { options: { model: '2E', S1: 'claw' } } }));
    expect(text).toContain('"options": { "S1": "claw", "model": "2E" }');
    expect(sceneOf(JSON.parse(text)).robot.options).toEqual({ S1: 'claw', model: '2E' });
  });

  it('may leave out the defaults of every kind of object, the task and the background', () => {
    const {
      objects,
      task,
      background: floor,
    } = sceneOf(changed({ objects: [zone, mover, label], task: {}, background }));
    expect(objects).toEqual([
      { ...zone, angle: 0, round: false, number: 0, blocks: 0 },
      { ...mover, angle: 0, speed: 100, spiked: false },
      { ...label, angle: 0, height: 30 },
    ]);
    expect(task).toEqual({ seconds: null, noTouch: false });
    expect(floor).toEqual({ ...background, picture: '' });
  });

  it('keeps a robot that stands in a wall or outside: half-done work can be saved', () => {
    expect(sceneOf(changed({ robot: { at: [900, 450] } })).robot.at).toEqual([900, 450]);
    expect(sceneOf(changed({ robot: { at: [-500, 450] } })).robot.at).toEqual([-500, 450]);
  });

  it('is not too long to be read again if it holds the largest course there can be', () => {
    const unprintable = '\u0001'.repeat(96); // six characters each in a file
    const base64 = 'A'.repeat(sceneLimits.pictureCharacters - 40);
    const options = Array.from({ length: sceneLimits.options }, (_, index) => [`${unprintable}${index}`, unprintable]);
    const labels = Array.from({ length: sceneLimits.objects - 1 }, (_, index) => ({
      ...{
        type: 'label',
        id: `${unprintable}${index}`,
        at: [-20_000, -20_000],
        text: unprintable,
        height: 500,
        angle: 315,
      },
    }));
    const points = Array.from({ length: sceneLimits.points }, () => [-20_000, -20_000]);
    const scene = sceneOf({
      ...{ format: 'parcours-scene', version: 2, description: '\u0001'.repeat(sceneLimits.descriptionCharacters) },
      robot: { options: Object.fromEntries(options) as unknown },
      background: { ...background, levels: base64, picture: `data:image/png;base64,${base64}` },
      objects: [{ type: 'stroke', id: 's', points }, ...labels],
    });
    const text = serializeScene(scene);
    expect(text.length).toBeGreaterThan(6_500_000);
    expect(parseScene(text)).toHaveProperty('scene');
  });

  it('may begin with a byte order mark', () => {
    expect(parseScene(`\ufeff${JSON.stringify(full)}`)).toHaveProperty('scene');
  });
});
