import { textBytesOf } from '#board/radio-text';
import type { Pose } from '#core/geometry';
import type { RadioPacket, TimedLogEvent } from '#simulation/outlets';
import type { RobotSnapshot, Snapshot } from '#simulation/snapshot';

import type { FloorPose, PlainLogEvent, PlainPacket, PlainRobot, PlainSnapshot } from './protocol';

/** The data about a run for hosts: plain numbers with three digits after the point, angles in degrees. */
export function plainSnapshot(snapshot: Snapshot): PlainSnapshot {
  const { timeUs, running, repl, board, buttons, touch, sensors, rgb, motors, sound, verdict, lights } = snapshot;
  return {
    atMs: msOf(timeUs),
    ...{ running, repl, board, display: displayText(snapshot.display), buttons, touch, sensors, rgb, motors },
    soundHz: sound?.hz ?? null,
    robot: snapshot.robot && plainRobot(snapshot.robot),
    blocks: posesById(snapshot.blocks),
    movers: posesById(snapshot.movers),
    ...{ verdict, lights },
  };
}

/** The robot's data, as the command line reports them, and its sensor readings. */
export function plainRobot({ type, pose, state, turnedRad, pathMm, collisions }: RobotSnapshot): PlainRobot {
  return {
    type,
    ...plainPose(pose),
    turnedDeg: rounded(degOf(turnedRad)),
    pathMm: rounded(pathMm),
    collisions,
    leds: { left: state.leds.left, right: state.leds.right },
    rgb: state.rgb.map(([red, green, blue]) => [red, green, blue]),
    servos: state.servos,
    motors: { left: state.duty.left, right: state.duty.right },
    distanceMm: state.ultrasonic === null ? null : roundedOrNull(state.ultrasonic.distanceMm),
    lineSensors: state.lineSensors.map(({ name, bright, reading }) =>
      reading === undefined ? { name, bright } : { name, bright, reading },
    ),
  };
}

/** Digits 0 … 9 per LED, rows separated by colons. */
export const displayText = (pixels: readonly number[]): string =>
  [0, 5, 10, 15, 20].map((row) => pixels.slice(row, row + 5).join('')).join(':');

/** A packet as text if `radio.send` made it, otherwise as bytes. */
export function plainPacket({ timeUs, bytes }: RadioPacket): PlainPacket {
  const atMs = msOf(timeUs);
  const text = textBytesOf(bytes);
  return text === null ? { atMs, bytes } : { atMs, text: new TextDecoder().decode(text) };
}

/** An entry of the data log with its time in ms. */
export function plainLogEvent({ timeUs, ...event }: TimedLogEvent): PlainLogEvent {
  return { ...event, atMs: msOf(timeUs) };
}

const posesById = (poses: Readonly<Record<string, Pose>>): Readonly<Record<string, FloorPose>> =>
  Object.fromEntries(Object.entries(poses).map(([id, pose]) => [id, plainPose(pose)]));

const plainPose = ({ xMm, yMm, headingRad }: Pose): FloorPose => ({
  xMm: rounded(xMm),
  yMm: rounded(yMm),
  headingDeg: rounded(wrappedDeg(degOf(headingRad))),
});

/** Simulated µs as ms, to the µs. */
export const msOf = (timeUs: number): number => Math.round(timeUs) / 1000;

const degOf = (rad: number): number => (rad * 180) / Math.PI;

/** More than −180° up to 180°. */
function wrappedDeg(deg: number): number {
  const rest = deg % 360;
  return rest > 180 ? rest - 360 : rest <= -180 ? rest + 360 : rest;
}

/** Avoids a negative zero. */
const rounded = (value: number): number => Math.round(value * 1000) / 1000 + 0;
const roundedOrNull = (value: number | null): number | null => (value === null ? null : rounded(value));
