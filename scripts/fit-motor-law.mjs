/**
 * Fits the motor law of the Maqueen Lite and writes docs/hardware/maqueen-lite-motor-law.md.
 *
 *     node scripts/fit-motor-law.mjs            prints constants and residuals, writes the page
 *     node scripts/fit-motor-law.mjs --check    exits with 1 when the page is not what this script writes
 *
 * The law, for a wheel with duty D = byte / 255 while the wheels' mean speed is V:
 *
 *     v = v0 · (D − coulomb ∓ m) / (D + viscous)      outer wheel minus, inner wheel plus, never below 0
 *     m = yawResistance · (V / v0)²                    it may cancel the difference of the wheels, never reverse it
 *
 * It is fitted to two things at once: how fast the robot drives straight at a power byte, and how wide the circles are
 * for which the drivers' own `leftArc(radius)` was tuned on real robots.
 */
import { readFileSync, writeFileSync } from 'node:fs';

const PAGE = new URL('../docs/hardware/maqueen-lite-motor-law.md', import.meta.url);
const TRACK_MM = 70;

/** Power byte → mm/s. Source: wheel speed polynomial of NoeSchaller/TS_Maqueen for the Maqueen Lite, times the radius of 21.5 mm. */
const STRAIGHT = [
  [11, 43],
  [15, 65],
  [20, 92],
  [30, 139],
  [40, 180],
  [50, 214],
  [100, 325],
  [200, 405],
  [255, 427],
];
/** Circles that count: radius in m. The drivers' default speed is 50 %. */
const FITTED_SPEED = 50;
const FITTED_RADII = [0.1, 0.15, 0.2, 0.25, 0.3, 0.35, 0.4];
const SHOWN_RADII = [...FITTED_RADII, 0.5, 1];
const SHOWN_SPEEDS = [30, 50, 70, 100];

/**
 * Weight of a circle against a straight speed: published speeds of this robot differ by a factor of 1.7 (battery), whereas
 * a pupil sees at once when a circle has the wrong size.
 */
const CIRCLE_WEIGHT = 6;
/** Weight of circles at the other speeds, and of wider ones: looked at, but not at the cost of the ones above. */
const OTHER_CIRCLE_WEIGHT = 0.25;

/** Where the search begins. */
const START = [387, 0.0296, 0.1, 0.0372];

/** Percent → power byte as the driver's table has it (Tiger-Jython/Robotics-Libraries mbrobot.py). */
function powerByte(percent) {
  if (percent <= 0) return 0;
  if (percent <= 33) return Math.trunc(0.4 * percent + 11);
  if (percent <= 63) return Math.trunc(0.89 * percent - 5);
  return percent < 100 ? Math.trunc(1.0561 ** percent + 20) : 255;
}

/** Power bytes [inner, outer] that the driver sends for a circle. */
function arcBytes(radiusM, percent) {
  const cm = Math.trunc(radiusM * 100);
  const outer = percent <= Math.max(cm + 20, 40) ? Math.min(Math.max(cm + 40, 40), 100) : percent;
  const inner = cm < 4 ? 0 : ((10 * cm - 35) / (cm * 10.6 + 90 + Math.floor((100 - outer) / 2))) * outer;
  return [powerByte(Math.trunc(inner)), powerByte(outer)];
}

function wheelSpeed({ v0, coulomb, viscous }, byte, moment) {
  const duty = byte / 255;
  return Math.max(0, (v0 * (duty - coulomb + moment)) / (duty + viscous));
}

/** Speeds [inner, outer] in mm/s once they no longer change. */
function steadySpeeds(law, innerByte, outerByte) {
  const speedsAt = (moment) => [wheelSpeed(law, innerByte, moment), wheelSpeed(law, outerByte, -moment)];
  const limited = (moment) => {
    if (speedsAt(moment)[0] <= speedsAt(moment)[1]) return speedsAt(moment);
    const equal = bisect(0, moment, (m) => speedsAt(m)[0] < speedsAt(m)[1]);
    return speedsAt(equal);
  };
  const at = (mean) => limited(law.yawResistance * (mean / law.v0) ** 2);
  const mean = bisect(0, law.v0, (v) => (at(v)[0] + at(v)[1]) / 2 > v);
  return at(mean);
}

/** The place between `low` and `high` where `isBelow` turns from true to false. */
function bisect(low, high, isBelow) {
  for (let i = 0; i < 45; i++) {
    const middle = (low + high) / 2;
    if (isBelow(middle)) low = middle;
    else high = middle;
  }
  return (low + high) / 2;
}

function circleMm(law, radiusM, percent) {
  const [inner, outer] = steadySpeeds(law, ...arcBytes(radiusM, percent));
  return ((TRACK_MM / 2) * (outer + inner)) / Math.max(outer - inner, 1e-9);
}

const straightError = (law, row) => Math.log(Math.max(wheelSpeed(law, row[0], 0), 1) / row[1]);
const circleError = (law, radiusM, percent) => Math.log(circleMm(law, radiusM, percent) / (1000 * radiusM));

function lawOf([v0, coulomb, viscous, yawResistance]) {
  return { v0, coulomb, viscous, yawResistance };
}

function cost(parameters) {
  if (parameters.some((value) => !(value > 0))) return Infinity;
  const law = lawOf(parameters);
  let sum = 0;
  for (const row of STRAIGHT) sum += straightError(law, row) ** 2;
  for (const percent of SHOWN_SPEEDS) {
    for (const radius of SHOWN_RADII) {
      const isFitted = percent === FITTED_SPEED && FITTED_RADII.includes(radius);
      sum += (isFitted ? CIRCLE_WEIGHT : OTHER_CIRCLE_WEIGHT) * circleError(law, radius, percent) ** 2;
    }
  }
  return sum;
}

