import { describe, expect, it } from 'vitest';
import { Wire } from '#board/wires/wire';
import { createRng } from '#core/rng';
import { attachLineSensor, createLineComparator, MOST_STEPS_BACK } from './line-sensor';

function sensorOver(start: number) {
  const wire = new Wire('P13');
  let reflectance = start;
  const sensor = attachLineSensor(wire, { look: () => reflectance });
  const over = (next: number): number => {
    reflectance = next;
    sensor.sample();
    return wire.level;
  };
  return { wire, sensor, over };
}

describe('a digital line sensor', () => {
  it('reads 1 on the bare floor from the first moment', () => expect(sensorOver(1).wire.level).toBe(1));

  it('reads 0 on a black line from the first moment', () => expect(sensorOver(0).wire.level).toBe(0));

  it('changes to 0 below 47 % and back to 1 above 53 % reflectance', () => {
    const { over } = sensorOver(1);
    expect([0.6, 0.5, 0.48, 0.46, 0.5, 0.52, 0.54].map(over)).toEqual([1, 1, 1, 0, 0, 0, 1]);
  });

  it('shows the same to its blue LED as to the wire', () => {
    const { sensor, over } = sensorOver(1);
    over(0);
    expect(sensor.isBright()).toBe(false);
    over(1);
    expect(sensor.isBright()).toBe(true);
  });

  it('looks only when the wire is read, and after each step where something listens', () => {
    const wire = new Wire('P13');
    let looks = 0;
    const sensor = attachLineSensor(wire, { look: () => (++looks % 2 === 0 ? 0 : 1) });
    for (let step = 0; step < 10; step++) sensor.sample();
    expect([looks, wire.level, looks]).toEqual([1, 0, 2]);
    const heard: number[] = [];
    wire.onLevel((level) => heard.push(level));
    for (let step = 0; step < 3; step++) sensor.sample();
    expect(heard).toEqual([1, 0, 1]);
  });

  it('lets the wire float when detached', () => {
    const { wire, sensor } = sensorOver(1);
    sensor.stop();
    expect(wire.level).toBe(0);
  });
});

describe('a line sensor without a wire', () => {
  it('tells what it saw at its last look, and light or dark with the same gap: below 47 %, above 53 %', () => {
    let reflectance = 0.5;
    const sensor = createLineComparator({ look: () => reflectance });
    const looks = [0.46, 0.5, 0.54, 0.5].map((next) => {
      reflectance = next;
      const before = sensor.reflectance();
      sensor.sample();
      return [before, sensor.reflectance(), sensor.isBright()];
    });
    expect(looks).toEqual([
      [0.5, 0.46, false],
      [0.46, 0.5, false],
      [0.5, 0.54, true],
      [0.54, 0.5, true],
    ]);
  });

  it('is the same at each reading as one that looks after every step, also where the floor changes meanwhile', () => {
    const chance = createRng(3).fork('line');
    const past: number[] = [0.5];
    let [looks, now] = [0, 0.5];
    let paint: () => void = () => undefined;
    const sensor = createLineComparator({
      look: (ago) => {
        looks++;
        return ago === undefined ? now : (past.at(-1 - ago) ?? NaN);
      },
      beforePaint: (act) => {
        paint = act;
        return () => undefined;
      },
    });
    let isBright = true;
    const steps = 20_000;
    for (let step = 0; step < steps; step++) {
      now = Math.min(Math.max(now + 0.1 * (chance.unit() - 0.5), 0), 1);
      past.push(now);
      if (now > 0.53) isBright = true;
      if (now < 0.47) isBright = false;
      sensor.sample();
      // Paint makes all of the past look otherwise.
      if (chance.unit() < 0.01) {
        paint();
        past.fill(1 - now);
      }
      if (chance.unit() < 0.02) expect([sensor.isBright(), sensor.reflectance()]).toEqual([isBright, now]);
    }
    expect(looks).toBeLessThan(steps / 4);
  });

  it('never looks further back than its surroundings remember', () => {
    const asked: number[] = [];
    const sensor = createLineComparator({
      look: (ago = 0) => {
        asked.push(ago);
        return 0.5;
      },
    });
    for (let step = 0; step < 3 * MOST_STEPS_BACK; step++) sensor.sample();
    expect(Math.max(...asked)).toBe(MOST_STEPS_BACK - 1);
  });
});
