import { describe, expect, it } from 'vitest';
import { createLineComparator } from '#devices/line-sensor';
import { strokeInfrared } from '#scene/paint/reflectance';
import { paintColors } from '#scene/paint/paint';
import { createWorld } from '#world/world';

const SPOT_MM = 2.5;
const AT = { x: 50, y: 50 };

/** The reports of a line sensor on a floor: at first, after a black line, and after bare floor. */
function said(floor: (world: ReturnType<typeof createWorld>) => void): readonly boolean[] {
  const world = createWorld({ widthMm: 100, heightMm: 100 });
  floor(world);
  let seen = world.reflectanceAt(AT, SPOT_MM);
  const sensor = createLineComparator({ look: () => seen });
  const back = [0, 1].map((other) => {
    const [, last = false] = [other, world.reflectanceAt(AT, SPOT_MM)].map((value) => {
      seen = value;
      sensor.sample();
      return sensor.isBright();
    });
    return last;
  });
  seen = world.reflectanceAt(AT, SPOT_MM);
  return [createLineComparator({ look: () => seen }).isBright(), ...back];
}

describe('a line sensor says the same of a floor whatever it saw before:', () => {
  it.each(paintColors.map((color) => [color, !['black', 'blue', 'green'].includes(color)] as const))(
    'painted %s is light: %s',
    (color, isLight) => {
      const paint = {
        pointsMm: [{ x: 0, y: 50 }, AT, { x: 100, y: 50 }],
        widthMm: 40,
        reflectance: strokeInfrared[color],
      };
      expect(said((world) => world.addStroke(paint))).toEqual([isLight, isLight, isLight]);
    },
  );

  it.each(Array.from({ length: 16 }, (_, level) => [level, level >= 8] as const))(
    'a picture of level %i of 15 is light: %s',
    (level, isLight) => {
      const [columns, rows] = [10, 10];
      const grid = { atMm: { x: 0, y: 0 }, sizeMm: { x: 100, y: 100 }, columns, rows };
      const reflectances = new Float32Array(columns * rows).fill(level / 15);
      expect(said((world) => world.setFloor({ ...grid, reflectances }))).toEqual([isLight, isLight, isLight]);
    },
  );
});
