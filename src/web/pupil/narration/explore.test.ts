// @vitest-environment happy-dom
import { afterEach, describe, expect, it } from 'vitest';

import { maqueenLite } from '#robots/maqueen-lite/type';
import type { SceneObject } from '#scene/scene';

import { samples } from '../../app/testing/editing';
import { showLanguage } from '../../kit/i18n';
import { createExplorer, tellAround, type Asked } from './explore';
import { courseWith } from './testing/drive';

/** A Maqueen Lite at x 60, y 45 cm that looks upwards, in a course with these things. */
const asked = (objects: readonly SceneObject[], changes: Partial<Asked> = {}): Asked => ({
  scene: courseWith(...objects),
  moved: {},
  robot: { xMm: 600, yMm: 450, headingRad: Math.PI / 2 },
  body: maqueenLite.body.outlineMm,
  crosshair: null,
  ...changes,
});

/** The announcements of a walk through the course. */
function walk(objects: readonly SceneObject[], steps: number, changes: Partial<Asked> = {}): readonly string[] {
  const explorer = createExplorer();
  return Array.from({ length: steps }, () => explorer.step(asked(objects, changes), false).words);
}

const HERE = 'Der Roboter ist bei x 60, y 45 cm, Richtung 90 Grad.';
const at = (x: number, y: number, number: number) => ({ ...samples.checkpoint, id: `c${String(number)}`, at: [x, y] as const, number }); // prettier-ignore

describe('a walk through the course in words', () => {
  afterEach(() => showLanguage('de'));

  it('begins with the robot and how much there is, and comes back to it', () => {
    expect(walk([], 2)).toEqual([`${HERE} Im Parcours liegt nichts.`, `${HERE} Im Parcours liegt nichts.`]);
    expect(walk([samples.wall], 3)).toEqual([
      `${HERE} Im Parcours liegt 1 Ding.`,
      'Wand 1, 20 cm lang; am nächsten 35 cm weiter hinten, 30 cm links.',
      `${HERE} Im Parcours liegt 1 Ding.`,
    ]);
  });

  it('tells name, size and place as the robot has it', () => {
    expect(walk([at(500, 800, 2)], 2)[1]).toBe('Kontrollpunkt 2, 10 mal 10 cm: 35 cm weiter vorn, 10 cm links.');
    expect(walk([at(700, 450, 1)], 2)[1]).toBe('Kontrollpunkt 1, 10 mal 10 cm: 10 cm rechts.');
    expect(walk([at(600, 452, 1)], 2)[1]).toBe('Kontrollpunkt 1, 10 mal 10 cm: genau hier.');
  });

  it('tells the height of what was made lower or higher than usual', () => {
    expect(walk([{ ...samples.block, at: [500, 800], height: 28 }], 2)[1]).toBe(
      'Block 1, 5 mal 5 cm, 2.8 cm hoch: 35 cm weiter vorn, 10 cm links.',
    );
    expect(walk([{ ...samples.wall, height: 1000 }], 2)[1]).toBe(
      'Wand 1, 20 cm lang, 100 cm hoch; am nächsten 35 cm weiter hinten, 30 cm links.',
    );
  });

  it('goes to checkpoints by their numbers first, then targets, lines, walls, blocks and the rest', () => {
    const all = Object.values(samples).filter(({ type }) => type !== 'checkpoint');
    const names = walk([...all, at(100, 100, 3), at(200, 100, 1)], 18).map((words) => words.split(/[,:;]/)[0]);
    expect(names.slice(1)).toEqual([
      ...['Kontrollpunkt 1', 'Kontrollpunkt 3', 'Ziel 1', 'Linie 1', 'Wand 1', 'Block 1', 'Fester Block 1'],
      ...['Fahrender Block 1', 'Stacheln 1', 'Verbotenes Feld 1'],
      ...[
        'Farbfeld 1',
        'Lampe 1',
        'Schranke 1',
        'Tunnel 1',
        'AprilTag 7',
        'Text «Hallo»',
        'Start eines Roboters «Ada»',
      ],
    ]);
  });

  it('goes back, too', () => {
    const explorer = createExplorer();
    const course = asked([at(500, 800, 1), at(500, 800, 2)]);
    expect(explorer.step(course, true).words).toContain('Kontrollpunkt 2');
    expect(explorer.step(course, true).words).toContain('Kontrollpunkt 1');
    expect(explorer.step(course, true).words).toContain('Der Roboter ist');
  });

  it('begins anew when the thing that was told of is gone', () => {
    const explorer = createExplorer();
    const course = asked([at(500, 800, 1), samples.wall]);
    expect([explorer.step(course, false), explorer.step(course, false)][1]?.words).toContain('Kontrollpunkt 1');
    expect(explorer.step(asked([samples.wall]), false).words).toBe(`${HERE} Im Parcours liegt 1 Ding.`);
  });

  it('tells blocks where they were pushed', () => {
    const moved = { block: { xMm: 600, yMm: 650, headingRad: 1 } };
    expect(walk([samples.block], 2, { moved })[1]).toBe('Block 1, 5 mal 5 cm: 20 cm weiter vorn.');
  });

  it('says how long and which colour a line is, and where it is nearest', () => {
    expect(walk([samples.stroke], 2)[1]).toBe('Linie 1, Schwarz, 20 cm lang; am nächsten 35 cm weiter vorn, 30 cm links.'); // prettier-ignore
  });

  it('has the place to be shown', () => {
    const explorer = createExplorer();
    const course = asked([at(500, 800, 1)]);
    expect(explorer.step(course, false).atMm).toEqual({ x: 600, y: 450 });
    expect(explorer.step(course, false).atMm).toEqual({ x: 500, y: 800 });
  });

  it('tells from the crosshair while one draws by keyboard, and without a robot from the middle', () => {
    const crosshair = { x: 100, y: 100 };
    expect(walk([samples.target], 2, { crosshair })).toEqual([
      'Fadenkreuz bei x 10, y 10 cm. Im Parcours liegt 1 Ding.',
      'Ziel 1, 15 mal 15 cm: 80 cm rechts, 60 cm weiter oben.',
    ]);
    expect(walk([samples.target], 2, { robot: null })).toEqual([
      'Mitte der Arena bei x 60, y 45 cm. Im Parcours liegt 1 Ding.',
      'Ziel 1, 15 mal 15 cm: 30 cm rechts, 25 cm weiter oben.',
    ]);
  });

  it('speaks the language of the page', () => {
    showLanguage('en');
    expect(walk([at(500, 800, 2)], 2)[1]).toBe('Checkpoint 2, 10 by 10 cm: 35 cm ahead, 10 cm to the left.');
    showLanguage('fr');
    expect(walk([at(500, 800, 2)], 2)[1]).toContain('10 sur 10 cm');
    showLanguage('it');
    expect(walk([at(500, 800, 2)], 2)[1]).toContain('10 per 10 cm');
  });
});

