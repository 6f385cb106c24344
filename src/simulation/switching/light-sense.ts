import type { Sensors } from '#board/sensors/sensors';
import type { Vec } from '#core/geometry';
import { levelOfLux } from '#devices/light-level';
import type { LightEye } from '#robots/light-eyes';
import type { Chassis } from '#world/chassis';
import { UPWARDS } from '#world/light/light';
import type { World } from '#world/world';

/** A photoresistor rises within 20 ms (docs/hardware/light.md): more often no sensor of a robot looks. */
const EVERY_US = 20_000;

/**
 * The light level where a board is, 0 … 255 in whole steps, as its display measures it.
 *
 * @param except the robot that carries it
 * @returns `null`: there is no lamp in the arena, and the room is as usual
 */
export const lampLevel = (world: World, atMm: Vec, except?: Chassis): number | null =>
  world.light.isKnown ? Math.round(levelOfLux(world.luxAt({ atMm, facing: UPWARDS }, except))) : null;

/**
 * Makes a function that lets a board measure the light once there are lamps, until a level is set by hand. Call it at the
 * start, and when the course has changed.
 */
export function createLampSense(sensors: Sensors, level: () => number | null): () => void {
  let isOn = false;
  return () => {
    const now = isOn ? null : level();
    if (now === null) return;
    isOn = true;
    sensors.measure('lightLevel', () => level() ?? now);
  };
}

/**
 * The light sensors of a robot. Without lamps in the arena, and once a level was set by hand, all of them see the level of
 * the board.
 */
export function robotLight(
  world: World,
  { chassis, sensors, nowUs }: { readonly chassis: Chassis; readonly sensors: Sensors; readonly nowUs: () => number },
): (eye: LightEye) => number {
  const seen = new Map<LightEye, { readonly level: number; readonly untilUs: number }>();
  return (eye) => {
    if (!world.light.isKnown || !sensors.isMeasured('lightLevel')) return sensors.get('lightLevel');
    const before = seen.get(eye);
    if (before && nowUs() < before.untilUs) return before.level;
    const level = levelOfLux(world.luxAt({ atMm: chassis.toWorld(eye.atMm), facing: turned(eye, chassis) }, chassis));
    seen.set(eye, { level, untilUs: nowUs() + EVERY_US });
    return level;
  };
}

/** The direction of a robot's eye in the world. */
function turned({ atMm, facing }: LightEye, chassis: Chassis): LightEye['facing'] {
  const at = chassis.toWorld(atMm);
  const ahead = chassis.toWorld({ x: atMm.x + facing.x, y: atMm.y + facing.y });
  return { x: ahead.x - at.x, y: ahead.y - at.y, z: facing.z };
}
