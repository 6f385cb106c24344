import { describe, expect, it } from 'vitest';
import { Wire } from '#board/wires/wire';
import { attachLineSensor, createLineComparator } from './line-sensor';

function sensorOver(start: number) {
  const wire = new Wire('P13');
  let reflectance = start;
  const sensor = attachLineSensor(wire, () => reflectance);
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

  it('lets the wire float when detached', () => {
    const { wire, sensor } = sensorOver(1);
    sensor.stop();
    expect(wire.level).toBe(0);
  });
});

describe('a line sensor without a wire', () => {
  it('tells what it saw at its last look, and light or dark with the same gap: below 47 %, above 53 %', () => {
    let reflectance = 0.5;
    const sensor = createLineComparator(() => reflectance);
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
});
