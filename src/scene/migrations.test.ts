import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { parseScene } from './parse';
import { SCENE_VERSION, type Point, type Scene } from './scene';
import { serializeScene } from './serialize';

const kept = (version: number): string => readFileSync(new URL(`./kept/v${version}.json`, import.meta.url), 'utf8');

function sceneOf(text: string): Scene {
  const parsed = parseScene(text);
  if (!('scene' in parsed)) throw new Error(parsed.problem);
  return parsed.scene;
}

const version1: Scene = {
  name: 'Alles der ersten Fassung',
  description: 'Wände, Klötze und Linien.\nZwei Zeilen.',
  size: [1400, 1000],
  board: 'calliope-mini-3',
  robot: { type: 'callibot', at: [300, 500], heading: -90, scale: 1.5, options: { S1: 'claw' } },
  task: { seconds: null, noTouch: false },
  background: null,
  objects: [
    { id: 'w1', type: 'wall', from: [900, 200], to: [900, 700], thickness: 10 },
    { id: 'w2', type: 'wall', from: [-50, 0], to: [200, 250], thickness: 12 },
    { id: 'b1', type: 'block', at: [600, 300], size: [50, 50], angle: 0 },
    { id: 'b2', type: 'block', at: [700, 300], size: [40, 60], angle: 45 },
    { id: 'f1', type: 'fixed-block', at: [1200, 800], size: [100, 80], angle: 315 },
    {
      ...{ id: 's1', type: 'stroke', width: 20, color: 'black' },
      points: [
        [100, 100],
        [400, 100],
        [400, 300],
      ],
    },
    { id: 's2', type: 'stroke', points: [[500, 900]], width: 30, color: 'gray' },
    {
      ...{ id: 's3', type: 'stroke', width: 15, color: 'white' },
      points: [
        [100, 100],
        [150, 120],
      ],
    },
  ],
};

const short: readonly [readonly [number, number], readonly [number, number]] = [
  [1, 2],
  [3, 4],
];

const version2: Scene = {
  name: 'Alles der zweiten Fassung',
  description: 'Dazu Felder, Stacheln, Wanderblöcke, Schrift, Farben, Aufgabe und Hintergrund.',
  size: [1400, 1000],
  board: 'microbit-v2',
  robot: { type: 'maqueen-plus-v2', at: [300, 500], heading: 12.5, scale: 0.5, options: { model: '2E' } },
  task: { seconds: 62.5, noTouch: true },
  background: {
    at: [-10, 20],
    size: [400, 300],
    cells: [4, 3],
    levels: 'Y2BkYmZhZWPn4OTjBwA=',
    picture: 'data:image/png;base64,iVBORw0KGgo=',
  },
  objects: [
    { id: 'w1', type: 'wall', from: [900, 200], to: [900, 700], thickness: 20 },
    { id: 'b1', type: 'block', at: [600, 300], size: [50, 50], angle: 135 },
    { id: 'f1', type: 'fixed-block', at: [1200, 800], size: [100, 80], angle: 0 },
    {
      ...{ id: 's1', type: 'stroke', width: 25, color: 'red' },
      points: [
        [100, 100],
        [400, 100],
        [400, 300],
      ],
    },
    { id: 's2', type: 'stroke', points: [[500, 900]], width: 20, color: 'blue' },
    { id: 's3', type: 'stroke', points: short, width: 20, color: 'yellow' },
    { id: 's4', type: 'stroke', points: short, width: 20, color: 'green' },
    { id: 't1', type: 'target', at: [1200, 200], size: [200, 150], angle: 45, round: true, number: 0, blocks: 0 },
    { id: 't2', type: 'target', at: [1000, 200], size: [200, 200], angle: 0, round: false, number: 0, blocks: 1 },
    { id: 'c1', type: 'checkpoint', at: [300, 200], size: [150, 150], angle: 0, round: false, number: 1, blocks: 0 },
    { id: 'c2', type: 'checkpoint', at: [600, 200], size: [150, 100], angle: 90, round: true, number: 99, blocks: 0 },
    { id: 'x1', type: 'forbidden', at: [100, 800], size: [150, 150], angle: 0, round: true, number: 0, blocks: 0 },
    { id: 'p1', type: 'spikes', at: [700, 700], size: [60, 40], angle: 225 },
    { id: 'm1', type: 'mover', at: [500, 500], size: [60, 60], angle: 0, to: [800, 500], speed: 100, spiked: false },
    { id: 'm2', type: 'mover', at: [500, 600], size: [60, 60], angle: 45, to: [500, 900], speed: 250, spiked: true },
    { id: 'l1', type: 'label', at: [300, 50], text: 'Start ▸ «hier» 🤖', height: 30, angle: 0 },
    { id: 'l2', type: 'label', at: [300, 950], text: 'Ziel', height: 60, angle: 90 },
  ],
};

