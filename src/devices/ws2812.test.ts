import { describe, expect, it } from 'vitest';
import { Wire } from '#board/wires/wire';
import { attachWs2812 } from './ws2812';

describe('a chain of WS2812 LEDs', () => {
  it('is dark at first', () => {
    expect(attachWs2812(new Wire('P15'), 2).colors()).toEqual([
      [0, 0, 0],
      [0, 0, 0],
    ]);
  });

  it('reads green, red, blue from the wire', () => {
    const wire = new Wire('P15');
    const chain = attachWs2812(wire, 1);
    wire.stream(Uint8Array.of(10, 200, 30));
    expect(chain.colors()).toEqual([[200, 10, 30]]);
  });

  it('leaves the last two of four LEDs as they are when only 6 bytes come', () => {
    const wire = new Wire('P15');
    const chain = attachWs2812(wire, 4);
    wire.stream(new Uint8Array(12).fill(9));
    wire.stream(new Uint8Array(6).fill(1));
    expect(chain.colors()).toEqual([
      [1, 1, 1],
      [1, 1, 1],
      [9, 9, 9],
      [9, 9, 9],
    ]);
  });

  it('keeps the colour of an LED that gets 2 of its 3 bytes', () => {
    const wire = new Wire('P15');
    const chain = attachWs2812(wire, 2);
    wire.stream(Uint8Array.of(1, 2, 3, 4, 5));
    expect(chain.colors()).toEqual([
      [2, 1, 3],
      [0, 0, 0],
    ]);
  });

  it('drops what comes for a 5th LED in a chain of 4', () => {
    const wire = new Wire('P15');
    const chain = attachWs2812(wire, 4);
    wire.stream(new Uint8Array(15).fill(7));
    expect(chain.colors()).toHaveLength(4);
  });

  it('shows nothing new once detached', () => {
    const wire = new Wire('P15');
    const chain = attachWs2812(wire, 1);
    chain.stop();
    wire.stream(Uint8Array.of(1, 2, 3));
    expect(chain.colors()).toEqual([[0, 0, 0]]);
  });
});