/** Nelder and Mead's downhill simplex, restarted until it stands still: deterministic, no derivatives needed. */
function minimise(f, start) {
  let best = start;
  for (let restart = 0; restart < 20; restart++) {
    const next = descend(f, best);
    if (f(best) - f(next) < 1e-9) return next;
    best = next;
  }
  return best;
}

function descend(f, start) {
  const point = (x) => ({ x, y: f(x) });
  const mix = (a, b, t) => point(a.map((value, i) => value + t * (b[i] - value)));
  let corners = [start, ...start.map((_, i) => start.map((value, j) => (i === j ? value * 1.1 : value)))].map(point);
  for (let round = 0; round < 300; round++) {
    corners.sort((a, b) => a.y - b.y);
    const worst = corners[corners.length - 1];
    const others = corners.slice(0, -1);
    const middle = start.map((_, i) => others.reduce((sum, corner) => sum + corner.x[i], 0) / others.length);
    const reflected = mix(middle, worst.x, -1);
    const tried = reflected.y < corners[0].y ? mix(middle, worst.x, -2) : mix(middle, worst.x, 0.5);
    const better = reflected.y < tried.y ? reflected : tried;
    if (better.y < worst.y) corners = [...others, better];
    else corners = corners.map((corner) => mix(corners[0].x, corner.x, 0.5));
  }
  corners.sort((a, b) => a.y - b.y);
  return corners[0].x;
}

const rounded = (value, digits) => Number(value.toPrecision(digits));
const percentOf = (logError) => {
  const percent = Math.round((Math.exp(logError) - 1) * 100);
  return `${percent > 0 ? '+' : percent < 0 ? '−' : ''}${Math.abs(percent)} %`;
};

function page(law) {
  const straightRows = STRAIGHT.map((row) => {
    const [byte, speed] = row;
    return `| ${byte} | ${speed} | ${wheelSpeed(law, byte, 0).toFixed(0)} | ${percentOf(straightError(law, row))} |`;
  });
  const circleRows = SHOWN_RADII.map((radius) => {
    const cells = SHOWN_SPEEDS.map((percent) => {
      const [inner, outer] = arcBytes(radius, percent);
      return `${(circleMm(law, radius, percent) / 10).toFixed(1)} (${percentOf(circleError(law, radius, percent))}) · ${inner}/${outer}`;
    });
    return `| ${radius} | ${cells.join(' | ')} |`;
  });
  return `# Motor law of the Maqueen Lite

*Written by \`node scripts/fit-motor-law.mjs\`; do not edit. \`src/robots/maqueen-lite/robot.test.ts\` checks that the robot uses these constants.*

With duty D = byte / 255 and V the mean speed of the wheels, a wheel settles at

    v = v0 · (D − coulomb ∓ m) / (D + viscous),   m = yawResistance · (V / v0)²

outer wheel minus, inner wheel plus. A direct-current motor driven by pulses pulls less the faster it turns (v0), loses
some of its pull to dry friction (coulomb) and some to friction that grows with speed (viscous); in curves the scrub of
tyres and castor holds the outer wheel back and pushes the inner one (yawResistance). In the world the same law acts as
forces (\`src/world/drive-law.ts\`), so pushing, stalling and walls change the speeds as they should.

| constant | value |
|---|---|
| v0 | ${law.v0} mm/s |
| coulomb | ${law.coulomb} |
| viscous | ${law.viscous} |
| yawResistance | ${law.yawResistance} |
| track | ${TRACK_MM} mm (given, not fitted) |

Fitted jointly, by least squares of the logarithms, to the straight speeds and to the circles at speed ${FITTED_SPEED} from
${FITTED_RADII[0]} to ${FITTED_RADII.at(-1)} m, which count ${CIRCLE_WEIGHT} times as much; the other circles count ${OTHER_CIRCLE_WEIGHT}.

## Straight ahead

Speeds: wheel speed polynomial in NoeSchaller/TS_Maqueen for the Maqueen Lite, times the wheel radius of 21.5 mm. Other
sources differ from it by up to 1.7 times (battery, floor).

| power byte | source mm/s | law mm/s | deviation |
|---|---|---|---|
${straightRows.join('\n')}

## Circles

What \`leftArc(radius)\` and \`rightArc(radius)\` drive. The drivers (Tiger-Jython/Robotics-Libraries mbrobot.py) were tuned on real
robots, so the radius asked for is the measurement. Each cell: radius driven in cm (deviation) · power bytes inner/outer.

| radius in m | ${SHOWN_SPEEDS.map((percent) => `speed ${percent}`).join(' | ')} |
|---|${SHOWN_SPEEDS.map(() => '---').join('|')}|
${circleRows.join('\n')}

Where the driver finds a circle too wide for the speed it chooses a higher one itself; hence the equal cells.
`;
}

const [v0, coulomb, viscous, yawResistance] = minimise(cost, START);
const law = {
  v0: rounded(v0, 3),
  coulomb: rounded(coulomb, 3),
  viscous: rounded(viscous, 3),
  yawResistance: rounded(yawResistance, 3),
};
const text = page(law);
console.log(text);
if (process.argv.includes('--check')) {
  if (readFileSync(PAGE, 'utf8') !== text) {
    console.error('docs/hardware/maqueen-lite-motor-law.md is out of date. Run: node scripts/fit-motor-law.mjs');
    process.exit(1);
  }
} else {
  writeFileSync(PAGE, text);
}
