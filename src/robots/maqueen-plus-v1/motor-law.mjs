/**
 * Data for scripts/fit-motor-law.mjs to fit the motor law of the Maqueen Plus V1: published speeds, and the circles
 * that the driver of Tiger-Jython/Robotics-Libraries (microbit/mbrobot_plus.py) was tuned for on real robots.
 */
export const motorLaw = {
  name: 'Maqueen Plus V1',
  trackMm: 90,
  straight: {
    source: `Two sources, byte by byte in turn: wheel speeds measured by informatiquecsud/mbrobot (maqueen-plus/misc), times the
wheel's circumference of 135 mm, and the polynomial of NoeSchaller/TS_Maqueen for the Maqueen Plus, times the wheel radius of
21.5 mm. Where both have a byte they differ by up to 1.2 times; at byte 20 the one's wheels stand and the other's run.`,
    /** More than for the other robots: with the usual 1.22 one circle is 36 % off; with more, little improves. */
    tolerance: 1.3,
    /** Power byte, mm/s. */
    rows: [
      [20, 87],
      [30, 144],
      [40, 178],
      [50, 224],
      [60, 255],
      [80, 315],
      [100, 327],
      [150, 379],
      [255, 378],
    ],
  },
  /** A byte at which the wheels stay still: below 8, the slowest one with which NoeSchaller/TS_Maqueen drives. */
  standsAt: 4,
  driver: 'Tiger-Jython/Robotics-Libraries `microbit/mbrobot_plus.py`',
  notes: [
    'At speed 30 the driver sends 32; slower ones it leaves to the robot’s own speed control.',
    'Circles more than 25 % off: the driver takes the inner wheel’s power in proportion to its speed, which no law for all speeds makes true.',
  ],
  /** Largest allowed error of the worst circle, 0.15 to 0.5 m; src/robots/arcs.test.ts checks it. The notes say why. */
  circlesWithin: 0.32,
  /** Start of the search: v0, coulomb, viscous, breakaway share and until, yawResistance. */
  start: [391, 0.000001, 0.193, 0.03, 0.15, 0.000001],
};

/** The driver's `_axe` in metres: a constant of its formula, not the robot's track. */
const AXLE_M = 0.082;

/** Power bytes [inner, outer] that the driver sends for a circle at a speed from 30. */
export function arcBytes(radiusM, percent) {
  const outer = percent < 32 ? percent + 2 : percent;
  if (radiusM < AXLE_M) return [0, outer];
  const share = ((radiusM - AXLE_M) / (radiusM + AXLE_M)) * (1 - (outer * outer) / 200000);
  return [Math.trunc(share * outer), outer];
}
