/**
 * DFRobot's gamepad for the micro:bit, version 4 (DFR0536): a stick and five keys on the edge connector.
 *
 *      P1   stick across, 0 left … 1023 right, about 512 at rest
 *      P2   stick up and down, 0 down … 1023 up
 *      P8   key Z: the stick pressed in               P0   buzzer (the board's own music pin)
 *      P13  key C, green      P15  key E, red          P12  vibration motor and light, on while high
 *      P14  key D, yellow     P16  key F, blue
 *
 * A key pulls its pin to ground; at rest a resistor pulls it up, as drivers with and without a pull of their own read it.
 * Sources: maker's wiki on DFR0536; Tiger-Jython/Robotics-Libraries `microbit/controller.py` (pins, colours, 512 at rest).
 */
import type { Wire } from '#board/wires/wire';

/** The keys with their wires. */
const KEY_WIRES = { C: 'P13', D: 'P14', E: 'P15', F: 'P16', Z: 'P8' } as const;

/** A key of the gamepad: four colours, and Z, the stick pressed in. */
export type GamepadKey = keyof typeof KEY_WIRES;
export const gamepadKeys = Object.keys(KEY_WIRES) as readonly GamepadKey[];

/** True for the name of a key. */
export const isGamepadKey = (name: unknown): name is GamepadKey =>
  typeof name === 'string' && Object.hasOwn(KEY_WIRES, name);

/** The gamepad as plain data. */
export interface GamepadState {
  /** Position of the stick, −1 … 1: right and up are positive. */
  readonly stick: { readonly x: number; readonly y: number };
  readonly keys: Readonly<Record<GamepadKey, boolean>>;
  /** True while the motor hums and the light beside it shines. */
  readonly vibrates: boolean;
}

/** A gamepad on a board. */
export interface Gamepad {
  /** Moves the stick, −1 … 1: right and up are positive. */
  move(x: number, y: number): void;
  set(key: GamepadKey, isDown: boolean): void;
  state(): GamepadState;
}

/** Half of the stick's steps: its middle lies between 511 and 512, and reads 512. */
const HALF = 511.5;
const STEPS = 1023;

const fractionOf = (position: number): number => Math.round(HALF + HALF * position) / STEPS;

/** Puts a gamepad on the wires of a board, by their names. */
export function attachGamepad(wireOf: (name: string) => Wire): Gamepad {
  const across = wireOf('P1').connect('gamepad stick');
  const upright = wireOf('P2').connect('gamepad stick');
  const motor = wireOf('P12');
  const down: Record<GamepadKey, boolean> = { C: false, D: false, E: false, F: false, Z: false };
  const ends = gamepadKeys.map((key) => [key, wireOf(KEY_WIRES[key]).connect(`gamepad ${key}`)] as const);
  for (const [, end] of ends) end.pull('up');
  const endOf = new Map(ends);
  let stick = { x: 0, y: 0 };
  const move = (x: number, y: number): void => {
    stick = { x, y };
    across.driveAnalog(fractionOf(x));
    upright.driveAnalog(fractionOf(y));
  };
  move(0, 0);
  return {
    move,
    set: (key, isDown) => {
      down[key] = isDown;
      if (isDown) endOf.get(key)?.drive(0);
      else endOf.get(key)?.release();
    },
    state: () => ({ stick, keys: { ...down }, vibrates: motor.fraction > 0 }),
  };
}