const version3: Scene = {
  ...version2,
  name: 'Alles der dritten Fassung',
  task: {
    seconds: 62.5,
    noTouch: true,
    allows: ['hand', 'edits'],
    stars: [40, 25.5],
    card: {
      language: 'de',
      title: 'Bis ins Ziel',
      hints: ['Schau auf die **Linie**.', '`irLeft` gibt 0 auf Schwarz.\n\n- links\n- rechts'],
      translations: [
        { language: 'fr', title: 'Jusqu’au but', hints: ['Regarde la ligne.'], text: 'Suis la **ligne**.' },
        { language: 'en', title: '', hints: [], text: '' },
      ],
      picture: 'data:image/png;base64,iVBORw0KGgo=',
      solution: true,
    },
  },
  objects: [
    { id: 't1', type: 'target', at: [1200, 200], size: [200, 150], angle: 0, round: false, number: 0, blocks: 0 },
  ],
};

const version4: Scene = {
  ...version2,
  name: 'Starts der vierten Fassung',
  description: '',
  background: null,
  task: { seconds: null, noTouch: false, robots: 'catch' },
  objects: [
    {
      ...{ id: 'r2', type: 'start', at: [300, 200], heading: -45.5, robot: 'callibot', options: { S1: 'claw' } },
      ...{ name: 'Ärzt «2»', color: 'teal' },
    },
    { id: 'r3', type: 'start', at: [300, 800], heading: 0, robot: null, options: {}, name: '', color: null },
  ],
};

const shapes = { type: 'target' as const, number: 0, blocks: 0, at: [1200, 200] as Point };
const square = [[0, 0], [200, 0], [200, 200], [100, 80], [0, 200]] as Point[]; // prettier-ignore

const version5: Scene = {
  ...version1,
  name: 'Formen der fünften Fassung',
  description: '',
  board: null,
  robot: { type: null, at: [300, 500], heading: 0, scale: 1, options: {} },
  objects: [
    { id: 'b1', type: 'block', at: [600, 300], size: [66, 66], angle: 0, round: true },
    { id: 'b2', type: 'block', at: [700, 300], size: [40, 60], angle: 12.5, lock: true },
    {
      ...{ id: 'b3', type: 'block', at: [800, 300], size: [80, 60], angle: 45 },
      corners: [[0, 0], [80, 0], [40, 60]], // prettier-ignore
    },
    {
      ...{ id: 'f1', type: 'fixed-block', at: [1200, 800], size: [100, 80], angle: 315, lock: true, group: 'g1' },
      corners: [[0, 0], [10, 0], [10, 4], [4, 4], [4, 8], [0, 8]], // prettier-ignore
    },
    { id: 'f2', type: 'fixed-block', at: [1200, 600], size: [20, 20], angle: 0, round: true, group: 'g1' },
    { id: 'p1', type: 'spikes', at: [700, 700], size: [60, 40], angle: 200.1, round: true },
    {
      ...{ id: 'p2', type: 'spikes', at: [900, 700], size: [60, 60], angle: 0 },
      corners: [[-30, -30], [30, -30], [0, 30]], // prettier-ignore
    },
    {
      ...{ id: 'm1', type: 'mover', at: [500, 500], size: [60, 50], angle: 75, to: [800, 500], round: true },
      ...{ speed: 100, spiked: false },
    },
    {
      ...{
        id: 'm2',
        type: 'mover',
        at: [500, 700],
        size: [60, 60],
        angle: 0,
        to: [600, 700],
        spiked: false,
        speed: 150,
      },
      ...{ stops: [[600, 900], [500, 900]], waits: [0, 1.5, 2], loops: true, phase: 0.5, spin: -45 }, // prettier-ignore
    },
    {
      ...{
        id: 'm3',
        type: 'mover',
        at: [900, 900],
        size: [60, 60],
        angle: 0,
        to: [900, 900],
        spiked: true,
        speed: 100,
      },
      chases: { zone: 't1', reach: 700 },
    },
    { ...shapes, id: 't1', size: [200, 150], angle: 30, round: true },
    { ...shapes, id: 't2', at: [1000, 200], size: [200, 200], angle: 90, round: false, corners: square, blocks: 1 },
    {
      ...shapes,
      id: 'c1',
      type: 'checkpoint',
      at: [300, 200],
      size: [150, 150],
      angle: 359.9,
      round: false,
      number: 1,
    },
    {
      ...{ ...shapes, id: 'x1', type: 'forbidden', at: [100, 800], size: [150, 150], angle: 0, round: false },
      corners: [[0, 0], [3, 0], [0, 3]], // prettier-ignore
    },
    { id: 'l1', type: 'label', at: [300, 50], text: 'schräg', height: 30, angle: 10 },
    { id: 'w1', type: 'wall', from: [900, 100], to: [900, 150], thickness: 10, lock: true },
    { id: 's1', type: 'stroke', points: [[100, 100], [400, 100]], width: 20, color: 'black', group: 'g2' }, // prettier-ignore
    {
      ...{ id: 'r2', type: 'start', at: [300, 800], heading: 0, robot: null, options: {}, name: '', color: null },
      group: 'g2',
    },
  ],
};

