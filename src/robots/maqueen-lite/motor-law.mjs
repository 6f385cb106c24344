/**
 * Data for scripts/fit-motor-law.mjs to fit the motor law of the Maqueen Lite: published speeds, and the circles that
 * the driver of Tiger-Jython/Robotics-Libraries (microbit/mbrobot.py) was tuned for on real robots.
 */
export const motorLaw = {
  name: 'Maqueen Lite',
  trackMm: 70,
  straight: {
    source: `Wheel speed polynomial in NoeSchaller/TS_Maqueen for the Maqueen Lite, times the wheel radius of 21.5 mm. Other sources
differ from it by up to 1.7 times (battery, floor).`,
    /** Power byte, mm/s. */
    rows: [
      [11, 43],
      [15, 65],
      [20, 92],
      [30, 139],
      [40, 180],
      [50, 214],
      [100, 325],
      [200, 405],
      [255, 427],
    ],
  },
  /** A byte at which the wheels stay still: the driver gives its slowest speed byte 11 and can be calibrated to send less. */
  standsAt: 7,
  driver: 'Tiger-Jython/Robotics-Libraries `microbit/mbrobot.py`',
  notes: ['Where the driver finds a circle too wide for the speed it chooses a higher one itself; hence equal cells.'],
  /** Largest allowed error of the worst circle from 0.15 to 0.5 m; src/robots/arcs.test.ts checks it. */
  circlesWithin: 0.14,
  /** Start of the search: v0, coulomb, viscous, breakaway share and until, yawResistance. */
  start: [422.8, 0.01959, 0.1466, 0.007861, 0.2966, 0.1123],
};

/** Percent → power byte: the driver's table. */
function powerByte(percent) {
  if (percent <= 0) return 0;
  if (percent <= 33) return Math.trunc(0.4 * percent + 11);
  if (percent <= 63) return Math.trunc(0.89 * percent - 5);
  return percent < 100 ? Math.trunc(1.0561 ** percent + 20) : 255;
}

/** Power bytes [inner, outer] that the driver sends for a circle at a speed in percent, not calibrated. */
export function arcBytes(radiusM, percent) {
  const cm = Math.trunc(radiusM * 100);
  const outer = percent <= Math.max(cm + 20, 40) ? Math.min(Math.max(cm + 40, 40), 100) : percent;
  const inner = cm < 4 ? 0 : ((10 * cm - 35) / (cm * 10.6 + 90 + Math.floor((100 - outer) / 2))) * outer;
  return [powerByte(Math.trunc(inner)), powerByte(outer)];
}
