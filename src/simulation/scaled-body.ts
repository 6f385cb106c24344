import type { Vec } from '#core/geometry';
import type { ChassisType } from '#world/chassis';

/**
 * A body at another size: every length, the top speed and the motors' force grow with the scale; the mass stays. So a
 * small and a large robot speed up in the same time, and all their movements look alike at their own size.
 */
export function scaledBody(body: ChassisType, scale: number): ChassisType {
  if (scale === 1) return body;
  const scaled = ({ x, y }: Vec): Vec => ({ x: x * scale, y: y * scale });
  const [left, right] = body.wheels;
  return {
    ...body,
    outlineMm: body.outlineMm.map((part) => part.map(scaled)),
    centreOfMassMm: scaled(body.centreOfMassMm),
    ...(body.inertiaGMm2 === undefined ? {} : { inertiaGMm2: body.inertiaGMm2 * scale * scale }),
    wheels: [
      { ...left, atMm: scaled(left.atMm), radiusMm: left.radiusMm * scale },
      { ...right, atMm: scaled(right.atMm), radiusMm: right.radiusMm * scale },
    ],
    ...(body.castorMm === undefined ? {} : { castorMm: scaled(body.castorMm) }),
    drive: {
      ...body.drive,
      v0MmPerS: body.drive.v0MmPerS * scale,
      stallForceN: body.drive.stallForceN * scale,
    },
  };
}