const version6: Scene = {
  ...version5,
  name: 'Zwei Namen der sechsten Fassung',
  size: [1200, 900],
  robot: { type: 'callibot', at: [200, 450], heading: 90, scale: 1, options: {}, name: 'Ada', color: 'teal' },
  objects: [
    { id: 'b1', type: 'block', at: [600, 300], size: [66, 66], angle: 45 },
    { id: 'r2', type: 'start', at: [300, 800], heading: 0, robot: null, options: {}, name: 'Bo', color: 'pink' },
  ],
};

const version7: Scene = {
  ...version6,
  name: 'Höhen der siebten Fassung',
  robot: { type: null, at: [200, 450], heading: 0, scale: 1, options: {}, name: 'Ada' },
  objects: [
    { id: 'w1', type: 'wall', from: [900, 200], to: [900, 700], thickness: 20, height: 1000 },
    { id: 'w2', type: 'wall', from: [100, 200], to: [100, 700], thickness: 10, height: 5 },
    { id: 'b1', type: 'block', at: [600, 300], size: [66, 66], angle: 12.5, round: true, height: 30, lock: true },
    {
      ...{ id: 'f1', type: 'fixed-block', at: [700, 300], size: [40, 60], angle: 0, height: 60 },
      corners: [[0, 0], [40, 0], [20, 60]], // prettier-ignore
    },
    { id: 'f2', type: 'fixed-block', at: [700, 500], size: [40, 60], angle: 0 },
    { id: 'p1', type: 'spikes', at: [500, 700], size: [60, 40], angle: 0, height: 20 },
    {
      ...{ id: 'm1', type: 'mover', at: [300, 700], to: [300, 800], size: [60, 60], angle: 0, height: 39 },
      ...{ speed: 100, spiked: true },
    },
    { id: 'l1', type: 'label', at: [300, 50], text: 'niedrig', height: 60, angle: 0 },
  ],
};

const version8: Scene = {
  ...version1,
  description: '',
  size: [1200, 900],
  board: null,
  name: 'Farben der achten Fassung',
  robot: { type: null, at: [200, 450], heading: 0, scale: 1, options: {}, name: 'Ada' },
  ambient: 40,
  objects: [
    { id: 'a1', type: 'paper', at: [300, 100], size: [110, 110], angle: 12.5, color: 'green' },
    {
      ...{ id: 'a2', type: 'paper', at: [450, 100], size: [110, 80], angle: 0, round: true },
      ...{ color: 'silver', infrared: 1.4 },
    },
    {
      ...{ id: 'a3', type: 'paper', at: [600, 100], size: [100, 100], angle: 0, color: 'white', lock: true },
      corners: [[0, 0], [40, 0], [20, 60]], // prettier-ignore
    },
    {
      ...{ id: 't1', type: 'target', at: [1000, 200], size: [200, 200], angle: 0, round: false, number: 0 },
      ...{ blocks: 2, blockColor: 'red', color: 'red' },
    },
    {
      ...{ id: 'c1', type: 'checkpoint', at: [800, 700], size: [150, 150], angle: 0, round: false, number: 1 },
      ...{ blocks: 0, color: 'gray', infrared: 0.5 },
    },
    {
      ...{ id: 'x1', type: 'forbidden', at: [500, 500], size: [100, 100], angle: 0, round: false, number: 0 },
      ...{ blocks: 0, infrared: 0 },
    },
    { id: 's1', type: 'stroke', points: [[100, 300], [400, 300]], width: 20, color: 'orange' },
    { id: 's2', type: 'stroke', points: [[100, 350], [400, 350]], width: 20, color: 'blue', infrared: 0.8 },
    { id: 's3', type: 'stroke', points: [[100, 400], [400, 400]], width: 20, color: 'red' },
    {
      ...{ id: 'w1', type: 'wall', from: [900, 400], to: [900, 800], thickness: 10, height: 100 },
      ...{ color: 'brown', infrared: 0.84 },
    },
    { id: 'b1', type: 'block', at: [600, 300], size: [66, 66], angle: 0, color: 'purple' },
    { id: 'f1', type: 'fixed-block', at: [700, 300], size: [40, 60], angle: 0, color: 'black' },
    { id: 'f2', type: 'fixed-block', at: [700, 500], size: [40, 60], angle: 0 },
    {
      ...{ id: 'b2', type: 'block', at: [600, 400], size: [40, 40], angle: 0, round: true },
      ...{ mass: 2.7, friction: 0.01, rolls: true },
    },
    { id: 'i1', type: 'lamp', at: [100, 800], height: 260, brightness: 40 },
    {
      ...{ id: 'i2', type: 'lamp', at: [150, 800], height: 120, brightness: 0.5, color: 'red' },
      on: { time: [3, 1.5] },
    },
    { id: 'i3', type: 'lamp', at: [200, 800], height: 260, brightness: 40, on: { radio: ['an', 'aus'] } },
    { id: 'i4', type: 'lamp', at: [250, 800], height: 260, brightness: 40, on: { pin: 'P2' } },
    { id: 'g1', type: 'barrier', from: [300, 800], to: [500, 800], thickness: 10, height: 80, opens: 'hand' },
    { id: 'g2', type: 'barrier', from: [300, 850], to: [500, 850], thickness: 6, opens: { button: 'b' } },
    { id: 'h1', type: 'tunnel', at: [1000, 500], size: [300, 150], angle: 30 },
    { id: 'k1', type: 'tag', at: [700, 700], number: 7, side: 60, angle: 0 },
    { id: 'k2', type: 'tag', at: [700, 800], number: 99, side: 40, angle: 90, flat: true },
  ], // prettier-ignore
};

