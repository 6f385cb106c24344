import { describe, expect, it } from 'vitest';
import { parseScene } from '#scene/parse';
import type { Paper, Scene, Stroke } from '#scene/scene';
import { serializeScene } from '#scene/serialize';
import { courseOfMap } from './course-of-map';
import { readMap } from './read-map';
import { mapNoteText } from './say';
import { demoMap, exit, mapFile, straight, tileOf } from './testing/maps';

const made = (file: unknown, rules?: Parameters<typeof courseOfMap>[1]) => {
  const read = readMap(file);
  return 'map' in read ? courseOfMap(read.map, rules) : expect.fail(read.problem);
};
const strokes = ({ objects }: Scene) => objects.filter((object): object is Stroke => object.type === 'stroke');
const papers = ({ objects }: Scene, color: string) =>
  objects.filter((object): object is Paper => object.type === 'paper' && object.color === color);

describe('the course of a map', () => {
  const { scene, notes } = made(demoMap());

  it('is as large as its tiles, and the robot stands on the first, in the direction of the way', () => {
    expect(scene).toMatchObject({ name: 'Demo', size: [900, 900], robot: { at: [150, 750], heading: 0 }, task: { seconds: 480 } }); // prettier-ignore
    expect(notes).toEqual([]);
  });

  it('has a line from edge to edge of its tiles, its gap as long as in the editor', () => {
    const [across, before, behind, bend] = strokes(scene);
    expect(across?.points).toEqual([[0, 750], [300, 750]]); // prettier-ignore
    // Round ends of 10 mm: black up to 350, and again from 400 on.
    expect([before?.points[1], behind?.points[0]]).toEqual([[340, 750], [410, 750]]); // prettier-ignore
    expect([bend?.points[0], bend?.points[6], bend?.points.at(-1)]).toEqual([[600, 750], [706, 706], [750, 600]]); // prettier-ignore
  });

  it('has an obstacle on the line that sensors see, and a red strip across its end', () => {
    expect(scene.objects).toContainEqual(expect.objectContaining({ type: 'fixed-block', at: [450, 150], height: 150 }));
    expect(papers(scene, 'red')).toMatchObject([{ at: [150, 150], size: [25, 300] }]);
  });

  it('survives its file', () => {
    expect(parseScene(serializeScene(scene))).toEqual({ scene });
  });
});

describe('a crossing', () => {
  const TEE = { left: 'top', right: 'left', top: 'left' };
  const around = (paths: object, rot = 0): Scene =>
    made(mapFile({ '0,1,0': straight(), '1,1,0': tileOf('tile-15', rot, paths as Record<string, string>, { type: { intersections: 1 } }), '1,0,0': exit(0) }, { startTile: { x: 0, y: 1, z: 0 } })).scene; // prettier-ignore

  it('has a mark of 25 mm before it, on the side to which it turns', () => {
    expect(papers(around(TEE), 'green')).toMatchObject([{ at: [428, 473], size: [25, 25] }]);
  });

  it('has two where one has to turn round', () => {
    const marks = papers(around({ left: 'top', right: 'top', top: 'top' }), 'green').map(({ at }) => at);
    expect(marks).toHaveLength(2);
    expect(marks).toEqual(expect.arrayContaining([[428, 473], [473, 473]])); // prettier-ignore
  });

  it('has none where all go straight on', () => {
    expect(papers(around({ left: 'right', right: 'left', top: 'bottom', bottom: 'top' }), 'green')).toEqual([]);
  });
});

describe('the evacuation zone', () => {
  const zone = tileOf('ev1', 0, {});
  const tiles = Object.fromEntries(
    [0, 1, 2].flatMap((y) => [1, 2, 3, 4].map((x) => [`${String(x)},${String(y)},0`, zone])),
  );
  const map = mapFile(
    { ...tiles, '0,0,0': straight(), '4,3,0': straight(90), '4,4,0': exit(180) },
    { startTile2: { x: 4, y: 3, z: 0 }, width: 6, length: 5 },
  );

  it('has walls but for its two openings, with a silver and a black strip', () => {
    const { scene } = made(map);
    expect(scene.league?.zone).toEqual({ at: [900, 1050], size: [1200, 900] });
    expect(scene.league?.tiles.map(({ at, afterZone }) => [...at, afterZone ?? false])).toEqual([[150, 1350, false], [1350, 450, true], [1350, 150, false]]); // prettier-ignore
    expect(papers(scene, 'silver')).toMatchObject([{ at: [300, 1350], size: [25, 250] }]);
    expect(papers(scene, 'black')).toMatchObject([{ at: [1350, 600], size: [250, 25] }]);
    // Left two of three, below three of four, right three; the arena’s edge is above.
    expect(scene.objects.filter(({ type }) => type === 'wall')).toHaveLength(2 + 3 + 3);
  });

  it('has two living victims and a dead one, always in the same places, and a safe place for each', () => {
    const { scene } = made(map);
    const victims = scene.objects.flatMap((object) => (object.type === 'block' ? [object] : []));
    expect(victims.map(({ color }) => color)).toEqual(['silver', 'silver', 'black']);
    expect(made(map).scene).toEqual(scene);
    for (const color of ['green', 'red'])
      expect(papers(scene, color).filter(({ corners }) => corners !== undefined)).toMatchObject([{ size: [300, 300] }]);
  });

  it('has cans on green discs and one black safe place in the entry league', () => {
    const { scene } = made({ ...map, victims: { live: 2, dead: 0 } }, 'line-entry-2026');
    expect(papers(scene, 'green')).toMatchObject([{ round: true }, { round: true }]);
    expect(papers(scene, 'black').filter(({ corners }) => corners !== undefined)).toHaveLength(1);
  });
});

describe('what a course cannot be', () => {
  it('is told: seesaws, bumps, ramps, floors, and lines that are drawn otherwise', () => {
    const { notes } = made(
      mapFile({
        '0,0,0': straight(0, { type: { seesaw: 1 } }),
        '1,0,0': straight(0, { items: { speedbumps: 2, rampPoints: true } }),
        '2,0,0': tileOf('tile-13', 0, { left: 'right', right: 'left' }, { levelUp: 'right' }),
        '2,0,1': straight(),
      }),
    );
    expect(notes.map(({ code }) => code)).toEqual(['seesaw', 'bumps', 'ramp', 'floors', 'upstairs', 'drawn']);
    expect(mapNoteText(notes[5]!, 'en')).toBe('Some tiles look otherwise, but lead the same way (1; tile-13).');
    expect(mapNoteText(notes[0]!, 'de')).toBe('Parcours sind flach: Wippen sind als Linie gezeichnet (1).');
  });

  it('tells of a seesaw once, whatever its picture is called', () => {
    const seesaw = tileOf('seesaw', 0, { left: 'right', right: 'left' }, { type: { seesaw: 1 } });
    expect(made(mapFile({ '0,0,0': straight(), '1,0,0': seesaw })).notes.map(({ code }) => code)).not.toContain(
      'drawn',
    );
  });

  it('is told of a line that leads nowhere', () => {
    const { notes } = made(mapFile({ '0,0,0': straight(), '1,0,0': straight() }));
    expect(notes).toEqual([{ code: 'open', params: { x: 1, y: 0 } }]);
  });
});
