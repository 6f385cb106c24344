import { describe, expect, it } from 'vitest';
import { Wire } from '#board/wires/wire';
import { attachIrReceiver } from './ir-receiver';

describe('An infrared receiver', () => {
  it('holds its wire up while it hears nothing, and lets whoever drives the wire win', () => {
    const wire = new Wire('P16');
    const stop = attachIrReceiver(wire);
    expect(wire.level).toBe(1);
    const board = wire.connect('board');
    board.drive(0);
    expect(wire.level).toBe(0);
    board.release();
    stop();
    expect(wire.level).toBe(0);
  });
});
