import { describe, expect, it } from 'vitest';
import { Wire } from '#board/wires/wire';
import { ledOn } from './led';

describe('an LED on a wire', () => {
  it('is dark while nobody drives the wire', () => {
    expect(ledOn(new Wire('P8')).isLit()).toBe(0);
  });

  it('is lit while the wire is high and dark again when it is low', () => {
    const wire = new Wire('P8');
    const board = wire.connect('board');
    const led = ledOn(wire);
    board.drive(1);
    expect(led.isLit()).toBe(1);
    board.drive(0);
    expect(led.isLit()).toBe(0);
  });

  it('is lit at a duty of 25 %, too', () => {
    const wire = new Wire('P8');
    wire.connect('board').drivePwm({ periodUs: 20_000, dutyFraction: 0.25 });
    expect(ledOn(wire).isLit()).toBe(1);
  });
});
