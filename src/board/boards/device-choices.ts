/**
 * How a Calliope mini 1 or 2 differs from the Calliope mini 3 that runs its programs here.
 *
 * - `module`: its Python module is `calliope_mini`; the mini 3 of the shops calls it `calliopemini`
 * - `one-rgb-led`: it has one RGB LED, the object `led`; here `led` lights all three
 * - `motor-pins`: its motors are on pin28 (on/off) and pin29, pin30 (direction); those pins do not exist here
 * - `pin-numbers`: P3 is `p3` there and `pin3` here; the pins that drive its display (4 … 15) have other uses here
 * - `pull-up`: its inputs are pulled up by default, here down
 * - `sensors`: it has `gyrometer`, `magnetometer` and `sensor`, which do not exist here
 * - `memory`: it has a fourth of the memory, so a program that fits here may be too long there
 * - `no-sound`: it has no microphone level, no logo to touch, no sound effects and no speech as here
 *
 * Source: calliope-mini/calliope-mini-micropython, source/microbit (modmicrobit.cpp, microbitpin.cpp, calliopeled.cpp).
 */
export type DeviceDifference =
  'module' | 'one-rgb-led' | 'motor-pins' | 'pin-numbers' | 'pull-up' | 'sensors' | 'memory' | 'no-sound';

/** An entry of the device menu. */
export interface DeviceChoice {
  readonly id: string;
  /** Its name for users. */
  readonly name: string;
  /** Id of the board that runs it. */
  readonly board: string;
  /** How the real device differs from that board; empty if it is that board. */
  readonly differences: readonly DeviceDifference[];
}

/** The devices that a pupil may have, in the order of the menu. */
export const deviceChoices: readonly DeviceChoice[] = [
  { id: 'microbit-v2', name: 'micro:bit V2', board: 'microbit-v2', differences: [] },
  { id: 'calliope-mini-3', name: 'Calliope mini 3', board: 'calliope-mini-3', differences: [] },
  {
    id: 'calliope-mini-1-2',
    name: 'Calliope mini 1/2',
    board: 'calliope-mini-3',
    differences: ['one-rgb-led', 'motor-pins', 'pin-numbers', 'pull-up', 'sensors', 'memory', 'no-sound', 'module'],
  },
];
