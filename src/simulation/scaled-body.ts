import type { Vec } from '#core/geometry';
import type { ChassisType } from '#world/chassis';

/**
 * A body at another size: every length and the top speed grow with the scale; mass and forces stay, so that a small
 * robot and a large one speed up in the same time and push the same blocks.
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
    drive: { ...body.drive, v0MmPerS: body.drive.v0MmPerS * scale },
  };
}
