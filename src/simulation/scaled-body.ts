import type { Vec } from '#core/geometry';
import type { ChassisType, Wheel } from '#world/chassis';

/**
 * A body at another size: every length, the top speed, the motors' force and the tyres' grip grow with the scale; the
 * mass stays. So a small and a large robot speed up in the same time, and all their movements look alike at their own
 * size.
 */
export function scaledBody(body: ChassisType, scale: number): ChassisType {
  if (scale === 1) return body;
  const scaled = ({ x, y }: Vec): Vec => ({ x: x * scale, y: y * scale });
  const wheel = ({ atMm, radiusMm, gripMu }: Wheel): Wheel => ({
    atMm: scaled(atMm),
    radiusMm: radiusMm * scale,
    gripMu: gripMu * scale,
  });
  const [left, right] = body.wheels;
  return {
    ...body,
    outlineMm: body.outlineMm.map((part) => part.map(scaled)),
    heightMm: body.heightMm * scale,
    centreOfMassMm: scaled(body.centreOfMassMm),
    ...(body.inertiaGMm2 === undefined ? {} : { inertiaGMm2: body.inertiaGMm2 * scale * scale }),
    wheels: [wheel(left), wheel(right)],
    ...(body.castorMm === undefined ? {} : { castorMm: scaled(body.castorMm) }),
    drive: {
      ...body.drive,
      v0MmPerS: body.drive.v0MmPerS * scale,
      stallForceN: body.drive.stallForceN * scale,
    },
  };
}
