/**
 * Data for scripts/fit-motor-law.mjs to fit the motor law of the Calli:bot: hardly any published speeds, but the
 * circles that the driver of Tiger-Jython/Robotics-Libraries (callibot.py) was tuned for on real robots.
 */
export const motorLaw = {
  name: 'Calli:bot',
  trackMm: 80,
  straight: {
    source: `Nobody has published its speeds. At byte 90, the driver's speed 50: 25 cm/s, as TigerJython's own simulations drive at that
speed (Tiger-Jython/Aplu-Libraries). At byte 255: 133 revolutions per minute, what the sister robots' gear motors of 1:150
turn without load (DFRobot/pxt-DFRobot_MaqueenPlus_v20), times the wheel's circumference of 142.94 mm
(calliope-net/callibot2).`,
    /** Power byte, mm/s. */
    rows: [
      [90, 250],
      [255, 317],
    ],
  },
  /** A byte at which the wheels stay still. Chosen: between those of related robots with the same kind of motors. */
  standsAt: 8,
  driver: 'Tiger-Jython/Robotics-Libraries `callibot.py`',
  notes: [],
  /** Largest allowed error of the worst circle from 0.15 to 0.5 m; src/robots/arcs.test.ts checks it. */
  circlesWithin: 0.1,
  /** Start of the search: v0, coulomb, viscous, breakaway share and until, yawResistance. */
  start: [484, 0.000001, 0.3954, 0.032, 0.1, 0.000001],
};

/** The driver's `_axe` in metres: a constant of its formula, not the robot's track. */
const AXLE_M = 0.06;

/** Power bytes [inner, outer] that the driver sends for a circle at a speed in percent. */
export function arcBytes(radiusM, percent) {
  const outer = percent + 40;
  if (radiusM < AXLE_M) return [0, outer];
  const share = ((radiusM - AXLE_M) / (radiusM + AXLE_M)) * (1 - (outer * outer) / 200000);
  return [Math.trunc(share * outer), outer];
}
