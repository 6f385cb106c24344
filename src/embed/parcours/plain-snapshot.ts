import type { Pose } from '#core/geometry';
import type { TimedLogEvent } from '#simulation/outlets';
import { displayText, msOf, poseReport, robotReport, rounded } from '#simulation/report';
import type { DeviceSnapshot, RobotSnapshot, Snapshot } from '#simulation/snapshot';

import type { FloorPose, PlainDevice, PlainLogEvent, PlainRobot, PlainSnapshot } from './protocol';

/** The data about a run for hosts: plain numbers with three digits after the point, angles in degrees. */
export function plainSnapshot(snapshot: Snapshot): PlainSnapshot {
  const { timeUs, verdict, others } = snapshot;
  return {
    atMs: msOf(timeUs),
    ...plainDevice(snapshot),
    blocks: posesById(snapshot.blocks),
    movers: posesById(snapshot.movers),
    verdict,
    ...(others.length > 0 && { others: others.map((device) => ({ name: device.name, ...plainDevice(device) })) }),
  };
}

/** One microcomputer, without its name. */
function plainDevice(device: DeviceSnapshot): Omit<PlainDevice, 'name'> {
  const { running, repl, board, buttons, touch, sensors, rgb, motors, sound, lights } = device;
  return {
    ...{ running, repl, board, display: displayText(device.display), buttons, touch, sensors, rgb, motors },
    soundHz: sound?.hz ?? null,
    robot: device.robot && plainRobot(device.robot),
    lights,
  };
}

/** The robot's data, as the command line reports them, and its sensor readings. */
export function plainRobot(robot: RobotSnapshot): PlainRobot {
  const { duty, ultrasonic, lidar, lineSensors, colours, camera } = robot.state;
  const distanceMm = ultrasonic?.distanceMm ?? null;
  return {
    ...robotReport(robot),
    motors: { left: duty.left, right: duty.right },
    distanceMm: distanceMm === null ? null : rounded(distanceMm),
    lidarMm: lidar?.depthMm ?? null,
    ...(colours && { colours: colours.map(({ side, raw, hue, name }) => ({ side, raw, hue, name })) }),
    ...(camera && { camera: { algorithm: camera.algorithm, seen: camera.seen } }),
    lineSensors: lineSensors.map(({ name, bright, reading }) =>
      reading === undefined ? { name, bright } : { name, bright, reading },
    ),
  };
}

/** An entry of the data log with its time in ms. */
export function plainLogEvent({ timeUs, ...event }: TimedLogEvent): PlainLogEvent {
  return { ...event, atMs: msOf(timeUs) };
}

const posesById = (poses: Readonly<Record<string, Pose>>): Readonly<Record<string, FloorPose>> =>
  Object.fromEntries(Object.entries(poses).map(([id, pose]) => [id, poseReport(pose)]));
