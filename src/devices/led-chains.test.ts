import { describe, expect, it } from 'vitest';
import { Board } from '#board/board';
import { calliopeMini3 } from '#board/boards/calliope-mini-3';
import { Wire } from '#board/wires/wire';
import { Clock } from '#core/clock';
import { watchLedChains } from './led-chains';
import { attachWs2812 } from './ws2812';

describe('chains of LEDs on free pins', () => {
  it('are none before a stream arrives', () => {
    const wire = new Wire('P2');
    const watch = watchLedChains([wire]);
    expect(watch.chains()).toEqual([]);
    wire.stream(new Uint8Array(0));
    wire.stream(Uint8Array.of(1, 2));
    expect(watch.chains()).toEqual([]);
  });

  it('show a ring of 24 on pin 2 as soon as 72 bytes arrive, colours as green, red, blue', () => {
    const wire = new Wire('P2');
    const watch = watchLedChains([new Wire('P0'), wire]);
    wire.stream(Uint8Array.of(10, 200, 30, ...new Uint8Array(69)));
    const [chain, ...others] = watch.chains();
    expect(others).toEqual([]);
    expect(chain?.pin).toBe('P2');
    expect(chain?.colors).toHaveLength(24);
    expect(chain?.colors[0]).toEqual([200, 10, 30]);
    expect(chain?.colors[23]).toEqual([0, 0, 0]);
  });

  it('are as long as the longest stream: after 4 LEDs and then 2 the last two keep their colour', () => {
    const wire = new Wire('P1');
    const watch = watchLedChains([wire]);
    wire.stream(Uint8Array.of(9, 9, 9, 9, 9, 9));
    wire.stream(new Uint8Array(12).fill(7));
    wire.stream(new Uint8Array(8).fill(1)); // two LEDs and a part of the third, which keeps its colour
    expect(watch.chains()).toEqual([
      {
        pin: 'P1',
        colors: [
          [1, 1, 1],
          [1, 1, 1],
          [7, 7, 7],
          [7, 7, 7],
        ],
      },
    ]);
  });

  it('end at 1024 LEDs', () => {
    const wire = new Wire('P1');
    const watch = watchLedChains([wire]);
    wire.stream(new Uint8Array(3 * 2000).fill(5));
    expect(watch.chains()[0]?.colors).toHaveLength(1024);
  });

  it('do not show the LEDs that a robot has on P15', () => {
    const wires = [new Wire('P15'), new Wire('P2')] as const;
    attachWs2812(wires[0], 4);
    const watch = watchLedChains(wires);
    for (const wire of wires) wire.stream(new Uint8Array(12).fill(50));
    expect(watch.chains().map(({ pin }) => pin)).toEqual(['P2']);
  });

  it('do not show the three LEDs on a Calliope mini', () => {
    const board = new Board(calliopeMini3, new Clock());
    const watch = watchLedChains([...board.wires.values()]);
    board.pin('pin_RGB').sendStream(new Uint8Array(9).fill(50));
    board.pin('pin1').sendStream(new Uint8Array(24).fill(50));
    expect(watch.chains().map(({ pin, colors }) => [pin, colors.length])).toEqual([['P1', 8]]);
  });

  it('keep what was sent even when the sender uses its memory again', () => {
    const wire = new Wire('P2');
    const watch = watchLedChains([wire]);
    const memory = Uint8Array.of(1, 2, 3);
    wire.stream(memory);
    memory.fill(0);
    expect(watch.chains()[0]?.colors).toEqual([[2, 1, 3]]);
  });

  it('are the same data until something new is sent', () => {
    const [one, two] = [new Wire('P1'), new Wire('P2')];
    const watch = watchLedChains([one, two]);
    one.stream(Uint8Array.of(1, 2, 3));
    two.stream(Uint8Array.of(1, 2, 3));
    const before = watch.chains();
    expect(watch.chains()).toBe(before);
    two.stream(Uint8Array.of(4, 5, 6));
    const after = watch.chains();
    expect(after).not.toBe(before);
    expect(after[0]).toBe(before[0]);
    expect(after[1]?.colors).toEqual([[5, 4, 6]]);
    expect(before[1]?.colors).toEqual([[2, 1, 3]]);
  });

  it('show nothing new once nobody watches', () => {
    const wire = new Wire('P2');
    const watch = watchLedChains([wire]);
    watch.stop();
    wire.stream(Uint8Array.of(1, 2, 3));
    expect(watch.chains()).toEqual([]);
    expect(wire.streamListenerCount).toBe(0);
  });
});