describe('what is around the robot', () => {
  it('is what it would bump into in each direction, from its body on', () => {
    const wall = { ...samples.wall, from: [0, 700], to: [1200, 700] } as const;
    expect(tellAround(asked([wall])).words).toBe(
      `${HERE} Vorn Wand 1, 19 cm. Links Rand der Arena, 56 cm. Hinten Rand der Arena, 43 cm. Rechts Rand der Arena, 56 cm.`,
    );
  });

  it('leaves out what the robot drives past', () => {
    const beside = { ...samples.block, at: [680, 700] as const };
    expect(tellAround(asked([beside])).words).toContain('Vorn Rand der Arena, 39 cm.');
    expect(tellAround(asked([{ ...beside, at: [660, 700] }])).words).toContain('Vorn Block 1, 17 cm.');
  });

  it('names what is under it: lines, checkpoints, targets, fields', () => {
    const under = [
      { ...samples.stroke, points: [[500, 455], [700, 455]] as const }, // prettier-ignore
      at(620, 430, 2),
      { ...samples.forbidden, at: [640, 490] as const }, // round: the robot is in its corner, not on it
    ];
    expect(tellAround(asked(under)).words).toContain('Darunter: Kontrollpunkt 2, Linie 1.');
  });

  it('is told around the crosshair as the picture has it', () => {
    expect(tellAround(asked([samples.wall], { crosshair: { x: 200, y: 300 } })).words).toBe(
      'Fadenkreuz bei x 20, y 30 cm. Rechts Rand der Arena, 100 cm. Oben Rand der Arena, 60 cm. Links Rand der Arena, 20 cm. Unten Wand 1, 20 cm.',
    );
  });
});
