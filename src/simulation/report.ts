import { textBytesOf } from '#board/radio-text';
import { degOf, wrappedDeg } from '#core/angle';
import type { Pose } from '#core/geometry';
import type { Rgb } from '#core/rgb';
import { lampNumber } from '#robots/lamp-colors';
import type { PlacedPose } from './input';
import type { RadioPacket } from './outlets';
import type { Ended } from './simulation';
import type { RobotSnapshot } from './snapshot';

/** How a program ended. `panic`: the board itself stopped; `stuck`: inside one endless call, ended by force. */
export type EndedWord = 'finished' | 'exception' | 'panic' | 'stopped' | 'stuck';

/** The robot's figures: mm and degrees to three digits after the point. */
export interface RobotReport extends PlacedPose {
  /** Id of its type. */
  readonly type: string;
  /** Since the start, counter-clockwise positive, not wrapped. */
  readonly turnedDeg: number;
  readonly pathMm: number;
  readonly collisions: number;
  readonly leds: { readonly left: number; readonly right: number };
  readonly rgb: readonly Rgb[];
  /** Colour lamps, left and right: the number of each one's colour (`#robots/lamp-colors`), or the colour itself. */
  readonly lamps: readonly (number | Rgb)[];
  /** Degrees by port. */
  readonly servos: Readonly<Record<string, number>>;
}

/** A packet that the program sent by radio: as text when `radio.send` made it, else its bytes. */
export type PacketReport = { readonly atMs: number } & (
  { readonly text: string } | { readonly bytes: readonly number[] }
);

/** How a program ended, as a word. */
export const endedWord = ({ kind }: Pick<Ended, 'kind'>): EndedWord => (kind === 'fault' ? 'panic' : kind);

/** The robot's figures now. */
export function robotReport({ type, pose, state, turnedRad, pathMm, collisions }: RobotSnapshot): RobotReport {
  return {
    type,
    ...poseReport(pose),
    turnedDeg: rounded(degOf(turnedRad)),
    pathMm: rounded(pathMm),
    collisions,
    leds: { left: state.leds.left, right: state.leds.right },
    rgb: state.rgb,
    lamps: state.lamps.map((color) => lampNumber(color) ?? color),
    servos: state.servos,
  };
}

/** A pose in degrees, its heading more than −180 up to 180. */
export const poseReport = ({ xMm, yMm, headingRad }: Pose): PlacedPose => ({
  xMm: rounded(xMm),
  yMm: rounded(yMm),
  headingDeg: rounded(wrappedDeg(degOf(headingRad))),
});

/** A packet that was sent. */
export function packetReport({ timeUs, bytes }: RadioPacket): PacketReport {
  const atMs = msOf(timeUs);
  const text = textBytesOf(bytes);
  return text === null ? { atMs, bytes } : { atMs, text: new TextDecoder().decode(text) };
}

/** The display's levels as digits 0 … 9, rows parted by colons. */
export const displayText = (levels: readonly number[]): string =>
  [0, 5, 10, 15, 20].map((row) => levels.slice(row, row + 5).join('')).join(':');

/** Simulated µs as ms, to the µs. */
export const msOf = (timeUs: number): number => Math.round(timeUs) / 1000;

/** To three digits after the point, without a negative zero: enough for reading; the exact run is in the trace hash. */
export const rounded = (value: number): number => Math.round(value * 1000) / 1000 + 0;