describe('a course file of an older version', () => {
  it.each([
    [1, version1],
    [2, version2],
    [3, version3],
    [4, version4],
    [5, version5],
    [6, version6],
    [7, version7],
    [8, version8],
  ])('version %d is read with everything in it', (version, scene) => {
    expect(sceneOf(kept(version))).toEqual(scene);
  });

  it('is kept for every version there ever was', () => {
    for (let version = 1; version <= SCENE_VERSION; version++) expect(kept(version)).toContain(`"version": ${version}`);
  });

  it('is written in version 2, which older apps read, unless it says what is new later; letter by letter as it was', () => {
    expect(serializeScene(sceneOf(kept(1)))).toContain('"version": 2');
    expect(sceneOf(serializeScene(sceneOf(kept(1))))).toEqual(version1);
    expect(serializeScene(sceneOf(kept(2)))).toBe(kept(2));
    expect(serializeScene(sceneOf(kept(3)))).toBe(kept(3));
    expect(serializeScene(sceneOf(kept(4)))).toBe(kept(4));
    expect(serializeScene(sceneOf(kept(5)))).toBe(kept(5));
    expect(serializeScene(sceneOf(kept(6)))).toBe(kept(6));
    expect(serializeScene(sceneOf(kept(7)))).toBe(kept(7));
    expect(serializeScene(sceneOf(kept(8)))).toBe(kept(8));
  });

  it('says rotations in eighths of a turn, which older apps read, until one of its things needs more', () => {
    const objects = sceneOf(kept(2)).objects.filter(({ id }) => id === 'b1' || id === 'l2');
    const text = serializeScene({ ...version2, objects });
    expect(text).toContain('"version": 2');
    expect(text).toContain('"id": "b1", "type": "block", "at": [600, 300], "size": [50, 50], "turn": 3 }');
    const locked = serializeScene({ ...version2, objects: objects.map((object) => ({ ...object, lock: true })) });
    expect(locked).toContain('"version": 5');
    expect(locked).toContain('"size": [50, 50], "angle": 135, "lock": true }');
  });

  it('is written in version 7 only if a thing has a height of its own; letters have always had theirs', () => {
    const objects = version7.objects.filter((object) => object.type === 'label' || !('height' in object));
    expect(objects.map(({ id }) => id)).toEqual(['f2', 'l1']);
    expect(serializeScene({ ...version2, objects })).toContain('"version": 2');
    expect(serializeScene({ ...version7, objects })).toContain('"version": 6');
    for (const object of version7.objects.filter(({ id }) => /^[wbfpm]1$/.test(id)))
      expect(serializeScene({ ...version2, objects: [object] })).toContain('"version": 7');
  });

  it('is written in version 8 only if something in it is new there: a colour, an infrared, a coloured sheet', () => {
    const isOld = ({ id }: { readonly id: string }): boolean => id === 's3' || id === 'f2';
    expect(serializeScene({ ...version2, objects: version8.objects.filter(isOld) })).toContain('"version": 2');
    for (const object of version8.objects.filter((each) => !isOld(each)))
      expect(serializeScene({ ...version2, objects: [object] })).toContain('"version": 8');
  });

  it('is not written with the name of a group of which one thing is left', () => {
    const alone = { ...version5, objects: version5.objects.filter(({ id }) => id === 'f2') };
    expect(serializeScene(alone)).not.toContain('group');
  });
});
