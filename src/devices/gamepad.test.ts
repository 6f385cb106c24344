import { describe, expect, it } from 'vitest';
import { Board } from '#board/board';
import { microbitV2 } from '#board/boards/microbit-v2';
import { Clock } from '#core/clock';
import { attachGamepad } from './gamepad';

function bench() {
  const board = new Board(microbitV2, new Clock());
  return { board, gamepad: attachGamepad((name) => board.wire(name)) };
}

describe("DFRobot's gamepad", () => {
  it('reads 512 at rest, 0 left and down, 1023 right and up', () => {
    const { board, gamepad } = bench();
    const read = () => [board.pin('pin1').readAnalog(), board.pin('pin2').readAnalog()];
    expect(read()).toEqual([512, 512]);
    gamepad.move(-1, 1);
    expect(read()).toEqual([0, 1023]);
    gamepad.move(1, -1);
    expect(read()).toEqual([1023, 0]);
  });

  it.each([
    ['C', 'pin13'],
    ['D', 'pin14'],
    ['E', 'pin15'],
    ['F', 'pin16'],
    ['Z', 'pin8'],
  ] as const)('pulls its pin to ground with key %s: %s, which reads 1 at rest with any pull', (key, name) => {
    const { board, gamepad } = bench();
    const pin = board.pin(name);
    for (const pull of ['up', 'none', 'down'] as const) {
      pin.setPull(pull);
      gamepad.set(key, false);
      expect(pin.readDigital()).toBe(1);
      gamepad.set(key, true);
      expect(pin.readDigital()).toBe(0);
    }
    expect(gamepad.state().keys[key]).toBe(true);
  });

  it('vibrates while pin 12 is high', () => {
    const { board, gamepad } = bench();
    board.pin('pin12').writeDigital(1);
    expect(gamepad.state().vibrates).toBe(true);
    board.pin('pin12').writeDigital(0);
    expect(gamepad.state().vibrates).toBe(false);
  });
});
