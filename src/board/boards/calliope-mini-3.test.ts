import { describe, expect, it } from 'vitest';
import { createBench } from '../testing/bench';
import { calliopeMini3 } from './calliope-mini-3';
import { boardTypes, findBoard } from './index';
import { microbitV2 } from './microbit-v2';

describe('the Calliope mini 3', () => {
  it('has the pins of its firmware, with the Grove connectors, the RGB LEDs and the motors', () => {
    expect(calliopeMini3.pins.map((pin) => pin.name).join(' ')).toBe(
      'pin0 pin1 pin2 pin3 pin4 pin5 pin6 pin7 pin8 pin9 pin10 pin11 pin12 pin13 pin14 pin15 pin_A1_RX pin_A1_TX ' +
        'pin18 pin_A0_SCL pin_A0_SDA pin_RGB pin_M0_DIR pin_M0_SPEED pin_M1_DIR pin_M1_SPEED pin_M_MODE pin_logo ' +
        'pin_speaker',
    );
  });

  it('names every pin with a number and a wire of its own', () => {
    for (const type of boardTypes) {
      expect(new Set(type.pins.map((pin) => pin.number)).size).toBe(type.pins.length);
      expect(new Set(type.pins.map((pin) => pin.wire)).size).toBe(type.pins.length);
    }
  });

  it('can be touched on four pads and the logo', () => {
    expect([...createBench(calliopeMini3).board.touch.keys()]).toEqual(['pin0', 'pin1', 'pin2', 'pin3', 'pin_logo']);
    expect(createBench(calliopeMini3).board.sensors.ids).toContain('pin3');
  });

  it('reads analog on pins 0 to 4, 10 and A1 RX', () => {
    expect(calliopeMini3.pins.filter((pin) => pin.analog).map((pin) => pin.name)).toEqual([
      'pin0',
      'pin1',
      'pin2',
      'pin3',
      'pin4',
      'pin10',
      'pin_A1_RX',
    ]);
  });

  it('gives pin 18 to the display where the micro:bit gives pin 3', () => {
    const { board } = createBench(calliopeMini3);
    expect(board.pin('pin3').acquire('write_digital')).toBeNull();
    expect(board.pin('pin18').acquire('write_digital')).toBe('display');
    board.display.off();
    expect(board.pin('pin18').acquire('write_digital')).toBeNull();
  });

  it('has the newer names by default, the micro:bit only with its newest firmware', () => {
    expect(createBench(calliopeMini3).board.has('rotate')).toBe(true);
    expect(createBench(calliopeMini3).board.has('recording')).toBe(false);
    expect(createBench().board.has('rotate')).toBe(false);
    expect(createBench(microbitV2, microbitV2.firmwares[1]).board.has('recording')).toBe(true);
    expect(createBench().board.firmware.id).toBe('v2.1.2');
  });

  it('is found by its id, after the micro:bit', () => {
    expect(boardTypes.map((type) => type.id)).toEqual(['microbit-v2', 'calliope-mini-3']);
    expect(findBoard('calliope-mini-3')).toBe(calliopeMini3);
  });
});
