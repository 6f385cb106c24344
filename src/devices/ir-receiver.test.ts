import { describe, expect, it } from 'vitest';
import { Wire } from '#board/wires/wire';
import { Clock } from '#core/clock';
import { attachIrReceiver } from './ir-receiver';
import { NecRemote, noInfrared } from './nec-remote';

describe('An infrared receiver', () => {
  it('holds its wire up while it hears nothing, and lets whoever drives the wire win', () => {
    const wire = new Wire('P16');
    const stop = attachIrReceiver(wire, noInfrared);
    expect(wire.level).toBe(1);
    const board = wire.connect('board');
    board.drive(0);
    expect(wire.level).toBe(0);
    board.release();
    stop();
    expect(wire.level).toBe(0);
  });

  it('is low in each burst and high in between', () => {
    const clock = new Clock();
    const remote = new NecRemote(clock);
    const wire = new Wire('P16');
    attachIrReceiver(wire, remote);
    remote.set('up', true);
    const levels = [0, 8999, 9000, 13_499, 13_500, 14_060].map((us) => {
      clock.advanceTo(us);
      return wire.level;
    });
    expect(levels).toEqual([0, 0, 1, 1, 0, 1]);
  });
});
