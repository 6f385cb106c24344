import { describe, expect, it } from 'vitest';
import { findBoard, boardTypes } from './boards/index';
import { createBench } from './testing/bench';

describe('the micro:bit V2', () => {
  it('is found by its id, and nothing else is', () => {
    expect(findBoard('microbit-v2')?.name).toBe('micro:bit V2');
    expect(findBoard('microbit-v9')).toBeUndefined();
    expect(boardTypes.map((type) => type.id)).toContain('microbit-v2');
  });

  it('has the 19 pins of its edge connector, the logo and the speaker', () => {
    const { board } = createBench();
    expect([...board.wires.keys()].join(' ')).toBe(
      'P0 P1 P2 P3 P4 P5 P6 P7 P8 P9 P10 P11 P12 P13 P14 P15 P16 P19 P20 logo speaker',
    );
    expect([...board.pins.keys()].join(' ')).toBe(
      'pin0 pin1 pin2 pin3 pin4 pin5 pin6 pin7 pin8 pin9 pin10 pin11 pin12 pin13 pin14 pin15 pin16 pin19 pin20 ' +
        'pin_logo pin_speaker',
    );
  });

  it('reads analog on pins 0, 1, 2, 3, 4 and 10', () => {
    const { type } = createBench().board;
    expect(type.pins.filter((pin) => pin.analog).map((pin) => pin.number)).toEqual([0, 1, 2, 3, 4, 10]);
  });

  it('prints 11,520 characters a second and sends an LED its colour in 30 µs', () => {
    const { costsUs } = createBench().board.type;
    expect(costsUs.printByteUs).toBeCloseTo(86.8, 1);
    expect(3 * costsUs.ws2812ByteUs).toBe(30);
  });

  it('starts dark, silent, with nothing pressed and an I2C bus of 100 kHz', () => {
    const { board, clock } = createBench();
    expect(board.display.pixels).toEqual(new Uint8Array(25));
    expect(board.music.frequencyHz).toBeNull();
    expect([board.buttonA.isDown, board.buttonB.isDown]).toEqual([false, false]);
    expect(board.i2c.frequencyHz).toBe(100_000);
    expect(clock.nextAlarmUs).toBe(Infinity);
  });
});
