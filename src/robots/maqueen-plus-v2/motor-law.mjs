/**
 * Data for scripts/fit-motor-law.mjs to fit the motor law of the Maqueen Plus V2: published speeds, and the circles
 * that the driver of Tiger-Jython/Robotics-Libraries (microbit/mbrobot_plusV2.py) was tuned for on real robots.
 */
export const motorLaw = {
  name: 'Maqueen Plus V2',
  trackMm: 82,
  straight: {
    source: `From byte 30 on the polynomial of MINTspark/pxt-mintspark-drivemaqueenplusv2, which says that it holds from there; below
it NoeSchaller/TS_Maqueen for the Maqueen Plus (V1), times the wheel radius of 21.5 mm. Above byte 30 that one is up to
1.7 times faster: the sources differ that much (battery, floor).`,
    /** Power byte, mm/s. */
    rows: [
      [15, 55],
      [20, 87],
      [30, 92],
      [40, 114],
      [50, 132],
      [100, 183],
      [200, 204],
      [255, 257],
    ],
  },
  /** A byte at which the wheels stay still: the driver gives its slowest speed byte 15, and its users lower that by up to 14. */
  standsAt: 9,
  driver: 'Tiger-Jython/Robotics-Libraries `microbit/mbrobot_plusV2.py`',
  notes: [
    'At speed 30 the outer wheel gets byte 33 and the inner one, near the end of what moves at all, steps from 15 to 19 only.',
  ],
  /**
   * Largest allowed error of the worst circle from 0.15 to 0.5 m; src/robots/arcs.test.ts checks it. Less is not
   * possible: the driver sends the same bytes for 0.2 and for 0.3 m.
   */
  circlesWithin: 0.21,
  /** Start of the search: v0, coulomb, viscous, breakaway share and until, yawResistance. */
  start: [246.9, 0.000001, 0.1546, 0.03637, 0.3277, 0.1289],
};

/** Percent → power byte: the driver's table. */
function powerByte(percent) {
  if (percent <= 0) return 0;
  if (percent <= 40) return Math.trunc(0.6 * percent + 15);
  if (percent < 60) return percent;
  return percent < 100 ? Math.trunc(1.05546 ** percent + 34) : 255;
}

/** Power bytes [inner, outer] that the driver sends for a circle at a speed in percent, not calibrated. */
export function arcBytes(radiusM, percent) {
  const cm = Math.trunc(radiusM * 100);
  const outer = Math.max(percent, 25);
  if (cm <= 5) return [0, powerByte(outer)];
  const inner = Math.trunc((outer * (220 - outer - 9 * cm)) / (4 * outer - 490 - 10 * cm));
  const least = cm > 15 ? 2 : 1;
  return [powerByte(inner < 2 ? least : inner), powerByte(outer)];
}
