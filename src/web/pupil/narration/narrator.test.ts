// @vitest-environment happy-dom
import { afterEach, describe, expect, it } from 'vitest';

import type { SceneObject, Wall } from '#scene/scene';

import { samples } from '../../app/testing/editing';
import { showLanguage } from '../../kit/i18n';
import { createNarrator } from './narrator';
import { courseWith, seen, told, type Changes } from './testing/drive';

const wall: Wall = { type: 'wall', id: 'w', from: [700, 0], to: [700, 900], thickness: 10 };
const START = '0 Start bei x 20, y 45 cm, Richtung 0 Grad.';

describe('what is told of a drive', () => {
  afterEach(() => showLanguage('de'));

  it('begins with where the robot stands, what is ahead and whether it is on a line', () => {
    expect(told(courseWith(wall), [[0, { aheadMm: 437 }]], 3000)).toEqual([`${START} Wand 44 cm voraus.`]);
    expect(told(courseWith(samples.stroke), [[0, { headingDeg: -90, line: [1, 1] }]], 3000)).toEqual([
      '0 Start bei x 20, y 45 cm, Richtung -90 Grad. Beide Sensoren auf der Linie.',
    ]);
  });

  it('is the nearest that a lidar sees at eye level where there is no distance sensor, and that on the right by its place', () => {
    const lidarMm = [900, 900, 900, 900, 900, 320, 230, 180];
    const seen = { aheadMm: undefined, lidarMm };
    const block = { type: 'block', id: 'b', at: [470, 350], size: [60, 60], angle: 0 } as const;
    expect(
      told(
        courseWith(wall, block),
        [
          [0, { aheadMm: undefined }],
          [2500, seen],
        ],
        3000,
      ),
    ).toEqual([START]);
    const before = { aheadMm: undefined, lidarMm: lidarMm.map(() => null) };
    expect(told(courseWith(wall, block), [[0, before], [2500, seen]], 3000)).toEqual([START, '2500 Block 18 cm voraus.']); // prettier-ignore
  });

  it('says where the robot is when it is switched on in the middle of a run', () => {
    expect(told(courseWith(), [[0, { timeUs: 9_000_000 }]], 0)).toEqual([
      '0 Der Roboter ist bei x 20, y 45 cm, Richtung 0 Grad.',
    ]);
  });

  it('tells what comes nearer, at 50, 30, 20 and 10 cm, with the distance as it is when it is said', () => {
    const drive = Array.from({ length: 110 }, (_, i): [number, Changes] => [i * 100, { xMm: 200 + 3 * i, pathMm: 3 * i, aheadMm: 440 - 4 * i }]); // prettier-ignore
    expect(told(courseWith(wall), drive, 10_900)).toEqual([
      `${START} Wand 44 cm voraus.`,
      '3600 Wand 30 cm voraus.',
      '6100 Wand 20 cm voraus.',
      '8600 Wand 10 cm voraus.',
    ]);
  });

  it('tells the colour that a colour sensor has come onto, and not what shows for a moment on the border', () => {
    const drive: (readonly [number, Changes])[] = [
      [0, { colour: 'white' }],
      [3000, { colour: 'gray' }],
      [3100, { colour: 'red' }],
      [6000, { colour: 'white' }],
    ];
    expect(told(courseWith(), drive, 7000)).toEqual([START, '3400 Farbsensor: Rot.', '6300 Farbsensor: Weiss.']);
  });

  it('tells what a camera finds, once, and that it finds nothing any more', () => {
    const drive: (readonly [number, Changes])[] = [
      [0, { camera: [] }],
      [3000, { camera: [5] }],
      [3500, { camera: [] }],
      [3800, { camera: [7, 5] }],
      [12_000, { camera: ['line'] }],
      [18_000, { camera: [] }],
    ];
    expect(told(courseWith(), drive, 20_000)).toEqual([
      START,
      '3000 Kamera: ID 5.',
      '7000 Kamera: ID 5, 7.',
      '12000 Kamera: eine Linie.',
      '18500 Kamera: nichts mehr.',
    ]);
  });

  it('names what is ahead as the course does, the edge of the arena too', () => {
    const course = courseWith({ ...samples.block, at: [500, 450] });
    expect(told(course, [[0, {}], [2500, { aheadMm: 220 }]], 3000)).toEqual([START, '2500 Block 22 cm voraus.']); // prettier-ignore
    expect(
      told(
        courseWith(),
        [
          [0, {}],
          [2500, { xMm: 900, pathMm: 1, aheadMm: 242 }],
        ],
        3000,
      ),
    ).toEqual([START, '2500 Rand der Arena 24 cm voraus.']);
  });

  it('says nothing of distances that jump a little, nor of a robot without such a sensor', () => {
    const sways = Array.from({ length: 80 }, (_, i): [number, Changes] => [i * 100, { aheadMm: i % 2 === 0 ? 295 : 310 }]); // prettier-ignore
    expect(told(courseWith(wall), sways, 8000)).toHaveLength(1);
    expect(told(courseWith(wall), [[0, { aheadMm: undefined }]], 8000)).toEqual([START]);
  });

  it('says that the way is clear again once something was near', () => {
    const drive = [[0, {}], [2500, { aheadMm: 150 }], [5000, { aheadMm: null }]] as const; // prettier-ignore
    expect(told(courseWith(wall), drive, 8000).slice(1)).toEqual(['2500 Wand 15 cm voraus.', '5000 Vorn ist frei.']);
  });

  it('leaves out what is far away again by the time it could be said', () => {
    const touched = { touches: 1, aheadMm: 90, xMm: 600, pathMm: 9 };
    const drive = [[0, {}], [2500, touched], [4000, { ...touched, aheadMm: 790 }]] as const; // prettier-ignore
    expect(told(courseWith(wall), drive, 5000).slice(1)).toEqual([
      '2500 Stösst vorn an eine Wand.',
      '4500 Vorn ist frei.',
    ]);
  });

  it('tells which of two sensors is on the line, and when it is lost', () => {
    const drive = [[0, {}], [2500, { line: [1, 0] }], [7000, { line: [1, 1] }], [12_000, {}]] as const; // prettier-ignore
    expect(told(courseWith(samples.stroke), drive, 15_000).slice(1)).toEqual([
      '2500 Linker Sensor auf der Linie.',
      '7000 Beide Sensoren auf der Linie.',
      '12500 Linie verloren.',
    ]);
  });

  it('names each of five sensors', () => {
    const drive = [[0, { line: [0, 0, 0, 0, 0] }], [2500, { line: [0, 1, 1, 0, 0] }], [7000, { line: [1, 1, 1, 1, 1] }]] as const; // prettier-ignore
    expect(told(courseWith(samples.stroke), drive, 9000).slice(1)).toEqual([
      '2500 Auf der Linie: L1, M.',
      '7000 Alle Sensoren auf der Linie.',
    ]);
  });

  it('says of a robot that follows a line and sways on it once that it is on it', () => {
    const drive = Array.from({ length: 200 }, (_, i): [number, Changes] => [i * 100, { line: [[1, 0], [0, 0], [0, 1], [0, 0]][i % 4] as [0, 1] }]); // prettier-ignore
    const sentences = told(courseWith(samples.stroke), drive, 20_000);
    expect(sentences.slice(1)).toEqual(['2000 Beide Sensoren auf der Linie.']);
  });

  it('speaks of dark and light where no line lies', () => {
    expect(
      told(
        courseWith(),
        [
          [0, {}],
          [2500, { line: [0, 1] }],
        ],
        3000,
      )[1],
    ).toBe('2500 Rechter Sensor auf Dunkel.');
  });

  it('tells what the robot bumps into and with which side', () => {
    const into = (changes: Changes, ...course: readonly SceneObject[]) =>
      told(courseWith(...course), [[0, {}], [2500, { ...changes, touches: 1 }]], 3000)[1]; // prettier-ignore
    expect(into({ xMm: 637 }, wall)).toBe('2500 Stösst vorn an eine Wand.');
    expect(into({ xMm: 637, headingDeg: 180 }, wall)).toBe('2500 Stösst hinten an eine Wand.');
    expect(into({ xMm: 330, yMm: 200 }, samples.block)).toBe('2500 Stösst vorn an einen Block.');
    expect(into({ yMm: 860, headingDeg: 0 })).toBe('2500 Stösst links an den Rand der Arena.');
  });

  it('names checkpoints by their numbers, and counts targets where there are several', () => {
    const at = (number: number) => ({ ...samples.checkpoint, id: `c${String(number)}`, number });
    const of = (passed: number, reached = 0) => ({
      verdict: { checkpoints: { passed, of: 2 }, targets: { reached, of: 2 } },
    });
    const drive = [[0, of(0)], [2500, of(1)], [5000, of(2)], [7500, of(2, 1)]] as const; // prettier-ignore
    expect(told(courseWith(at(7), at(3)), drive, 9000).slice(1)).toEqual([
      '2500 Kontrollpunkt 3 erreicht.',
      '5000 Kontrollpunkt 7 erreicht.',
      '7500 Ziel erreicht, 1 von 2.',
    ]);
  });

  it('leaves the verdict its words: what decides the task is not told twice, and there is time for them', () => {
    const drive = [
      [0, { verdict: { targets: { reached: 0, of: 1 } } }],
      [2500, { verdict: { state: 'passed', targets: { reached: 1, of: 1 } }, aheadMm: 90, pathMm: 9 }],
    ] as const;
    expect(told(courseWith(wall), drive, 9000).slice(1)).toEqual([
      '6500 Wand 9 cm voraus.',
      '8500 Der Roboter steht: x 20, y 45 cm, Richtung 0 Grad. Wand 9 cm voraus.',
    ]);
  });

  it('forgets what still waited when the task is decided', () => {
    const of = (passed: number, state: 'open' | 'passed') => ({ verdict: { state, checkpoints: { passed, of: 2 } } });
    const drive = [[0, of(0, 'open')], [500, of(1, 'open')], [1000, of(2, 'passed')]] as const; // prettier-ignore
    expect(told(courseWith(samples.checkpoint), drive, 9000)).toEqual([START]);
  });

  it('tells a turn when it has become one, and by how much when it is over', () => {
    const turn = Array.from({ length: 31 }, (_, i): [number, Changes] => [2500 + i * 100, { turnedDeg: -3 * i }]);
    expect(told(courseWith(), [[0, {}], ...turn], 9000).slice(1)).toEqual([
      '3400 Dreht nach rechts.',
      '6000 Um 90 Grad nach rechts gedreht.',
      '8000 Der Roboter steht: x 20, y 45 cm, Richtung 0 Grad.',
    ]);
  });

  it('says where the robot has stopped, once', () => {
    const drive = Array.from({ length: 30 }, (_, i): [number, Changes] => [i * 100, { xMm: 200 + 20 * i, pathMm: 20 * i }]); // prettier-ignore
    expect(told(courseWith(), drive, 20_000)).toEqual([
      START,
      '4400 Der Roboter steht: x 78, y 45 cm, Richtung 0 Grad.',
    ]);
  });

  it('says at once where the robot stands when the run is stopped, and nothing of what waited', () => {
    const narrator = createNarrator(() => ({ scene: courseWith(wall), body: [] }));
    narrator.see(seen({}), 0);
    narrator.see(seen({ aheadMm: 95, touches: 1 }), 100);
    narrator.end(100);
    expect(narrator.next(100)).toBe('Der Roboter steht: x 20, y 45 cm, Richtung 0 Grad. Wand 10 cm voraus.');
    expect(narrator.isWaiting).toBe(false);
  });

  it('speaks the language of the page', () => {
    showLanguage('en');
    expect(told(courseWith(wall), [[0, { aheadMm: 437 }]], 0)).toEqual([
      '0 Starting at x 20, y 45 cm, heading 0 degrees. Wall 44 cm ahead.',
    ]);
    showLanguage('fr');
    expect(told(courseWith(wall), [[0, { aheadMm: 437 }]], 0)[0]).toContain('Mur devant, à 44 cm.');
    showLanguage('it');
    expect(told(courseWith(wall), [[0, { aheadMm: 437 }]], 0)[0]).toContain('Muro davanti a 44 cm.');
  });
});
